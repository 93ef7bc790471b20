#!/bin/sh
# One hash per scene and method, whatever compiles the plant and wherever it runs. On the Cortex-M4F every step also
# takes the same number of instructions. What is not always tried is tried by turns, all with the argument `all`:
#
#     plants                     methods                                    on the host -O0, Cortex-M4F   on the host -O2, by clang, by tcc
#     oscillator                 all                                        always                        always
#     tree                       all                                        always                        one of those that share a kernel
#     others tried in depth      rk4                                        always                        always
#     all others                 of those that share a kernel one,          one-step methods half,        -
#                                rk4 where no other is tried                the others a twentieth
. tests/host/test.sh
. tests/host/project.sh
begin check/same_bits
one_isoc
. tests/host/bits.sh
turn=$(turn_of 20 "${1-}")
echo "# turn $turn of the models and methods"

# wanted SCENE METHOD: in the variant of now.
wanted()
{
    case $variant,$2,$1 in
    *,models/oscillator.c) ;;
    host,*,models/tree.scene | Cortex-M4F,*,models/tree.scene) ;;
    host,rk4,* | Cortex-M4F,rk4,*) { in_depth "$1" || has_turn "$1" "$2"; } && due "$1" "$2" ;;
    host,* | Cortex-M4F,*) has_turn "$1" "$2" && due "$1" "$2" ;;
    *,rk4,*) in_depth "$1" ;;
    *,models/tree.scene) has_turn "$1" "$2" ;;
    *) return 1 ;;
    esac
}
everywhere

# The motor's bench is for 10 kHz.
for most in 'euler 200' 'rk4 450'; do
    model models/dc_motor_bench.scene "${most% *}" && read_value instructions_per_step && [ "$value" -le "${most#* }" ]
    expect $? "dc_motor_bench, ${most% *}: $value instructions of a step, at most ${most#* }"
done

# Fourteen are always tried, of methods that differ by more than rounding: a second correction may change no bit of a
# float.
count=0
hashes=' '
differ=0
for file in "$out"/hash/*-euler "$out"/hash/*-heun "$out"/hash/*-rk4 "$out"/hash/*-ab4; do
    name=${file##*/}
    [ "${name%-*}" = oscillator ] || in_depth "${name%-*}" || continue
    count=$((count + 1))
    read -r hash <"$file"
    case $hashes in
    *" $hash "*) differ=1 ;;
    esac
    hashes="$hashes$hash "
done
[ $count -ge 14 ] && [ $differ -eq 0 ]
result $? "the hash tells models and methods apart"

# What make runs is no other program.
project
read -r known_hash <"$out/hash/double_pendulum-rk4"
for target in host cortex-m4f; do
    isochron run models/double_pendulum.scene --method rk4 --target $target && read_value hash && [ "$value" = "$known_hash" ]
    expect $? "isochron run models/double_pendulum.scene --target $target has the same hash"
done

# In the plant alone; the self-check of core refuses a program that is built so as a whole.
variant fused mps2 arm-none-eabi-gcc -O2
bare_numbers
compiler="${compiler%% *} -I$out/bare ${compiler#* } -ffp-contract=fast"
model models/double_pendulum.scene rk4 && read_value hash && [ "$value" != "$known_hash" ]
expect $? "found: fused multiply-add has other bits"
variant looping mps2 arm-none-eabi-gcc -O2
runs tests/promises/planted_plant.c 10000000000 -DPLANTED=LOOP -DISO_METHOD=ISO_RK4 -DISO_METHOD_NAME=rk4 &&
    read_value instructions_per_step && ! is_number "$value"
expect $? "found: a loop count from the state has no single number of instructions"
# Constants and products in the precision of long double.
variant wide host "$CC" -O0 -mfpmath=387
model models/double_pendulum.scene rk4 2>/dev/null && read_value hash && [ "$value" != "$known_hash" ] ||
    grep -q "float is computed in long double" "$out/errors"
expect $? "found: x87 has other bits, or is refused"
finish
