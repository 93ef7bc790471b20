#!/bin/sh
# All effects of the library in one scene: one hash on the host and on the Cortex-M4F, and one number of instructions
# for every step, through slip and rest, impacts, limits and faults. (Memcheck watches the same scene:
# promises/poison.t.) Five seconds; once in eight turns, or with the argument `all`, a minute.
. tests/host/test.sh
. tests/host/project.sh
begin effects_all
. tests/host/bits.sh

# Every file of the library is there.
for file in models/effects/*.scene; do
    kind=$(basename "$file" .scene)
    grep -q "^effect [a-z_0-9]* $kind {" tests/isoc/effects/all.scene || echo "$kind"
done >"$out/missing"
sed 's/^/# missing: /' "$out/missing"
[ ! -s "$out/missing" ]
result $? 'the scene has all effects of the library'

# Without optimisation on the host, which changes no bit.
turn=$(turn_of 8 "${1-}" core models/effects tools/isoc tests/isoc/effects)
case $turn in
all | 0) seconds=60 ;;
*) seconds=5 ;;
esac
echo "# turn $turn of 8: $seconds s"
length()
{
    length=${seconds}000000000
}
for place in "host host $CC -O0" "Cortex-M4F mps2 arm-none-eabi-gcc $(of_port mps2 PORT_OPTIMISE)"; do
    # shellcheck disable=SC2086
    variant $place
    same tests/isoc/effects/all.scene rk4
    [ "$(value ticks)" = ${seconds}000 ]
    expect $? "$variant: it runs to the end, $(value ticks) ticks"
done
finish
