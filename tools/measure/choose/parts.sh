# shellcheck shell=sh
# Functions shared by the scripts of make choose. Their environment has the variables of choose.sh, and from that
#
#     dir              the folder of all that is made
#     period           the scene's step, ns
#     rows             how many of them are judged
#     bounds           arguments of run.c: BOUND=COLUMNS ...
#     every            the rows in which all outputs are due are multiples of it
WHAT="make choose"
. tools/measure/common.sh
# A make that is called does not get the options of this one; CC and CFLAGS it has from the environment.
unset MAKEFLAGS MFLAGS MAKEOVERRIDES

# step_of NS: as a scene has it.
step_of()
{
    awk -v ns="$1" 'BEGIN {
        if (ns >= 1e6) printf "%.9g ms\n", ns / 1e6
        else if (ns >= 1e3) printf "%.9g us\n", ns / 1e3
        else printf "%d ns\n", ns
    }'
}

# The ticks that are tried, in steps of the scene; where they divide it, also so many steps in one.
long_ticks="2 3 4 5 6 8 10 12 15 16 20 25 30 32 40 50 60 64 80 100 120 125 150 160 200 250 300 320 400 500 600 625 800 1000"

# A METHOD is a word of isoc; that of adams has its tolerance behind it: adams-1e-06.
#
# built FOLDER REAL STATEMENTS METHOD NS [OPTION...]: the program FOLDER/run of the scene with these statements at its
# top and these options of isoc. Messages of isoc and the compiler are in FOLDER/said.
built()
{
    built_folder=$1 built_real=$2 built_statements=$3 built_method=${4%%-*} built_ns=$5
    shift 5
    folders "$built_folder" &&
        compute choose/edit -v statements="$built_statements" "$dir/base.scene" >"$built_folder/$NAME.scene" &&
        build/isoc "$built_folder/$NAME.scene" -o "$built_folder" --method "$built_method" --step "${built_ns}ns" --real "$built_real" \
            ${SET:+--set "$SET"} ${WITHOUT:+--without "$WITHOUT"} "$@" >"$built_folder/plant.txt" 2>"$built_folder/said" || return 1
    [ "$built_real" = double ] && built_flag=-DISO_REAL_DOUBLE || built_flag=
    # shellcheck disable=SC2086
    $COMPILE -O1 $built_flag "$built_folder/plant.c" "$dir/run_$built_real.o" build/obj/tools/file/file.o -lm \
        -o "$built_folder/run" 2>"$built_folder/said"
}

# state N COMPENSATED METHOD: $statements are those of a plant with so many steps in a tick.
state()
{
    case $3,$1 in
    adams-*) statements="method adams; substeps $1; compensated $2; tolerance ${3#adams-}" ;;
    *,1) statements="substeps -; compensated $2; tolerance -" ;;
    *) statements="substeps $1; compensated $2; tolerance -" ;;
    esac
}

# reference_rows FOLDER: the reference there as text, a line for each row.
reference_rows()
{
    od -An -v -t f8 -w$((8 * $(awk -F '|' '{ n += split($3, part, ",") } END { print n }' "$dir/columns"))) "$1/reference"
}

# cycles FOLDER SCENE METHOD NS: $counted are those of the dearest tick on the TARGET, and their share of the step in
# percent; in FOLDER/counted as well; by make cycles, whose messages are in FOLDER/said. Fails where not all fits in
# memory.
cycles()
{
    cycles_folder=$1 cycles_scene=$2 cycles_method=${3%%-*} cycles_ns=$4
    folders "$cycles_folder"
    : >"$cycles_folder/cycles.tsv"
    make_alone "$TARGET/float" "$cycles_folder" cycles SCENE="$cycles_scene" METHOD="$cycles_method" STEP="${cycles_ns}ns" CORE="$CORE" \
        CLOCK="$CLOCK" BOARD="$BOARD" INPUTS="$INPUTS" SET="$SET" WITHOUT="$WITHOUT" >"$cycles_folder/table" 2>"$cycles_folder/said" </dev/null
    [ -s "$cycles_folder/cycles.tsv" ] || return 1
    awk -F '\t' -v ns="$cycles_ns" '
        $1 == "part" && $2 == "tick" { cycles = $5 }
        $1 == "part" && $2 == "interrupt" { cycles += $5 }
        $1 == "highest_rate_hz" { rate = $2 }
        END { printf "%d %.6g\n", cycles, 1e11 / (rate * ns) }' "$cycles_folder/cycles.tsv" >"$cycles_folder/counted"
    read -r counted <"$cycles_folder/counted"
}

# cycles_at FOLDER METHOD COMPENSATED K N: `cycles` of a tick of K steps of the scene, and N steps in a tick; the scene
# with these statements at its top is FOLDER/$NAME.scene.
cycles_at()
{
    folders "$1"
    state "$5" "$3" "$2"
    compute choose/edit -v statements="$statements" "$dir/base.scene" >"$1/$NAME.scene"
    cycles "$1" "$1/$NAME.scene" "$2" $((period * $4))
}
