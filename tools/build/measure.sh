# shellcheck shell=sh
# Measuring firmware on the Cortex-M4F in float; read by the price lists, with the make to call in $MAKE.

fail()
{
    echo "$1" >&2
    exit 1
}

# measure DIR SCENE METHOD [GOAL...]: builds the firmware in build/cost/DIR and runs some of its steps; the lines of
# make run, and of the further goals, stand in build/cost/DIR/measured.
measure()
{
    dir=build/cost/$1
    scene=$2
    method=$3
    shift 3
    mkdir -p "$dir"
    "${MAKE:-make}" --no-print-directory run "$@" TARGET=cortex-m4f REAL=float OUT="$dir" SCENE="$scene" \
        METHOD="$method" STEP= SECONDS=0.05 >"$dir/measured" </dev/null || fail "$scene with $method cannot be measured; see $dir/measured"
}

# get KEY: the one value of what was measured last; a limit may follow it. Steps that differ are no one value.
get()
{
    awk -v key="$1" '$1 == key && (NF == 2 || $3 == "of") { value = $2; n++ } END { if (n != 1) exit 1; print value }' "$dir/measured" ||
        fail "$dir/measured has not one $1"
}

# operations: of a derivative, as cells: add, mul, div, sincos.
operations()
{
    awk '$1 == "derivative" { printf "%s | %s | %s | %s", $3, $5, $7, $9; n++ } END { exit n != 1 }' \
        "$dir/plant.txt" || fail "$dir/plant.txt has not one line of operations"
}
