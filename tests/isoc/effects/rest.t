#!/bin/sh
# Impacts: stops, bumpers, backlash and contacts leave the rest that is written, for random masses, speeds and
# stiffnesses.
. tests/host/test.sh
begin effects_rest
one_isoc
optimised -O1
seed=$(cat models/effects/*.scene | cksum | cut -d ' ' -f 1)
echo "# seed $seed"
python3 tests/isoc/effects/rest.py "$seed" "$out/rest.scene" "$out/table.h"

for number in double float; do
    real $number
    beside_table tests/isoc/effects/rest.c "$out/rest.scene"
    joined "$number" "$out/rest"
done
# planted KIND SED: found with the effect so changed.
planted()
{
    { sed "$2" "models/effects/$1.scene" && cat "$out/rest.scene"; } >"$out/planted.scene"
    ! sed "$2" "models/effects/$1.scene" | cmp -s - "models/effects/$1.scene" && beside_table tests/isoc/effects/rest.c "$out/planted.scene" &&
        ! "$out/rest" >"$out/tap" && ! grep '^not ok' "$out/tap" | grep -v "$1\|account" >"$out/others"
    result $? "found in $1: $2"
}
real double
for kind in stop bumper backlash contact; do
    planted $kind 's/impact_damping(rest)/1.5 * (1 - rest)/'
done
planted stop 's/push = min(\(.*\), 0) - min(\(.*\), 0)$/push = \1 - (\2)/'
planted bumper 's/(push - depth)/(1.01 * push - depth)/'
finish
