#!/bin/sh
# One hash per scene and method, on the host and on the Cortex-M4F, where every step also takes the same number of instructions:
# the models that are tried in depth. The others: same_bits_brief.sh; other compilers, and the host with optimisation, which
# changes no bit and compiles for longer: same_bits_compilers.sh. Three plants are tried with every method, the others with
# rk4, with one of those that share a kernel, and by turns with those that are not one-step methods from a table: with
# all with the argument `all`.
. tests/host/test.sh
. tests/host/project.sh
begin check/same_bits
. tests/host/bits.sh
turn=$(turn_of 5 "${1-}" core tools/isoc models)
echo "# turn $turn of the models and methods"

# wanted SCENE METHOD
wanted()
{
    case $1 in
    models/oscillator.c | models/tree.scene | models/double_pendulum.scene) ;;
    *) in_depth "$1" && { [ "$2" = rk4 ] || has_turn "$1" "$2"; } && fifth "$1" "$2" ;;
    esac
}
everywhere

# Of methods that differ by more than rounding: a second correction may change no bit of a float.
told=$(ls "$out"/hash/*-euler "$out"/hash/*-heun "$out"/hash/*-rk4 "$out"/hash/*-ab4)
# shellcheck disable=SC2086
[ "$(echo "$told" | wc -l)" -ge 21 ] && [ "$(cat $told | sort -u | wc -l)" -eq "$(echo "$told" | wc -l)" ]
result $? "the hash tells models and methods apart"

# What make runs is no other program.
project
for target in host cortex-m4f; do
    call run METHOD=rk4 TARGET=$target && [ "$(value hash)" = "$(cat "$out/hash/double_pendulum-rk4")" ]
    expect $? "make run TARGET=$target has the same hash"
done

# In the plant alone; the self-check of core refuses a program that is built so as a whole.
variant fused mps2 arm-none-eabi-gcc -O2
bare_numbers
compiler="${compiler%% *} -I$out/bare ${compiler#* } -ffp-contract=fast"
model models/double_pendulum.scene rk4 && [ "$(value hash)" != "$(cat "$out/hash/double_pendulum-rk4")" ]
expect $? "found: fused multiply-add has other bits"
variant looping mps2 arm-none-eabi-gcc -O2
runs tests/check/planted_plant.c 10000000000 -DPLANTED=LOOP -DISO_METHOD=ISO_RK4 -DISO_METHOD_NAME=rk4 &&
    ! value instructions_per_step | grep -Eqx '[0-9]+'
expect $? "found: a loop count from the state has no single number of instructions"
finish
