#!/bin/sh
# One hash per scene and method on the host, at any optimisation and with either compiler: models that are tried in depth with
# rk4, one of them with every kernel, and a plant by hand with every method.
. tests/host/test.sh
. tests/host/project.sh
begin check/same_bits_compilers
. tests/host/bits.sh

for way in "host sim $CC -O2" "unoptimised sim $CC -O0" "clang sim clang -O2"; do
    # shellcheck disable=SC2086
    variant $way
    result $? "$variant: core and port compile"
    for method in $METHODS; do
        for scene in $(models "$method") models/oscillator.c; do
            case $method,$scene in
            *,models/oscillator.c) same "$scene" "$method" ;;
            rk4,*) ! in_depth "$scene" || same "$scene" "$method" ;;
            *,models/tree.scene) ! has_turn "$scene" "$method" || same "$scene" "$method" ;;
            esac
        done
    done
done

# A variant with other bits is found: constants and products in the precision of long double.
variant wide sim "$CC" -O0 -mfpmath=387
model models/double_pendulum.scene rk4 2>/dev/null && [ "$(value hash)" != "$(cat "$out/hash/double_pendulum-rk4")" ] ||
    grep -q "float is computed in long double" "$out/errors"
expect $? "found: x87 has other bits, or is refused"
finish
