#!/bin/sh
# The machines with effects, models/, against closed forms and balances.
. tests/host/test.sh
begin effects_models
one_isoc
real double
# The runs are short, and -O0 changes no bit.
quick

# machine FOLDER NAME: the plant of FOLDER/NAME.scene, without a word from isoc.
machine()
{
    isoc "$out/$2.summary" "$out/$2.told" "$1/$2.scene" -o "$out" --name "$2" --real double && [ ! -s "$out/$2.told" ]
    result $? "isoc has nothing to say to $1/$2.scene"
    plants="$plants $out/$2.c"
}
EXTRA="-I$out"

plants=
for name in arm_drive balancer cart_pole_drive crane dc_motor_bench hopper quadrotor_sih quarter_car; do
    machine models $name
done
# shellcheck disable=SC2086
program models tests/isoc/effects/models.c tests/host/report.c $plants
joined models "$out/models"

# The same of machines with something changed in each: every one of them is found.
cp models/arm6.scene "$out"
mkdir -p "$out/parts"
sed 's/2 Ohm/2.1 Ohm/' models/parts/cart_pole.scene >"$out/parts/cart_pole.scene" # what cart_pole_drive includes
plants=
for changed in arm_drive:'2e-4 kg/2.1e-4 kg' balancer:'of 1.2 kg/of 1.3 kg' cart_pole_drive:'^# The cart/# Changed: the cart' \
    crane:'of 250 kg/of 251 kg' dc_motor_bench:'50 mN/51 mN' hopper:'-9.81/-9.82' quadrotor_sih:'= 8 uN/= 8.1 uN' \
    quarter_car:'-9.81/-9.82'; do
    sed "s/${changed#*:}/" "models/${changed%%:*}.scene" >"$out/${changed%%:*}.scene"
    machine "$out" "${changed%%:*}"
done
# shellcheck disable=SC2086
program planted tests/isoc/effects/models.c tests/host/report.c $plants
"$out/planted" >"$out/tap"
[ "$(awk '/ runs for ten seconds$/ { n++ } /^not ok/ { found[n] = 1 } END { print length(found) }' "$out/tap")" -eq 8 ]
result $? "found: a change in each of them"
finish
