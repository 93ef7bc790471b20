#!/bin/sh
# One hash per scene and method, on the host and on the Cortex-M4F, where every step also takes the same number of instructions:
# some steps of the models that are not tried in depth (same_bits.sh). On the host without optimisation, which changes no
# bit (same_bits_compilers.sh) and compiles in a fraction of the time. Of the methods that share a kernel a model is tried
# with one, by turns.
. tests/host/test.sh
. tests/host/project.sh
begin check/same_bits_brief
. tests/host/bits.sh

for place in "host sim $CC -O0" "Cortex-M4F mps2 arm-none-eabi-gcc $(of_port mps2 PORT_OPTIMISE)"; do
    # shellcheck disable=SC2086
    variant $place
    result $? "$variant: core and port compile"
    for method in $METHODS; do
        for scene in $(models "$method"); do
            in_depth "$scene" || ! has_turn "$scene" "$method" || same "$scene" "$method"
        done
    done
done
finish
