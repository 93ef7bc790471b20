#!/bin/sh
# A kernel that is broken in one way is found by the check that is meant for it; one that is not, by none: hashes on the
# host and on the board, by gcc and by clang, memcheck with undefined states, memcheck of a run, and what a plant calls.
. tests/host/test.sh
. tests/host/project.sh
begin determinism_broken
. tests/host/bits.sh
. tests/host/poison.sh
kernel=tests/promises/determinism/broken.c
# In long steps, in which a rounding of the kernel shows soon.
method="-DISO_METHOD=ISO_RK4 -DISO_METHOD_NAME=rk4 -DISO_STEP=0.05"
kinds="NOTHING FUSED BRANCH UNINITIALISED REASSOCIATED"

# Hashes of 1000 ticks, and the program of the host under memcheck. That which calls libm has no program.
real float
for way in "gcc host gcc -O2" "clang host clang -O2" "board mps2 arm-none-eabi-gcc -O2"; do
    # shellcheck disable=SC2086
    variant $way
    for kind in $kinds; do
        # shellcheck disable=SC2086
        runs $kernel 50000000000 -DBROKEN=$kind $method
        value hash >"$out/$variant.$kind"
        [ "$variant" != gcc ] || ! [ -e "$out/program" ] || mv "$out/program" "$out/program.$kind"
    done
done

batch poisoned float
for kind in $kinds; do
    # shellcheck disable=SC2086
    add $kind $kernel -DBROKEN=$kind $method
done
watch >"$out/tap"

# Each check fails where the kernel is broken.

on_board()
{
    [ -s "$out/gcc.$1" ] && cmp -s "$out/gcc.$1" "$out/board.$1"
}

by_clang()
{
    [ -s "$out/gcc.$1" ] && cmp -s "$out/gcc.$1" "$out/clang.$1"
}

with_undefined_states()
{
    grep -q " - $1: " "$out/tap" && ! grep -q "^not ok .* - $1: " "$out/tap"
}

of_a_run()
{
    valgrind --quiet --error-exitcode=9 "$out/program.$1" 250000000 >"$out/stream" 2>"$out/errors"
}

of_calls()
{
    # shellcheck disable=SC2086
    arm-none-eabi-gcc $FLAGS $(of_port mps2 PORT_FLAGS) -DBROKEN=$1 $method -c $kernel -o "$out/called.o" &&
        ! arm-none-eabi-nm -u "$out/called.o" | grep -Ev ' mem(cpy|set|move|cmp)$'
}

while read -r kind check; do
    for sound in on_board by_clang with_undefined_states of_a_run of_calls; do
        if [ "$kind" = NOTHING ]; then
            $sound NOTHING
            result $? "a kernel that is not broken: $sound"
        elif [ "$sound" = "$check" ]; then
            ! $sound "$kind" >"$out/found" 2>&1
            result $? "found: $kind, $sound"
        fi
    done
done <<END
NOTHING none
FUSED on_board
LIBM of_calls
BRANCH with_undefined_states
UNINITIALISED of_a_run
REASSOCIATED by_clang
END
finish
