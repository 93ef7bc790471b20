#!/bin/sh
# One hash per scene and method, on the host and on the Cortex-M4F, where every step also takes the same number of instructions:
# some steps of the models that are not tried in depth (same_bits.sh). On the host without optimisation, which changes no
# bit (same_bits_compilers.sh) and compiles in a fraction of the time. Of the methods that share a kernel a model is tried
# with one; with those that are not one-step methods from a table, by turns: all with the argument `all`.
. tests/host/test.sh
. tests/host/project.sh
begin check/same_bits_brief
. tests/host/bits.sh
turn=$(turn_of 5 "${1-}" core tools/isoc models)
echo "# turn $turn of the models and methods"

# wanted SCENE METHOD
wanted()
{
    [ "$1" != models/oscillator.c ] && ! in_depth "$1" && has_turn "$1" "$2" && fifth "$1" "$2"
}
everywhere

# The motor's bench is for 10 kHz.
for most in 'euler 200' 'rk4 450'; do
    model models/dc_motor_bench.scene "${most% *}" && [ "$(value instructions_per_step)" -le "${most#* }" ]
    expect $? "dc_motor_bench, ${most% *}: $(value instructions_per_step) instructions of a step, at most ${most#* }"
done
finish
