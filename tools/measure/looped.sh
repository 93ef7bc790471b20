#!/bin/sh
# One method in a loop in double: $dir/double-METHOD/looped-held and looped-smooth, each with a line for six steps as points.sh
# has it, of the kind `held` or `smooth`. The longest step of held inputs is the tick; of smooth ones, four times that.
#
#     looped.sh double METHOD
. tools/measure/methods.sh
# lines KIND OF MODE FIRST: FIRST steps and their doubles, by the program of the kind OF in a mode of drive.c.
lines()
{
    cost=$(instructions_host "$2" "$method") || exit 255
    "$(looped "$2" "$method" "$3")" "$time" "$4" $((2 * $4)) $((4 * $4)) $((8 * $4)) $((16 * $4)) $((32 * $4)) |
        sed "s/^/$1 $method $cost - /"
}

method=$2
ticks=$((4 * coarsest))
lines held double held "$ticks" >"$dir/double-$method/looped-held"
: >"$dir/double-$method/looped-smooth"
if [ -s "$dir/smooth.txt" ]; then
    (variable smooth "$method") || fail "$method with smooth inputs cannot be built for $SCENE"
    lines smooth smooth smooth "$coarsest" >"$dir/double-$method/looped-smooth"
fi
progress "$@"
