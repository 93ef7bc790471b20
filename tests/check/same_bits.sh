#!/bin/sh
# One hash per scene and method: on the host at any optimisation and with either compiler, and on the Cortex-M4F, where
# every step also takes the same number of instructions.
. tests/host/test.sh
. tests/host/project.sh
begin check/same_bits
project
mkdir -p "$out/hash"

METHODS=$(build/isoc --methods | sed -n 's/^| \([a-z0-9_]*\) | [0-9].*/\1/p')

# run ARGUMENT...: ten seconds of rk4, one of the other methods, in the steps of the scene; but for PEC, which is not stable
# there on a model with much damping; and less of a model that is not tried in depth.
run()
{
    case $method$depth in
    *brief) call run SECONDS=0.01 "$@" ;;
    rk4) call run SECONDS=10 "$@" ;;
    abm4_pec) call run SECONDS=0.5 STEP=500us "$@" ;;
    *) call run SECONDS=1 "$@" ;;
    esac
}

# counted: every step took one number of instructions, unless one lasts longer than a tick, whose interrupt counts; with
# adams, whose sub-steps the budget bounds, two that say from what to what.
counted()
{
    case $method in
    adams) value instructions_per_step | grep -Eqx '[0-9]+( [0-9]+)?' ;;
    *) value margin | grep -q '^-' || value instructions_per_step | grep -Eqx '[0-9]+' ;;
    esac
}

# each NAME WHAT ARGUMENT...: runs models with methods; the hash must be that of the first time. WHAT is `all`, every
# model with every method; or `cross`, those tried in depth with rk4, and two plants with every method.
each()
{
    name=$1
    what=$2
    shift 2
    for method in $METHODS; do
        for scene in $(models "$method") models/oscillator.c; do
            plant=$(basename "$scene" | sed 's/\..*//')
            depth=
            [ "$plant" = oscillator ] || in_depth "$scene" || depth=brief
            case $what$depth,$method,$plant in
            all* | cross,rk4,* | cross,*,tree | cross,*,oscillator) ;;
            *) continue ;;
            esac
            # Only a generated plant has adams.
            [ "$plant $method" != "oscillator adams" ] || continue
            run SCENE="$scene" METHOD=$method "$@" && value hash | grep -Eqx '[0-9a-f]{16}'
            status=$?
            known=$out/hash/$plant-$method
            [ -f "$known" ] || value hash >"$known"
            [ $status -eq 0 ] && [ "$(value hash)" = "$(cat "$known")" ]
            expect $? "$plant, $method: $name, $(value hash)"
            if [ "$name" = "Cortex-M4F" ]; then
                counted
                expect $? "$plant, $method: $(value instructions_per_step) instructions on every step"
            fi
        done
    done
}

each "host" all
each "Cortex-M4F" all TARGET=cortex-m4f
each "without optimisation" cross PORT_FLAGS=-O0
each "clang" cross PORT_CC=clang

method=rk4
depth=
# Of methods that differ by more than rounding: a second correction may change no bit of a float.
told=$(ls "$out"/hash/*-euler "$out"/hash/*-heun "$out"/hash/*-rk4 "$out"/hash/*-ab4)
# shellcheck disable=SC2086
[ "$(echo "$told" | wc -l)" -ge 32 ] && [ "$(cat $told | sort -u | wc -l)" -eq "$(echo "$told" | wc -l)" ]
result $? "the hash tells models and methods apart"
run TARGET=cortex-m4f CFLAGS=-ffp-contract=fast && [ "$(value hash)" != "$(cat "$out/hash/double_pendulum-rk4")" ]
expect $? "found: fused multiply-add has other bits"
run SCENE=tests/check/planted_plant.c TARGET=cortex-m4f PORT_CC="arm-none-eabi-gcc -DPLANTED=LOOP" &&
    ! value instructions_per_step | grep -Eqx '[0-9]+'
expect $? "found: a loop count from the state has no single number of instructions"
finish
