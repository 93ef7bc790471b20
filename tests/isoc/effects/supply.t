#!/bin/sh
# Choppers in discontinuous conduction have the current of their switchings at any step; batteries have the voltage of
# their equation, and neither give nor take more than they can.
. tests/host/test.sh
begin effects_supply
one_isoc
quick
seed=$(cat models/effects/chopper.scene models/effects/battery.scene | cksum | cut -d ' ' -f 1)
echo "# seed $seed"

# supply STEP [KIND SED]: the program at this step in us, with an effect changed so.
supply()
{
    python3 tests/isoc/effects/supply.py "$seed" "$1" "$out/scene" "$out/table.h"
    { [ -z "${2-}" ] || sed "$3" "models/effects/$2.scene"; cat "$out/scene"; } >"$out/supply.scene"
    beside_table tests/isoc/effects/supply.c "$out/supply.scene"
}
for step in 50 500 2000 5000; do
    supply $step
    joined "$step us, double" "$out/supply"
done
real float
supply 2000
joined '2000 us, float' "$out/supply"
real double
# planted KIND SED: found, at a step of 2 ms, with the effect so changed.
planted()
{
    ! sed "$2" "models/effects/$1.scene" | cmp -s - "models/effects/$1.scene" && supply 2000 "$@" && ! "$out/supply" >"$out/tap" &&
        ! grep '^not ok' "$out/tap" | grep -v "$1" >"$out/others"
    result $? "found in $1: $2"
}
planted chopper 's/back + resistance \* current/back/; s/held + resistance \* edge/held/'
planted chopper 's|(2 \* inductance)|inductance|'
planted battery 's/0.3201/0.3301/'
planted battery 's/, -most \* (1 - charge), most \* charge/, -most, most/'
planted battery 's|clamp(before / empty, 0, 1)|1|'
finish
