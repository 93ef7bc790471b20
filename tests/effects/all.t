#!/bin/sh
# All effects of the library in one scene: one hash on the host and on the Cortex-M4F, and one number of instructions for
# every step, through slip and rest, impacts, limits and faults. (Memcheck watches the same scene: check/poison.sh.)
. tests/host/test.sh
. tests/host/project.sh
begin effects_all
. tests/host/bits.sh

# Every file of the library is there.
for file in models/effects/*.scene; do
    kind=$(basename "$file" .scene)
    grep -q "^effect [a-z_0-9]* $kind {" tests/effects/all.scene || echo "$kind"
done >"$out/missing"
sed 's/^/# missing: /' "$out/missing"
[ ! -s "$out/missing" ]
result $? 'the scene has all effects of the library'

# Five seconds, without optimisation on the host, which changes no bit.
length()
{
    echo 5000000000
}
for place in "host sim $CC -O0" "Cortex-M4F mps2 arm-none-eabi-gcc $(of_port mps2 PORT_OPTIMISE)"; do
    # shellcheck disable=SC2086
    variant $place
    same tests/effects/all.scene rk4
done
finish
