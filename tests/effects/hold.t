#!/bin/sh
# Dry friction holds `static`, exactly, whatever fall and creep are.
. tests/host/test.sh
begin effects_hold
optimised -O1
seed=$(cksum <models/effects/friction.scene | cut -d ' ' -f 1)
echo "# seed $seed"
python3 tests/effects/hold.py "$seed" "$out/hold.scene" "$out/table.h"

# held SCENE: its program in the present number type.
held()
{
    build/isoc "$1" -o "$out/plant" --real "$real" >"$out/summary" 2>"$out/told" &&
        EXTRA="-I$out -DPLANT=\"$out/plant/plant.c\"" program hold tests/effects/hold.c tests/host/report.c
}
for number in double float; do
    real $number
    held "$out/hold.scene"
    joined "$number" "$out/hold"
done
real double
{ sed 's/let near = .*/let near = v * sqrt(1 \/ (v^2 + creep^2))/' models/effects/friction.scene && cat "$out/hold.scene"; } >"$out/planted.scene"
held "$out/planted.scene" && ! "$out/hold" >"$out/tap"
result $? 'found: a root for the sign of v, which holds less'
finish
