#!/bin/sh
# What chains of rods cost by their length, as a Markdown table: operations of an evaluation of their equations of motion
# and the formulation that is kept; on the Cortex-M4F in float the instructions of a step of euler, which has one evaluation,
# and its code. Called by `make chains`, with the make to call in $MAKE and the lengths in $LENGTHS.
set -u
. tools/build/measure.sh

# chain KIND N: a row.
chain()
{
    folder=build/cost/$1_$2
    mkdir -p "$folder"
    sh tools/build/chain.sh "$2" "$1" >"$folder/chain.scene"
    measure "$1_$2" "$folder/chain.scene" euler size
    kept=$(awk '$1 == "formulation" && $3 == "kept" { print $2 }' "$dir/plant.txt")
    operations=$(operations) && instructions=$(get instructions_per_step) && text=$(get step_text) || exit 1
    echo "| $1, $2 | $kept | $operations | $instructions | $text |"
}

# growth KIND: from half the greatest length to that.
growth()
{
    awk -F ' *[|,] *' -v kind="$1" '
        $2 == kind {
            n = $3
            operations[n] = $5 + $6 + $7 + $8
            instructions[n] = $9
        }
        END {
            if (n / 2 in operations)
                printf "- %s, %d to %d joints: %.2f times the operations, %.2f times the instructions, %.0f for a joint.\n",
                    kind, n / 2, n, operations[n] / operations[n / 2], instructions[n] / instructions[n / 2],
                    (instructions[n] - instructions[n / 2]) / (n / 2)
        }' build/cost/chains
}

mkdir -p build/cost
{
    echo '| chain | formulation | add | mul | div | sincos | instructions | text |'
    echo '|---|---|--:|--:|--:|--:|--:|--:|'
    for kind in planar spatial; do
        for n in $LENGTHS; do
            chain $kind "$n"
        done
    done
} >build/cost/chains || exit 1
cat build/cost/chains
echo
growth planar
growth spatial
