#!/bin/sh
# Dry friction holds `static`, exactly, whatever fall and creep are: 24 of them, in float and in double.
. tests/host/test.sh
begin effects_hold
one_isoc
optimised -O1
seed=$(cksum <models/effects/friction.scene | cut -d ' ' -f 1)
echo "# seed $seed"

for half in 0 1; do
    for number in float double; do
        real $number
        python3 tests/isoc/effects/hold.py "$seed" $half "$out/hold.scene" "$out/table.h"
        beside_table tests/isoc/effects/hold.c "$out/hold.scene"
        joined "$number" "$out/hold"
    done
done
real double
{ sed 's/let near = .*/let near = v * sqrt(1 \/ (v^2 + creep^2))/' models/effects/friction.scene && cat "$out/hold.scene"; } >"$out/planted.scene"
beside_table tests/isoc/effects/hold.c "$out/planted.scene" && ! "$out/hold" >"$out/tap"
result $? 'found: a root for the sign of v, which holds less'
finish
