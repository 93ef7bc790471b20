#!/bin/sh
# The cost of each effect of a scene, and its influence, on a target: the scene is built and run with all of them,
# without each, and without any. Called by `make cost SCENE=...`, with the make to call in $MAKE, and SCENE, NAME,
# TARGET and REAL in the environment; the other variables of make run go from make to make. All stands in $FOLDER.
WHAT="make cost"
. tools/measure/board.sh
work=$FOLDER/$TARGET-$REAL
counts=$work/counts

# built PLACE NAME KIND [EFFECT; ...]: the scene without these, built and run in $work/PLACE; the output is in measured
# there. A run that the guard stops has a trace up to there. The counts have a line of this name and kind.
built()
{
    dir=$work/$1
    folders "$dir"
    [ ! -e "$dir/trace.csv" ] || rm -f "$dir/trace.csv"
    make_alone "$TARGET/$REAL" "$dir" run WITHOUT="${4-}" >"$dir/measured" 2>"$dir/said" </dev/null ||
        grep -q '^trace: guard' "$dir/said" || refuse "${4-}"
    make_alone "$TARGET/$REAL" "$dir" size WITHOUT="${4-}" >>"$dir/measured" 2>>"$dir/said" </dev/null || refuse "${4-}"
    counted "$2" "$3"
}

refuse()
{
    cat "$dir/said" >&2
    fail "$SCENE${1:+ without $1} cannot be measured; see $dir/measured and $dir/said"
}

# in_tick FUNCTION: $collected are the instructions of it in one tick on the host.
in_tick()
{
    collected "$dir/counted" "$1" "$dir/$NAME" 1 || fail "no count of $1 in $dir/$NAME"
}

# counted NAME KIND: a line of the counts, from the last build.
counted()
{
    case $TARGET in
    host)
        in_tick step && of_step=$collected
        in_tick "iso_loop_tick_$REAL" && of_tick=$collected
        ;;
    *)
        get instructions_per_step && of_step=$instructions_per_step && tick && of_tick=$tick || exit 1
        ;;
    esac
    get text data_bss
    awk -v name="$1" -v kind="$2" -v rest="$of_step $of_tick $text $data_bss" '
        $1 == "step" && $2 == "add" { operations = $3 " " $5 " " $7 " " $9 }
        $1 == "states" || $1 == "memories" { number[$1] = $2 }
        END {
            if (operations == "") exit 1
            print name, kind, operations, rest, number["states"] + 0, number["memories"] + 0
        }' "$dir/plant.txt" >>"$counts" || fail "$dir/plant.txt has not one line of operations of a step"
}

mkdir -p "$work"
build/isoc "$SCENE" --effects >"$work/effects" || exit 1
[ -s "$work/effects" ] ||
    fail "$SCENE has no effect (effect NAME KIND { ... }); make cost without SCENE prints the tables of all models"
: >"$counts"
while read -r effect kind; do
    built "without-$effect" "$effect" "$kind" "$effect"
done <"$work/effects"
built base . base "$(cut -d ' ' -f 1 "$work/effects" | paste -sd ';')"
built whole . whole
compute price -v folder="$work" -v table="$FOLDER/effects.tsv" "$counts" || exit 1
echo
echo "$FOLDER/effects.tsv"
sh tools/plot/draw.sh "$FOLDER/effects.gnuplot" effects "$NAME" "$TARGET" "$FOLDER/effects.tsv" ||
    fail "gnuplot does not draw $FOLDER/effects.gnuplot"
