#!/bin/sh
# What mechanisms cost: instructions of an rk4 step in double on the host (callgrind), within what each may take; chains
# by their length, and beside plants by hand, also on the Cortex-M4F in float; the time that isoc takes.
. tests/host/test.sh
. tests/host/project.sh
begin cost
one_isoc
. tests/host/callgrind.sh

# made NAME: the plant of $out/NAME.scene; prints nothing.
made()
{
    isoc "$out/$1.summary" '' "$out/$1.scene" -o "$out/$1" --real double &&
        program "$1.run" tests/promises/handwritten/count.c "$out/$1/plant.c"
}

# within NAME MOST: its steps take at most so many instructions; sets count.
within()
{
    made "$1"
    result $? "$1 builds"
    count=$(per_step "$out/$1.run")
    result $? "$1: $count instructions on every step"
    [ "${count:-0}" -gt 0 ] && [ "$count" -le "$2" ]
    result $? "$1: at most $2"
}

for n in 2 3 8 16 32; do
    python3 tools/lab/chain.py $n planar >"$out/planar_$n.scene"
done
# Without the count of whole turns, which is exact whatever the equations cost.
sed '/^ *continuous$/d' models/four_bar.scene >"$out/four_bar.scene"
{ cat "$out/four_bar.scene" && echo 'stabilisation baumgarte'; } >"$out/fed_back_four_bar.scene"
sed 's/^step/gravity (0, 0, -9.81) m\/s^2\nstep/' models/rigid_body.scene >"$out/free_body.scene"

within planar_8 6000
eight=$count
within planar_32 40000
[ "$count" -le $((5 * eight)) ]
result $? "four times the joints: less than five times the instructions, $eight to $count"
within fed_back_four_bar 2000
# The projection has its factors from the last evaluation; feedback is in each of the four.
within four_bar $((165 + count))
! cmp -s "$out/four_bar/plant.c" "$out/fed_back_four_bar/plant.c"
result $? "and it is not the same plant"
within free_body 500
! { isoc "$out/summary" '' "$out/planar_32.scene" -o "$out/planar_32" --real double --formulation composite &&
    program composite tests/promises/handwritten/count.c "$out/planar_32/plant.c" && composite=$(per_step "$out/composite") &&
    [ "$composite" -le 40000 ]; }
result $? "control: by the mass matrix 32 joints take $composite"

# less A B: the lesser of two counts.
less()
{
    [ "$1" -gt 0 ] && [ "$2" -gt 0 ] && echo $(($1 < $2 ? $1 : $2))
}

# on_board PLANT: $value are the instructions of a step on the Cortex-M4F in float; none unless all steps cost the same.
on_board()
{
    value=
    isochron run "$1" --target cortex-m4f --out "build/chains/$1" --method rk4 --seconds 0.05 && read_value instructions_per_step
}

# at_most HOW N GENERATED COPIED CALLED: a chain of N costs at most 0.9 times what it costs by hand, its equations
# being copied into the step or called, whichever is less. Compiled as the ports do it, in the order in which both are
# written.
at_most()
{
    hand=$(less "${4:-0}" "${5:-0}") && [ "${3:-0}" -gt 0 ] && [ $((10 * $3)) -le $((9 * hand)) ]
    result $? "a planar chain of $2, $1: ${3:-?} instructions, at most 0.9 times those by hand, ${hand:-?}"
}

project
for n in 2 3; do
    sed 's/^static inline void derivative/static __attribute__((noinline)) void derivative/' tests/promises/cost/chain_$n.c >"$out/called_$n.c"
    cp "$out/planar_$n.scene" "$out/called_$n.c" "$out/project"
    EXTRA='-fno-tree-ter -frename-registers'
    made planar_$n && program by_hand tests/promises/handwritten/count.c tests/promises/cost/chain_$n.c &&
        program called tests/promises/handwritten/count.c "$out/called_$n.c"
    result $? "a planar chain of $n builds, and so by hand"
    EXTRA=
    at_most "host in double" $n "$(per_step "$out/planar_$n.run")" "$(per_step "$out/by_hand")" "$(per_step "$out/called")"
    on_board planar_$n.scene
    generated=$value
    on_board tests/promises/cost/chain_$n.c
    copied=$value
    on_board called_$n.c
    at_most "Cortex-M4F in float" $n "$generated" "$copied" "$value"
done
sed 's/com (0, -0.5, 0)/com (0.01, -0.5, 0)/' "$out/planar_2.scene" >"$out/bent_2.scene"
made bent_2 && bent=$(per_step "$out/bent_2.run") && [ "$bent" -gt "$(per_step "$out/planar_2.run")" ]
result $? "control: with rods that are bent it takes more, ${bent:-?}"

# Inertia out of the plane, and a plane askew, are no part of a planar motion.
operations()
{
    build/isoc "$1" -o "$out/counted" --real double | grep '^derivative '
}

sed 's/inertia (across, long, across)/inertia (1.2 * across, 1.1 * across, across; 0.1 * across, 0.2 * across, -0.1 * across)/' "$out/planar_3.scene" >"$out/thick.scene"
sed 's|parent ground;|parent ground rotate 40 deg about (1, 2, 3);|' "$out/planar_3.scene" >"$out/askew.scene"
plane=$(operations "$out/planar_3.scene")
[ "$(operations "$out/thick.scene")" = "$plane" ] && [ "$(operations "$out/thick.scene")" != "" ]
result $? "a chain of bodies in 3-D costs what a chain in the plane does: $plane"
askew=$(operations "$out/askew.scene") && [ "$askew" != "$plane" ]
result $? "control: in a plane askew gravity has another direction, $askew"

# milliseconds SCENE: processor time of isoc.
milliseconds()
{
    (build/isoc "$1" -o "$out/timed" >"$out/summary" && times) | tail -n 1 | tr 'ms' '  ' |
        awk 'NF == 4 { printf "%.0f\n", 1000 * (60 * ($1 + $3) + $2 + $4) }'
}

for scene in models/squeezer.scene "$out/planar_32.scene"; do
    spent=$(milliseconds "$scene")
    [ "${spent:-2000}" -lt 2000 ]
    result $? "isoc takes less than 2 s for $(basename "$scene" .scene): $spent ms"
done
finish
