#!/bin/sh
# Other cores than the Cortex-M4F, also without a floating-point unit: the bits of the host, and one number of instructions, or
# of cycles, for every step; with libgcc's helpers in place of port/soft the bits are the same, and the number follows from
# the state.
. tests/host/test.sh
. tests/host/project.sh
begin soft_targets
project

# ran SCENE TARGET SECONDS: make run.
ran()
{
    call run SCENE="models/$1.scene" TARGET="$2" SECONDS="$3"
}

# counted: in the last run the shortest step took as long as the longest. $least, $mean and $most are these.
counted()
{
    # shellcheck disable=SC2046
    set -- $(value execution)
    least=${1-none} mean=${2-} most=${3-} unit=${4-}
    [ "$least" = "$most" ]
}

while read -r target seconds; do
    for scene in double_pendulum cart_pole_drive; do
        ran $scene host "$seconds" && hash=$(value hash) && [ -n "$hash" ]
        expect $? "$scene on the host: $hash"
        ran $scene "$target" "$seconds" && [ "$(value hash)" = "$hash" ]
        expect $? "$scene on the $target: the same bits"
        counted
        expect $? "$scene on the $target: $least $unit on every step"
    done
done <<END
cortex-m7 2
cortex-m33 2
cortex-m3 2
cortex-m0 2
rv32imafc 2
rv32imac 2
atmega1284p 0.02
END

while read -r target seconds; do
    sed -i 's/ port\/soft\/[a-z]*\.c//g' "$out/project/port/${target#cortex-}/port.mk"
    ran double_pendulum host "$seconds" && hash=$(value hash) && ran double_pendulum "$target" "$seconds" &&
        [ "$(value hash)" = "$hash" ] && ! counted && [ -n "$unit" ]
    expect $? "found: helpers of libgcc on the $target: from $least to $most $unit, mean $mean"
done <<END
cortex-m3 2
cortex-m0 2
rv32imac 2
atmega1284p 0.02
END
finish
