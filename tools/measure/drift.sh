#!/bin/sh
# How far the closed loops of a scene come apart with every stabilisation, each alone, in float. Called by `make drift`,
# with the variables of tools/measure/methods.sh in the environment; everything stands in build/drift/NAME/:
# violation.svg and .png, the picture; STABILISATION.scene, and beside it the measurements.
. tools/measure/stabilised.sh
dir=build/drift/$FOLDER
mkdir -p "$dir" || exit 1
seconds=$(awk -v ns="$NANOSECONDS" 'BEGIN { printf "%.9g", ns / 1e9 }')
parts=200 # of the time: points of a line in the picture

# cost STABILISATION: $instructions are those of a step on the Cortex-M4F.
cost()
{
    on_board "$dir/$1-m4f" "$dir/$1.scene" '' 0.05 run || fail "$1 does not run on the Cortex-M4F; see $dir/$1-m4f/said"
    awk '$1 == "instructions_per_step" { print $2; n++ } END { exit n != 1 }' "$dir/$1-m4f/measured" >"$dir/cost" ||
        fail "$dir/$1-m4f/measured has not one count"
    read -r instructions <"$dir/cost"
}

# order STABILISATION: $order is that of the scene's method in the first second, with its step, a half and a quarter of
# it; - where these are too short.
order()
{
    order=-
    awk '$1 == "step" && NF == 3 { ns = $2 * 1e9; for (part = 1; part <= 4; part *= 2) printf "%.0fns\n", ns / part
            exit !(int(ns / 4 + 0.5) * 4 == int(ns + 0.5) && ns >= 4000) }' "$dir/$1.said" >"$dir/steps" ||
        return 0
    for plant in coarse middle fine; do
        read -r step
        build/isoc "$dir/$1.scene" -o "$dir/order" --real double --name $plant --step "$step" >/dev/null ||
            fail "$1 cannot be compiled with $step"
    done <"$dir/steps"
    # shellcheck disable=SC2086
    $COMPILE -DISO_REAL_DOUBLE -I"$dir/order" tools/measure/order.c "$dir/order/coarse.c" "$dir/order/middle.c" \
        "$dir/order/fine.c" -o "$dir/order/order" -lm || fail "$dir/order/order cannot be built"
    "$dir/order/order" 1 >"$dir/order/measured" || return
    while read -r word value; do
        [ "$word" != order ] || order=$value
    done <"$dir/order/measured"
}

: >"$dir/measured"
echo "| stabilisation | order | largest violation | bound | change of energy | instructions of a step |"
echo "|---|--:|--:|--:|--:|--:|"
for stabilisation in $STABILISATIONS; do
    if measure "$stabilisation" "$seconds" $parts; then
        cost "$stabilisation" && order "$stabilisation" || exit 1
        awk -v name="$stabilisation" -v order="$order" -v seconds="$seconds" -v instructions="$instructions" '
            { value[$1] = $2 }
            END {
                torn = value["end"] < seconds
                print "| " name " | " order " | " (torn ? "torn after " value["end"] " s" : value["violation"]) \
                    " | " (torn || value["bound"] == "inf" ? "-" : value["bound"]) \
                    " | " (torn ? "-" : value["energy"]) " | " instructions " |"
            }' "$dir/$stabilisation.measured"
        sed "s/^/$stabilisation /" "$dir/$stabilisation.measured" >>"$dir/measured"
    else
        echo "| $stabilisation | - | refused | - | - | - |"
        head -n 1 "$dir/$stabilisation.said" >&2
    fi
done
[ -s "$dir/measured" ] || fail "there is nothing to measure in $SCENE"
echo
sh tools/plot/draw.sh "$dir/violation.gnuplot" violation "$NAME" "$dir/measured" || fail "gnuplot does not draw $dir/violation.gnuplot"
