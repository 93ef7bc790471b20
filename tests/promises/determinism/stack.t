#!/bin/sh
# The stack that a step takes on each target, by paint that it writes over, is at most what `isochron stack` computes of
# it.
. tests/host/test.sh
. tests/host/project.sh
. tests/host/emulators.sh
begin determinism_stack
project
turn=$(turn_of 6 "${1-}")
echo "# turn $turn of the targets"

# painted SCENE METHOD TARGET [FLAG...]: $static is what is computed, $painted what is measured.
painted()
{
    painted_on=$3
    painted_name=$(basename "$1" .scene)
    isochron stack "$1" --method "$2" --target "$3" && static=$(value stack_of_step) &&
        isochron run "$1" --method "$2" --target "$3" --seconds 0.001 || return
    compiled=build/$3/float/$painted_name/stack/plant.o
    [ -e "$out/project/$compiled" ] || compiled=build/$3/float/$painted_name/plant.o
    shift 3
    (cd "$out/project" && python3 -B tests/promises/determinism/painted.py "$compiled" "$painted_on" painted "$@") 2>"$out/errors" &&
        emulated "$painted_on" "$out/project/painted" >"$out/output" 2>"$out/errors" </dev/null &&
        painted=$(value painted | sed 's/^0*//') && [ -n "$painted" ]
}

# within: measured is at most computed, and at most 192 bytes less: that much a call and saved registers take of the
# frame which tells where the stack begins.
within()
{
    [ "$painted" -le "$static" ] && [ $((painted + 192)) -ge "$static" ]
}

number=0
for target in host cortex-m0 cortex-m3 cortex-m4f cortex-m7 cortex-m33 cortex-m55 rv32imac rv32imafc aarch64 s390x mips i386 atmega1284p; do
    number=$((number + 1))
    [ "$turn" = all ] || [ $((number % 6)) -eq "$turn" ] || continue
    # What the port's file says of a plant that does not fit.
    [ "$target" = atmega1284p ] && CFLAGS=--param=max-completely-peeled-insns=200 && export CFLAGS
    for row in double_pendulum:rk4 quadrotor:bdf4; do
        painted models/${row%:*}.scene ${row#*:} $target && within
        expect $? "$target, ${row%:*}, ${row#*:}: painted ${painted-none}, computed ${static-none}"
    done
    unset CFLAGS
done
painted models/double_pendulum.scene rk4 cortex-m4f -DDEEPER && ! within && [ "$painted" -gt "$static" ]
expect $? "found: a step that takes more than is computed, ${painted-none} for ${static-none}"
finish
