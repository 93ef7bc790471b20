# shellcheck shell=sh
# Functions shared by the scripts of this folder and some others; read from the root of the project, with make in $MAKE.
# Messages begin with $WHAT.
set -u
LC_ALL=C
export LC_ALL
. tools/build/alone.sh

fail()
{
    complain "$1"
    exit 1
}

# complain TEXT: prints an error and returns 1, for a caller that has more to do.
complain()
{
    echo "${WHAT:+$WHAT: }$1" >&2
    return 1
}

# with_choices COMMAND...: the command with the options of isoc for the variables of a run but SET, which are in the
# environment.
with_choices()
{
    "$@" --real "$REAL" ${METHOD:+--method "$METHOD"} ${STEP:+--step "$STEP"} ${TOLERANCE:+--tolerance "$TOLERANCE"} \
        ${INPUTS:+--inputs "$INPUTS"} ${WITHOUT:+--without "$WITHOUT"}
}

# folders FOLDER...: makes those that are missing.
folders()
{
    for folders_one; do
        shift
        [ -d "$folders_one" ] || set -- "$@" "$folders_one"
    done
    [ $# -eq 0 ] || mkdir -p "$@"
}

# due: whether the next row of a table is measured; `row` is -1 before the first. With $TURN, PART/PARTS, every PARTS-th
# is, from PART on, from 0 (tests/use/test_tables.py, tests/tools/cycles/cycles.t).
due()
{
    row=$((row + 1))
    [ -z "${TURN-}" ] || [ $((row % ${TURN#*/})) -eq "${TURN%/*}" ]
}

# compute NAME [OPTION...] [FILE...]: runs NAME.awk on its input.
compute()
{
    compute_name=$1
    shift
    awk -f "tools/measure/$compute_name.awk" "$@"
}

# picture NAME PICTURE ARGUMENT...: writes $dir/NAME.gnuplot, and adds it to those that draw_pictures draws as NAME.svg
# and NAME.png.
pictures=
picture()
{
    picture_file=$dir/$1.gnuplot
    shift
    sh tools/plot/picture.sh "$@" >"$picture_file" || fail "there is nothing in $picture_file"
    pictures="$pictures $picture_file"
}
draw_pictures()
{
    # shellcheck disable=SC2086
    [ -z "$pictures" ] || sh tools/plot/draw.sh $pictures >/dev/null || fail "gnuplot does not draw$pictures"
}

# elsewhere SCENE: the scene so that it can stand in any folder: paths of its includes are from the root.
elsewhere()
{
    grep -q include "$1" || { cat "$1" && return; }
    elsewhere_folder=$(cd -- "$(dirname -- "$1")" && pwd | sed 's/[\\&|]/\\&/g') || exit 1
    sed 's|\(include *"\)\([^/"]\)|\1'"$elsewhere_folder"'/\2|g' "$1"
}

# on_board DIR SCENE METHOD SECONDS 'run [GOAL...]' [VARIABLE=VALUE...]: runs the firmware of the Cortex-M4F in float,
# in steps of $STEP where that is not empty; the output of make run and the goals is in DIR/measured, messages in
# DIR/said.
on_board()
{
    board_dir=$1 board_scene=$2 board_method=$3 board_seconds=$4 board_goals=$5
    shift 5
    folders "$board_dir"
    make_alone cortex-m4f/float "$board_dir" "$board_goals" SCENE="$board_scene" METHOD="$board_method" STEP="$STEP" SECONDS="$board_seconds" "$@" \
        >"$board_dir/measured" 2>"$board_dir/said" </dev/null
}

# book: $count is the number of the present item, from 1 on. Several processes may ask at once; the one that creates the
# file has the number.
book()
{
    count=1
    set -C
    while ! command : 2>/dev/null >"$dir/done/$count"; do
        count=$((count + 1))
    done
    set +C
}

# read_plant PLANT: $period, its step in ns; $every, the least number of ticks that all outputs and samples of only some
# ticks meet in; and $members, those of its model that show what it watches for: discontinuity, before. In $dir/members.
read_plant()
{
    awk -F "output_every_|is_due_" '
        function gcd(a, b) { return b ? gcd(b, a % b) : a }
        BEGIN { all = 1 }
        match($0, /period_ns = UINT32_C[(][0-9]+/) { period = substr($0, RSTART + 21, RLENGTH - 21) }
        /^    [.](discontinuity|before) = / { split($0, word, " "); members = members " " substr(word[1], 2) }
        { for (i = 2; i <= NF; i++) all = all / gcd(all, $i + 0) * ($i + 0) }
        END { print period, all members }' "$1" >"$dir/members"
    read -r period every members <"$dir/members"
}

# collected FILE FUNCTION COMMAND...: $collected are the instructions of the function in a run on this machine; the
# output of the command is in FILE, that of callgrind in FILE.said.
collected()
{
    collected_in=$1 collected_of=$2
    shift 2
    collected=
    valgrind --tool=callgrind --callgrind-out-file=/dev/null --toggle-collect="$collected_of" "$@" \
        >"$collected_in" 2>"$collected_in.said" </dev/null
    while read -r _ collected_word _ collected_number; do
        [ "$collected_word" != Collected ] || collected=$collected_number
    done <"$collected_in.said"
    [ "${collected:-0}" -gt 0 ]
}
