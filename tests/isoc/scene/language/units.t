#!/bin/sh
# Units: every unit that isoc prints is read again as the same dimension, for 800 random dimensions, with rad as one;
# the units of the fields are printed as these write them; and units that are no multiple of SI units mean what they
# should.
. tests/host/test.sh
begin language/units
one_isoc
mkdir -p "$out/first" "$out/again"

python3 -B tests/isoc/scene/language/units.py SCENE "$out/first.scene" &&
    isoc "$out/summary" '' "$out/first.scene" -o "$out/first" &&
    python3 -B tests/isoc/scene/language/units.py AGAIN "$out/again.scene" "$out/first/plant.h"
result $? 'the units of the fields are printed as these write them'
isoc "$out/summary" '' "$out/again.scene" -o "$out/again"
result $? 'every printed unit can be added to the same dimension in base units'

# Each is 1 + 1: a printed unit is no multiple of the SI unit.
[ "$(grep -c 'R(2\.0)}' "$out/again/plant.h")" = "$(grep -c '^tunable' "$out/again.scene")" ]
result $? 'and each is one of it'
sed '/^tunable/s|\(1 [^ ]*\)$|\1*rad|' "$out/again.scene" >"$out/control.scene"
! isoc "$out/summary" "$out/errors" "$out/control.scene" -o "$out/again" && grep -q 'cannot be added' "$out/errors"
result $? 'control: with a radian more they cannot'

# What a unit is worth.
cat >"$out/worth.scene" <<'END'
step 1 ms
body b { mass 2 kg }
joint j prismatic { parent ground; child b; axis z }
tunable field = 2 mT
tunable pressure = 1.5 bar
tunable little = 3 mbar
tunable flask = 250 mL
tunable charge = 2 mAh
tunable warm = 20 degC
tunable cold = -40 degC
tunable difference = 20 degC - 15 degC
tunable warmer = 20 degC + 2 K
tunable middle = (10 + 5) degC
tunable rate = 50 1/s
tunable slope = 3 1/m^2
output place = position of j
END
sed -n 's/^    {"\([a-z]*\)", \("[^"]*"\), .* R(\(.*\))},$/\1 \3 \2/p' >"$out/told" <<END
$(build/isoc "$out/worth.scene" -o "$out/first" --real double >"$out/summary" && cat "$out/first/plant.h")
END
cat >"$out/wanted" <<'END'
j 0.0 "m"
field 0.002 "T"
pressure 1.5e+05 "Pa"
little 300.0 "Pa"
flask 0.00025 "m^3"
charge 7.2 "A*s"
warm 293.15 "K"
cold 233.15 "K"
difference 5.0 "K"
warmer 295.15 "K"
middle 288.15 "K"
rate 50.0 "Hz"
slope 3.0 "1/m^2"
place 0.0 "m"
END
cmp "$out/told" "$out/wanted"
result $? 'T, bar, L, Ah, degC and 1/s are worth what they should be'
finish
