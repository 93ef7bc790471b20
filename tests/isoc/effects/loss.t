#!/bin/sh
# What an effect of the library turns into heat is never negative, and at times positive: `loss of` each use in the
# scene that has all effects, through slip, impacts and faults. The control has the sign of every loss turned about.
. tests/host/test.sh
begin effects_loss
one_isoc
real double
scene=tests/isoc/effects/all.scene

# Each use of a kind whose file says a loss that is not 0.
sed -n 's/^effect \([a-z_0-9]*\) \([a-z_]*\) {.*/\1 \2/p' $scene | while read -r use kind; do
    ! grep -q '^ *loss = ' "models/effects/$kind.scene" || grep -q '^ *loss = 0 W' "models/effects/$kind.scene" || echo "$use $kind"
done >"$out/uses"

# run NAME: ten seconds of $out/NAME.scene; the least and the largest of each loss in $out/NAME.losses.
run()
{
    isoc "$out/summary" "$out/errors" "$out/$1.scene" -o "$out/$1" --real double &&
        program "$1.run" "$out/$1/plant.c" core/runtime/loop.c core/application/*.c core/numbers/self_check.c port/host/*.c port/unix/console.c &&
        build/trace -o "$out/$1" -- "$out/$1.run" 5000000000 >"$out/summary" 2>"$out/errors" &&
        awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) name[i] = $i; next }
            { for (i = 1; i <= NF; i++) if (name[i] ~ /^loss_/) {
                if (NR == 2 || $i < least[i]) least[i] = $i
                if (NR == 2 || $i > most[i]) most[i] = $i } }
            END { for (i in least) print substr(name[i], 6), least[i], most[i] }' "$out/$1/trace.csv" >"$out/$1.losses"
}

optimised -O1
outputs=$(while read -r use _; do echo "output loss_$use = loss of $use"; done <"$out/uses")
{ cat $scene && echo "$outputs"; } >"$out/right.scene"
{
    cat "$out/right.scene"
    cut -d ' ' -f 2 "$out/uses" | sort -u | while read -r kind; do
        sed 's/^\( *\)loss = \([^#]*[^# ]\)\( *#.*\)\{0,1\}$/\1loss = -(\2)/' "models/effects/$kind.scene"
    done
} >"$out/turned.scene"
run right
result $? "$(wc -l <"$out/uses") uses run for 5 s"
run turned
result $? "and with the sign of each loss turned about"
# Rounding: where a loss is a difference of what is far larger, an epsilon of that, compared by the largest loss.
while read -r use kind; do
    awk -v use="$use" '$1 == use { good = $2 >= -1e-9 * $3 && $3 > 0 } END { exit !good }' "$out/right.losses"
    result $? "$use: the loss of $kind is never negative, $(sed -n "s/^$use //p" "$out/right.losses") W"
    awk -v use="$use" '$1 == use { bad = $2 < 0 } END { exit !bad }' "$out/turned.losses"
    result $? "found in $kind: a loss of the wrong sign"
done <"$out/uses"
finish
