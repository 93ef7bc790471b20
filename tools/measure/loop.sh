#!/bin/sh
# One method in a loop, whose ticks are the scene's step: $dir/double-METHOD/loop, its errors with one step a tick and the fewest
# steps from which on the error stays at most $error, 0 if they are shorter than 1 us: with held inputs against the staircase,
# with as many steps in every tick; with smooth ones, sampled at every step, against the continuous signal. And
# $dir/smooth_float-METHOD/instructions, those of a step on the Cortex-M4F.
#
#     loop.sh double METHOD
. tools/measure/methods.sh
(variable smooth "$2") || fail "$2 with smooth inputs cannot be built for $SCENE"
mkdir -p "$dir/smooth_float-$2"
{
    build/accuracy fewest "$(looped double "$2" held)" "$time" "$coarsest" "$error" "$dir/restarted.txt" || exit 255
    if [ -s "$dir/smooth.txt" ]; then
        build/accuracy fewest "$(looped smooth "$2" smooth)" "$time" "$coarsest" "$error" "$dir/smooth.txt" || exit 255
    else
        echo '- - 0 -'
    fi
} >"$dir/double-$2/loop"
instructions_m4f smooth_float "$2" >"$dir/smooth_float-$2/instructions" || exit 255
progress "$@"
