#!/bin/sh
# One method in double: $dir/double-METHOD/bench, with its error at steps of twice the scene's and at the scene's, with
# the fewest steps from which on the error stays at most $error, 0 if that takes steps shorter than 1 us, and `-`. Of
# adams, which has no error at a step, `- -`, the steps and the largest tolerance from which on it does; 0 if there is none.
#
#     search.sh double METHOD
. tools/report/common.sh
method=$2
take "$method"
(variable double "$method") || fail "$method cannot be built for $SCENE; METHODS='...' chooses others"

# errors STEPS... or TOLERANCES...: a line for each: the steps and their error. The time is the whole of it: what a sum of
# that many steps rounds away is nothing here.
errors()
{
    "$dir/double-$method/drive" "$time" "$@" | sed "s/^\([^ ]*\) [^ ]*/double $method 0 - \1 $time/" >"$dir/double-$method/tried"
    awk -f tools/report/errors.awk part=reference "$dir/reference.txt" part=points "$dir/double-$method/tried" |
        awk -F '\t' 'NR > 1 { print $4, $5 }'
}

# within ERROR: whether it is small enough, at most $error.
within()
{
    awk -v found="$1" -v error="$error" 'BEGIN { exit !(found != "inf" && found + 0 <= error + 0) }'
}

# grid FROM TO: numbers of steps from one to the other, sixteen to a doubling.
grid()
{
    awk -v n="$1" -v to="$2" 'BEGIN {
        for (; n < to; n = n * 2 ^ (1 / 16) > n + 1 ? n * 2 ^ (1 / 16) : n + 1) printf "%d ", n
        printf "%d\n", to }'
}

# first_within: of lines of something and the error that it has, the last that has more than $error, its first field
# only, and the first line behind it: 0 for a line that is not there.
first_within()
{
    awk -v error="$error" '
        $NF != "inf" && $NF + 0 <= error + 0 { if (enough == "") enough = $0; next }
        { few = $1; enough = "" }
        END { print few + 0, enough == "" ? "0 0 0" : enough }'
}

# loosest: the steps and the tolerance, the largest from which on the error stays small enough, of a grid with four to a
# doubling.
loosest()
{
    tolerances=$(awk 'BEGIN { for (t = 1e-2; t > 1e-13; t /= 2 ^ (1 / 4)) printf "%.3g\n", t }')
    # shellcheck disable=SC2086
    errors $tolerances >"$dir/double-$method/errors"
    echo "$tolerances" | paste -d ' ' - "$dir/double-$method/errors" >"$dir/double-$method/grid"
    # shellcheck disable=SC2046
    set -- $(first_within <"$dir/double-$method/grid")
    echo "$3 $2"
}

# fewest: doubles the steps until the error is far below, goes back over a grid to the first that fails, and halves the
# interval behind it.
fewest()
{
    steps=$coarsest
    most=$(awk -v time="$time" 'BEGIN { print int(time * 1e6) }')
    far=$(awk -v error="$error" 'BEGIN { print error / 16 }')
    until set -- $(errors "$steps") && (error=$far && within "$2"); do
        steps=$((2 * steps))
        if [ "$steps" -gt "$most" ]; then
            steps=$most
            break
        fi
    done
    from=$((steps / 256))
    # shellcheck disable=SC2046
    set -- $(errors $(grid $((from > 0 ? from : 1)) "$steps") | first_within)
    few=$1
    enough=$2
    while [ $((enough - few)) -gt 1 ]; do
        middle=$(((few + enough) / 2))
        # shellcheck disable=SC2046
        set -- $(errors $middle)
        if within "$2"; then
            enough=$middle
        else
            few=$middle
        fi
    done
    echo "$enough"
}

if [ -n "$TOLERANCE" ]; then
    echo "- - $(loosest)"
else
    # shellcheck disable=SC2046
    set -- $(errors $((2 * coarsest)) $((4 * coarsest)))
    echo "$2 $4 $(fewest) -"
fi >"$dir/double-$method/bench"
