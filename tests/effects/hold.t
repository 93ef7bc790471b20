#!/bin/sh
# Dry friction holds `static`, exactly, whatever fall and creep are: half of 24 in double, the others in float, and by turns in
# the other one.
. tests/host/test.sh
begin effects_hold
one_isoc
optimised -O1
seed=$(cksum <models/effects/friction.scene | cut -d ' ' -f 1)
echo "# seed $seed"
turn=$(turn_of 2 "${1-}" core models/effects tests/effects)
echo "# turn $turn of the halves"

for half in 0 1; do
    for number in float double; do
        next_turn 2 || continue
        real $number
        python3 tests/effects/hold.py "$seed" $half "$out/hold.scene" "$out/table.h"
        beside_table tests/effects/hold.c "$out/hold.scene"
        joined "$number" "$out/hold"
    done
    turns_so_far=$((turns_so_far + 1))
done
real double
{ sed 's/let near = .*/let near = v * sqrt(1 \/ (v^2 + creep^2))/' models/effects/friction.scene && cat "$out/hold.scene"; } >"$out/planted.scene"
beside_table tests/effects/hold.c "$out/planted.scene" && ! "$out/hold" >"$out/tap"
result $? 'found: a root for the sign of v, which holds less'
finish
