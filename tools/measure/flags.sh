#!/bin/sh
# The cost of a step with each optimisation of the compiler, as a Markdown table: rk4 and bdf4 of each model. On the
# Cortex-M4F instructions, by the trace of QEMU, and the cycles that they mean at most (tools/measure/cycles); on the
# host instructions, by callgrind. The last row has the geometric means relative to -O2. PORT_OPTIMISE of
# port/TARGET/port.mk is chosen from it, on the Cortex-M4F by cycles: -O2, or the least of those that take a twentieth
# less over all models.
#
# Called by `make flags`, with the target and its real in $TARGET and $REAL, the compiler with all flags in $COMPILE,
# the link in $LINK, the shared files of the port in $SHARED, the command that runs build/flags/program for one tick in
# $EXEC, and the scenes in $MODELS.
WHAT="make flags"
. tools/measure/common.sh
dir=build/flags
levels='-O1 -O2 -Os -O3'
case $TARGET in
cortex-m4f) port=mps2 && columns=2 ;;
*) port=host && columns=1 ;;
esac

# cost LEVEL: $cost is that of the plant in $dir: instructions, and cycles where they are known.
cost()
{
    cost=
    : >"$dir/counted"
    $COMPILE "$1" -c "$dir/plant.c" -o "$dir/plant.o" && $LINK "$dir"/objects/*.o "$dir/plant.o" -o "$dir/program" || return
    case $TARGET in
    cortex-m4f)
        arm-none-eabi-objdump -d "$dir/program" >"$dir/listing" &&
            $EXEC -singlestep -d nochain,exec 2>&1 >/dev/null |
            build/cycles count tools/measure/cycles/cores/cortex-m4f.txt "$dir/listing" step >"$dir/counted"
        while read -r _ number; do
            cost="$cost $number"
        done <"$dir/counted"
        ;;
    *)
        # shellcheck disable=SC2086
        collected "$dir/counted" step $EXEC && cost=" $collected"
        ;;
    esac
}

mkdir -p "$dir/objects" && rm -f "$dir"/objects/*
objects=0
for source in core/numbers/*.c core/runtime/*.c core/application/*.c port/$port/*.c $SHARED; do
    $COMPILE -c "$source" -o "$dir/objects/$((objects += 1)).o" || fail "$source is not compiled"
done
for method in rk4 bdf4; do
    for scene in $MODELS; do
        # Not every scene can be run by every method.
        build/isoc "$scene" -o "$dir" --method $method --real "$REAL" >"$dir/plant.txt" 2>"$dir/errors" || continue
        cells=
        for level in $levels; do
            cost $level
            cells="$cells$cost"
        done
        name=${scene##*/}
        echo "${name%.scene},$method$cells"
    done
done >"$dir/rows"
awk -v title="$TARGET, $REAL" -v levels="$levels" -v columns=$columns '
    BEGIN {
        count = split(levels, level, " ")
        head = "| " title
        line = "|---"
        for (i = 1; i <= count; i++)
            for (j = 1; j <= columns; j++) {
                head = head " | " level[i] (j == 2 ? ", cycles" : "")
                line = line "|--:"
            }
        print head " |\n" line "|"
    }
    NF != 1 + count * columns {
        print "make flags: no count of " $1 > "/dev/stderr"
        failed = 1
        next
    }
    {
        text = "| " $1
        for (i = 2; i <= NF; i++) {
            text = text " | " $i
            sum[i] += log($i / $(2 + columns + (i - 2) % columns))
        }
        sub(/,/, ", ", text)
        print text " |"
        n++
    }
    END {
        text = "| relative to -O2"
        for (i = 2; n && i <= 1 + count * columns; i++) text = text sprintf(" | %.3f", exp(sum[i] / n))
        print text " |"
        exit failed || !n
    }' "$dir/rows"
