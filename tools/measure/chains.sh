#!/bin/sh
# The costs of chains of rods by their length, as Markdown tables. First operations of an evaluation of their equations
# of motion and the formulation that is kept; on the Cortex-M4F in float the instructions of a step of euler, which has
# one evaluation, and its code. Then, of every eighth length, operations of the factors of an implicit method and how
# they are found, and their bytes; instructions of a step of bdf4, and all code and tables of the plant. Called by `make
# chains`, with the make to call in $MAKE and the lengths in $LENGTHS.
. tools/measure/board.sh

# rods FOLDER N KIND METHOD: measures a chain in build/cost/FOLDER.
rods()
{
    folders "build/cost/$1"
    sh tools/measure/chain.sh "$2" "$3" >"build/cost/$1/chain.scene"
    measure "$1" "build/cost/$1/chain.scene" "$4" size
}

# chain KIND N: a row.
chain()
{
    rods "$1_$2" "$2" "$1" euler
    kept=$(awk '$1 == "formulation" && $3 == "kept" { print $2 }' "$dir/plant.txt")
    count_operations && get instructions_per_step step_text
    echo "| $1, $2 | $kept | $operations | $instructions_per_step | $step_text |"
}

# implicit N: a row.
implicit()
{
    STEP=10ms
    rods "implicit_$1" "$1" planar bdf4
    factors=$(awk '$1 == "factor" { made = $3 " | " $5 " | " $7 } $1 == "factors" { print $3 " | " made " | " 4 * $2 }' "$dir/plant.txt")
    text=$(awk '$6 ~ /plant\.o$/ { print $1 }' "$dir/measured")
    get instructions_per_step
    echo "| planar, $1 | $factors | $instructions_per_step | $text |"
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
echo
echo '| chain, bdf4 | factors | add | mul | div | bytes | instructions | text |'
echo '|---|---|--:|--:|--:|--:|--:|--:|'
for n in $LENGTHS; do
    [ $((n % 8)) -ne 0 ] || implicit "$n" || exit 1
done
