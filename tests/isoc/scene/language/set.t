#!/bin/sh
# --set gives a constant or a tunable another value of its own unit. Any other unit is an error where the option has it,
# not where the scene uses the name: each unit against each.
. tests/host/test.sh
begin language_set
one_isoc

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

# told SETTINGS PATTERN [NUMBER]: each of so many settings, of one if no number is given, has its error at the value of
# the option, and each error matches.
told()
{
    ! isoc "$out/summary" "$out/errors" "$out/all.scene" -o "$out/refused" --set "$1" &&
        awk -v pattern="^--set:1:[0-9]+: error: $2" -v number="${3:-1}" '
            /error:/ { errors++; good += $0 ~ pattern; places += !seen[$1]++ }
            END { exit !(errors == number && good == number && places == number) }' "$out/errors"
}

# accepts SETTING
accepts()
{
    isoc "$out/summary" "$out/errors" "$out/all.scene" -o "$out/accepted" --set "$1"
}

# Each unit has its turn at each name: the units in a circle, with one place in it for none. Where names and units meet
# they are accepted, and by no other shift of the circle. isoc shows 20 errors: constants and tunables have a call each.
# shellcheck disable=SC2086
set -- $UNITS ''
last=$(($# - 1))
for shift in $(seq 0 $last); do
    for letter in c t; do
        number=0
        settings=
        for unit; do
            number=$((number + 1))
            [ $number -gt $last ] || settings="$settings; $letter$number = 5 $unit"
        done
        settings=${settings#; }
        if [ "$shift" -eq 0 ]; then
            accepts "$settings"
            result $? "accepted: $settings"
        else
            told "$settings" "'${letter}[0-9]+' is in .* in the scene; this " $last
            result $? "each is refused: $settings"
        fi
    done
    first=$1
    shift
    set -- "$@" "$first"
done
accepts "$(seq -s ' ' $last | sed 's/[0-9]*/c& = 0; t& = 0;/g; s/;$//')"
result $? 'and zero in any'
told 'plain = 2 m' "'plain' has no unit in the scene; this is in m"
result $? 'a plain number has no unit'
accepts 'vacant = 2 m'
result $? 'a zero in the scene has any unit'
told 'arm = 2 m' "'arm' is a vector [(]x, y, z[)]; this is one number" && told 'plain = (1, 2, 3)' "'plain' is one number; this is a vector"
result $? 'as many components as in the scene'
accepts 't1 = 2 kg; t1 = 3 kg' && told 't1 = 2 kg; t1 = 3 m' "'t1' is in kg in the scene; this is in m"
result $? 'the scene decides, not an option before'
finish
