#!/bin/sh
# try.sh METHOD COMPENSATED K N: a method in float, with a tick of K steps of the scene, and N steps in a tick, against
# the reference. Prints `RATIO BOUND ROW ERROR...`: the largest error in its bound, the number of that bound, and the
# row; `inf` and the reason where it is refused, or ends early. Called by search.awk.
. tools/measure/choose/parts.sh
method=$1 compensated=$2 k=$3 n=$4
of=$dir/$method-$compensated
ns=$((period * k))
state "$n" "$compensated" "$method"
if ! built "$of" float "$statements" "$method" $ns ${INPUTS:+--inputs $INPUTS}; then
    text="inf refused: $(sed -n 's/.*error: //p' "$of/said" | head -n 1)"
else
    # shellcheck disable=SC2086
    "$of/run" -n $((rows / k)) -e "$every" -s $((k * every)) -r "$dir/reference" ${RECORDED:+-u "$RECORDED"} $bounds >"$of/ran" 2>&1
    awk -v last=$((rows / k / every)) '
            $1 == "error" {
                n++
                r = $3 / $2
                errors = errors " " $3
                if (!(r <= ratio)) { ratio = r; bound = n; row = $4 }
            }
            $1 == "rows" { rows = $2 }
            END {
                if (n == 0 || rows <= last) print "inf ends early"
                else if (!(ratio < 1e30)) print "inf not finite"
                else printf "%.6g %d %d%s\n", ratio, bound, row, errors
            }' "$of/ran" >"$of/text"
    read -r text <"$of/text"
fi
echo "$method $compensated $k $n $text" >>"$dir/tries/$method-$compensated"
echo "$text"
