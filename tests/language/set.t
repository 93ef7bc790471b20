#!/bin/sh
# --set gives a constant or a tunable another value of its own unit. Any other unit is an error where the option has it, not
# where the scene uses the name: each unit against each.
. tests/host/test.sh
begin language_set

UNITS='kg m s rad A K N/m N*m kg*m^2 V 1/s'
{
    echo 'step 1 ms
body b { mass 1 kg }
joint j prismatic { parent ground; child b; axis z }
output x = position of j'
    number=0
    for unit in $UNITS; do
        number=$((number + 1))
        echo "constant c$number = 2 $unit"
        echo "tunable t$number = 2 $unit"
        echo "constant d$number = 3 * t$number"
    done
    echo 'constant plain = 2
tunable vacant = 0
constant arm = (1, 2, 3) m'
} >"$out/all.scene"

# told SETTING PATTERN: the only error is at the value of the option, and matches.
told()
{
    ! build/isoc "$out/all.scene" -o "$out/refused" --set "$1" >"$out/summary" 2>"$out/errors" &&
        [ "$(grep -c error: "$out/errors")" -eq 1 ] && grep -q "^--set:1:[0-9]*: error: $2" "$out/errors"
}

# accepts SETTING
accepts()
{
    build/isoc "$out/all.scene" -o "$out/accepted" --set "$1" >"$out/summary" 2>"$out/errors"
}

number=0
for unit in $UNITS; do
    number=$((number + 1))
    is_good=0
    for other in $UNITS ''; do
        if [ "$other" = "$unit" ]; then
            accepts "c$number = 5 $other; t$number = 5 $other" || is_good=1
        else
            told "c$number = 5 $other" "'c$number' is in .* in the scene; this " || is_good=1
            told "t$number = 5 $other" "'t$number' is in .* in the scene; this " || is_good=1
        fi
        [ $is_good -eq 0 ] || break
    done
    [ $is_good -eq 0 ] && accepts "c$number = 0; t$number = 0"
    result $? "a value in $unit is set in $unit or to zero, and in no other unit"
    [ $is_good -eq 0 ] || cat "$out/errors"
done
told 'plain = 2 m' "'plain' has no unit in the scene; this is in m"
result $? 'a plain number has no unit'
accepts 'vacant = 2 m'
result $? 'a zero in the scene has any unit'
told 'arm = 2 m' "'arm' is a vector (x, y, z); this is one number" && told 'plain = (1, 2, 3)' "'plain' is one number; this is a vector"
result $? 'as many components as in the scene'
accepts 't1 = 2 kg; t1 = 3 kg' && told 't1 = 2 kg; t1 = 3 m' "'t1' is in kg in the scene; this is in m"
result $? 'the scene decides, not an option before'
finish
