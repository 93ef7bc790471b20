# shellcheck shell=sh
# What the scripts of this folder, and some others, share; read by them from the root of the project, with the make to call in $MAKE. WHAT is what their
# messages begin with.
set -u
LC_ALL=C
export LC_ALL

fail()
{
    echo "${WHAT:+$WHAT: }$1" >&2
    exit 1
}

# with_choices COMMAND...: the command with the options of isoc for the variables of a run but SET, which are in the environment.
with_choices()
{
    "$@" --real "$REAL" ${METHOD:+--method "$METHOD"} ${STEP:+--step "$STEP"} ${TOLERANCE:+--tolerance "$TOLERANCE"} \
        ${INPUTS:+--inputs "$INPUTS"} ${WITHOUT:+--without "$WITHOUT"}
}

# compute NAME [OPTION...] [FILE...]: what NAME.awk makes of its input.
compute()
{
    compute_name=$1
    shift
    awk -f "tools/measure/$compute_name.awk" "$@"
}

# elsewhere SCENE: the scene so that it can stand in any folder: what it includes is named from the root.
elsewhere()
{
    grep -q include "$1" || { cat "$1" && return; }
    elsewhere_folder=$(cd -- "$(dirname -- "$1")" && pwd | sed 's/[\\&|]/\\&/g') || exit 1
    sed 's|\(include *"\)\([^/"]\)|\1'"$elsewhere_folder"'/\2|g' "$1"
}

# on_board DIR SCENE METHOD SECONDS [GOAL|VARIABLE=VALUE...]: runs the firmware of the Cortex-M4F in float, in steps of $STEP where that
# is not empty; what make run, and the further goals, print is in DIR/measured, and their messages in DIR/said.
on_board()
{
    board_dir=$1 board_scene=$2 board_method=$3 board_seconds=$4
    shift 4
    [ -d "$board_dir" ] || mkdir -p "$board_dir"
    "${MAKE:-make}" --no-print-directory run "$@" TARGET=cortex-m4f REAL=float OUT="$board_dir" SCENE="$board_scene" METHOD="$board_method" \
        STEP="$STEP" SECONDS="$board_seconds" >"$board_dir/measured" 2>"$board_dir/said" </dev/null
}

# book N: $count is the number of what is done now, of which at least N - 1 were before; several may ask at once.
book()
{
    count=$1
    while ! mkdir "$dir/done/$count" 2>/dev/null; do
        count=$((count + 1))
    done
}

# period_of PLANT, every_of PLANT: its step in ns, and the least number of ticks that all outputs of only some ticks meet in.
period_of()
{
    sed -n 's/.*period_ns = UINT32_C(\([0-9]*\)).*/\1/p' "$1"
}
every_of()
{
    awk -F output_every_ '
        function gcd(a, b) { return b ? gcd(b, a % b) : a }
        BEGIN { all = 1 }
        { for (i = 2; i <= NF; i++) all = all / gcd(all, $i + 0) * ($i + 0) }
        END { print all }' "$1"
}

# collected FUNCTION COMMAND...: the instructions of the function in a run on this machine; what the command prints is in $kept.
kept=/dev/null
collected()
{
    collected_of=$1
    shift
    valgrind --tool=callgrind --callgrind-out-file=/dev/null --toggle-collect="$collected_of" "$@" 2>&1 >"$kept" </dev/null |
        awk '/Collected : / { n = $NF } END { if (n + 0 <= 0) exit 1; print n }'
}
