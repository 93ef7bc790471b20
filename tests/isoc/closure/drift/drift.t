#!/bin/sh
# Closed loops over 600,000 steps in float: with every stabilisation the violation stays within the bound that
# tools/measure/drift.c derives from what rounding may do in a step; without any it drifts. A stabilisation that is too
# weak is seen. One of two models each time.
. tests/host/test.sh
begin drift/drift
turn=$(turn_of 2 "${1-}" core tools/isoc tools/measure models)
echo "# turn $turn of the models"
COMPILE="$CC $FLAGS -D_POSIX_C_SOURCE=200809L"
STEP=
. tools/measure/stabilised.sh

# get NAME KEY
get()
{
    awk -v key="$2" '$1 == key { print $2; n++ } END { exit n != 1 }' "$dir/$1.measured"
}

# holds NAME SECONDS: whether it ran to the end within the bound.
holds()
{
    awk -v end="$(get "$1" end)" -v seconds="$2" -v violation="$(get "$1" violation)" -v bound="$(get "$1" bound)" \
        'BEGIN { exit !(end == seconds && violation > 0 && bound > 0 && violation <= bound) }'
}

# drifts MODEL SECONDS
drifts()
{
    next_turn 2 || return 0
    SCENE=models/$1.scene
    dir=$out/$1
    mkdir -p "$dir"
    for stabilisation in baumgarte projection lagrangian; do
        measure $stabilisation "$2" 1 && holds $stabilisation "$2"
        result $? "$1, $stabilisation: after $2 s at most $(get $stabilisation violation) m open, bound $(get $stabilisation bound)"
    done
    measure none "$2" 1 && awk -v end="$(get none end)" -v seconds="$2" -v violation="$(get none violation)" \
        -v bound="$(get baumgarte bound)" 'BEGIN { exit !(end < seconds || violation > 1000 * bound) }'
    result $? "control: $1, none: $(get none violation) m open after $(get none end) s"
    measure baumgarte-weak "$2" 1 "baumgarte { alpha 1 Hz; beta 1 Hz }" && ! holds baumgarte-weak "$2"
    result $? "control: $1, baumgarte with 1 Hz in place of 0.1 / h: $(get baumgarte-weak violation) m open"
}

drifts four_bar 600
drifts slider_crank 60
finish
