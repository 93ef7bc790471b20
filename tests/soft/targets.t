#!/bin/sh
# Other cores than the Cortex-M4F, also without a floating-point unit: the bits of the host, and one number of instructions for
# every step; with libgcc's helpers in place of port/soft the bits are the same, and the number follows from the state.
. tests/host/test.sh
. tests/host/project.sh
begin soft_targets
project

# ran SCENE TARGET SECONDS: make run.
ran()
{
    call run SCENE="models/$1.scene" TARGET="$2" SECONDS="$3"
}

# two numbers of instructions or more, or one that is no whole number.
varies()
{
    count=$(value instructions_per_step)
    case $count in
    '' | *[!0-9]*) [ -n "$count" ] ;;
    *) false ;;
    esac
}

targets="cortex-m7 cortex-m3 cortex-m0 rv32imafc rv32imac"
while read -r scene seconds; do
    ran "$scene" host "$seconds" && hash=$(value hash)
    expect $? "$scene on the host: $hash"
    for target in $targets; do
        ran "$scene" $target "$seconds" && [ "$(value hash)" = "$hash" ]
        expect $? "$scene on the $target: the same bits"
        ! varies && [ -n "$(value instructions_per_step)" ]
        expect $? "$scene on the $target: $(value instructions_per_step) instructions on every step"
    done
done <<END
double_pendulum 2
cart_pole_drive 2
END

# What libgcc takes, from the least to the most.
hash=
for target in cortex-m3 cortex-m0 rv32imac; do
    sed -i 's/ port\/soft\/[a-z]*\.c//g' "$out/project/port/${target#cortex-}/port.mk"
    ran double_pendulum host 2 && hash=$(value hash) && ran double_pendulum $target 2 && [ "$(value hash)" = "$hash" ] && varies
    expect $? "found: helpers of libgcc on the $target: $(value instructions_per_step) instructions, mean $(value execution)"
done
finish
