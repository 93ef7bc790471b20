#!/bin/sh
# One hash per scene and method: on the host at any optimisation and with either compiler, and on the Cortex-M4F, where
# every step also takes the same number of instructions.
. tests/host/test.sh
. tests/host/project.sh
begin check/same_bits
project

# run ARGUMENT...: one second.
run()
{
    call run SECONDS=1 "$@"
}

# differs NAME ARGUMENT...: the hash must be $hash again.
same()
{
    name=$1
    shift
    run "$@" && [ "$(value hash)" = "$hash" ]
    expect $? "$plant, $method: $name"
}

for scene in models/*.scene models/oscillator.c; do
    plant=$(basename "$scene" | sed 's/\..*//')
    for method in euler heun rk4 ab4; do
        run SCENE="$scene" METHOD=$method && value hash | grep -Eqx '[0-9a-f]{16}'
        expect $? "$plant, $method: runs on the host"
        hash=$(value hash)
        same "the same bits on the Cortex-M4F" SCENE="$scene" METHOD=$method TARGET=cortex-m4f
        value instructions_per_step | grep -Eqx '[0-9]+'
        expect $? "$plant, $method: $(value instructions_per_step) instructions, on every step"
        same "the same bits without optimisation" SCENE="$scene" METHOD=$method CFLAGS=-O0
        same "the same bits from clang" SCENE="$scene" METHOD=$method CC=clang
    done
done

run SCENE=models/pendulum.scene METHOD=heun
hash=$(value hash)
run SCENE=models/pendulum.scene METHOD=rk4 && [ "$(value hash)" != "$hash" ]
expect $? "the hash tells two methods apart"
finish
