# shellcheck shell=sh
# Functions of the host tests; read by each *.t with `. tests/host/test.sh`, from the project's root.
# A script runs programs that print TAP and joins their results into one stream.

: "${CC:=cc}"
NUMERICS=$(paste -sd ' ' tools/build/numerics)
FLAGS="-std=c11 -Wall -Wextra -Wpedantic -Wconversion -Wdouble-promotion -Wshadow -Wstrict-prototypes
    -Wmissing-prototypes -Wvla -Werror -O2 $NUMERICS -I."
tests=0
failures=0

# result STATUS NAME: one test, passed if STATUS is 0.
result()
{
    tests=$((tests + 1))
    if [ "$1" -eq 0 ]; then
        echo "ok $tests - $2"
    else
        failures=$((failures + 1))
        echo "not ok $tests - $2"
    fi
}

# stated FILE TEXT: whether the words of a Markdown file, or of a source with its comments, have this text, wherever
# their lines end; where they have not, that is said.
stated()
{
    stated_words=$(awk '{ sub(/^ *([#*]|\/\*)* */, ""); printf "%s ", $0 }' "$1")
    case $stated_words in
    *"$2"*) ;;
    *) echo "# $1 does not say: $2" && false ;;
    esac
}

# begin DIR: empties the folder that this test builds in, $out.
begin()
{
    out=build/tests/$1
    rm -rf "$out"
    mkdir -p "$out"
    real double
}

# real float|double: what the scenes and programs that follow compute in.
real()
{
    real=$1
    case $1 in
    float) REAL_FLAG= ;;
    double) REAL_FLAG=-DISO_REAL_DOUBLE ;;
    esac
}

# rolled: the programs that follow run kernels of which the compiler knows neither recipe nor n. To unroll their loops
# would take it most of its time, and changes no bit; plants are compiled with it, and compared without it, by
# promises/same_bits.t.
rolled()
{
    FLAGS="$FLAGS -DISO_UNROLL="
}

# optimised LEVEL: the programs that follow are compiled with it: -O0 where they run for less time than a compiler
# optimises, by the compiler that then takes a third less. It changes no bit (promises/same_bits.t), and what gcc warns
# of where it optimises other tests see.
optimised()
{
    FLAGS="${FLAGS%% -O[0-9s] *} $1 ${FLAGS#* -O[0-9s] }"
    compiler_for "$1"
    CC=$compiler
}

# quick: the programs that follow are compiled by tcc, in a tenth of the time of the other compilers. It is for programs
# that run shortly: a tick takes 15 times as long as by gcc -O2. It changes no bit (promises/same_bits.t).
quick_flags="-std=c11 -include $PWD/tools/lab/tcc.h"
quick()
{
    FLAGS="$quick_flags -I."
    CC=tcc
}

# compiler_for FLAGS: $compiler is that of the host which compiles with these flags.
host_compiler=$CC
compiler_for()
{
    case " $1 " in
    *'/tools/lab/tcc.h '*) compiler=tcc ;;
    *' -O0 '*) compiler=clang ;;
    *) compiler=$host_compiler ;;
    esac
}

# Functions that are called for every pair of a scene and a method start no process: one takes as long as a hundred
# calls.

# place WORD LIST...: $place is that of the word in the list, from 0; fails where it is not in it.
place()
{
    place_word=$1
    place=0
    shift
    for place_other; do
        [ "$place_word" != "$place_other" ] || return 0
        place=$((place + 1))
    done
    return 1
}

# shared_models: lists in $shared_models the scenes that are tried with all methods, in $all_models all.
shared_models()
{
    [ -z "${shared_models-}" ] || return 0
    shared_models=$(grep -L '^ *effect ' models/*.scene | grep -vxF models/stewart.scene)
    all_models=$(echo models/*.scene)
}

# of_port FOLDER VARIABLE: its value in a folder of port/, as its makefile has it.
of_port()
{
    sed -n "s/^$2 = *//p" "port/$1/"*.mk
}

# models METHOD: the scenes that are tried with it, one on a line; models_of puts them in $models. With rk4 alone:
# stewart, whose code takes a compiler several seconds and with an implicit method half a minute; and those with
# effects, which tests/isoc/effects tries with the methods.
models_of()
{
    shared_models
    models=$shared_models
    [ "$1" != rk4 ] || models=$all_models
}
models()
{
    models_of "$1"
    # shellcheck disable=SC2086
    printf '%s\n' $models
}

# macro_of METHOD: $macro is what C calls this one of METHODS, such as ISO_RK4.
macro_of()
{
    : "${macros:=$(echo "$METHODS" | tr a-z A-Z)}"
    # shellcheck disable=SC2086
    place "$1" $METHODS && set -- $macros && shift "$place" && macro=ISO_$1
}

# in_depth SCENE: whether it is one of those that are run for long and built in every way: all kinds of them.
in_depth()
{
    in_depth_name=${1##*/}
    case " pendulum double_pendulum cart_pole arm6 tree rigid_body four_bar " in
    *" ${in_depth_name%.scene} "*) ;;
    *) return 1 ;;
    esac
}

# has_turn SCENE METHOD: whether the method shares no kernel, or it is the scene's turn. What is tried with rk4 alone
# has it.
has_turn()
{
    case $2 in
    euler | heun | rk4) place "$2" euler heun rk4 ;;
    abm4 | abm4_pec | abm4_pecece) place "$2" abm4 abm4_pec abm4_pecece ;;
    *) return 0 ;;
    esac
    has_turn_place=$place
    shared_models
    # shellcheck disable=SC2086
    ! place "$1" $shared_models || [ $(((place + 1) % 3)) -eq "$has_turn_place" ]
}

# due SCENE METHOD: whether it is tried this time, $turn of turn_of 20. One-step methods from one table every second
# time, rk4 always on models that are tried in depth; of all other pairs a twentieth, and of stewart, which takes gcc
# ten seconds.
due()
{
    due_of=20
    case $2,$1,$turn in
    *,all) return 0 ;;
    *,models/stewart.scene,*) ;;
    euler,* | heun,* | rk4,*)
        [ "$2" != rk4 ] || ! in_depth "$1" || return 0
        due_of=2
        ;;
    esac
    # shellcheck disable=SC2086
    place "$2" $METHODS
    due_place=$place
    # shellcheck disable=SC2086
    place "$1" models/*.scene
    [ $(((place + due_place) % due_of)) -eq $((turn % due_of)) ]
}

# turn_of PARTS [ALL]: which of so many parts is tried this time, from 0: $TEST_TURN, which follows from what the test
# follows from (tests/harness/tap.py), so that over commits each has its turn. `all` if ALL is that, or $TEST_WHOLE is
# not empty.
turn_of()
{
    if [ "${2-}" = all ] || [ -n "${TEST_WHOLE-}" ]; then
        echo all
    else
        echo $((${TEST_TURN:-0} % $1))
    fi
}

# next_turn PARTS: whether the next thing of a list is tried this time, by $turn of a turn_of as many parts, or a
# multiple.
turns_so_far=0
next_turn()
{
    turns_so_far=$((turns_so_far + 1))
    [ "$turn" = all ] || [ $((turns_so_far % $1)) -eq $((turn % $1)) ]
}

# one_isoc: from here on one process carries out every call of `isoc`: to start isoc takes longer than a small scene.
one_isoc()
{
    mkfifo "$out/.requests" "$out/.answers" || exit
    build/tests/requests <"$out/.requests" >"$out/.answers" &
    exec 8>"$out/.requests" 9<"$out/.answers"
    has_one_isoc=yes
}

# isoc OUTPUT MESSAGES ARGUMENT...: what build/isoc does with these arguments, and its status (tests/host/requests.c).
# Messages stay those of the test where their file is an empty word.
has_one_isoc=
isoc()
{
    if [ -n "$has_one_isoc" ]; then
        printf '%s\0' "$@" >&8 && echo >&8 && read -r isoc_status <&9 || exit
        return "$isoc_status"
    fi
    isoc_output=$1
    isoc_messages=$2
    shift 2
    if [ -n "$isoc_messages" ]; then
        build/isoc "$@" >"$isoc_output" 2>"$isoc_messages"
    else
        build/isoc "$@" >"$isoc_output"
    fi
}

# scene NAME [OPTION...]: compiles models/NAME.scene into $out/NAME, with these options of isoc.
scene()
{
    scene_name=$1
    shift
    isoc "$out/$scene_name.summary" '' "models/$scene_name.scene" -o "$out/$scene_name" --real "$real" "$@" &&
        [ -s "$out/$scene_name/plant.c" ]
}

# program FILE SOURCE...: compiles the sources into $out/FILE. Further flags stand in $EXTRA. Each source is compiled by
# itself, so that ccache knows those that were compiled before; tcc takes less time than that, and a library is one
# command.
program()
{
    program_file=$1
    shift
    compiler_for "$FLAGS ${EXTRA-}"
    case "$1,$compiler, ${EXTRA-} " in
    -c,* | *,tcc,* | *' -shared '*)
        program_library=-lm
        [ "$1" != -c ] || program_library=
        # shellcheck disable=SC2086
        "$compiler" $FLAGS $REAL_FLAG ${EXTRA-} "$@" -o "$out/$program_file" $program_library
        return
        ;;
    esac
    program_options=
    for program_word; do
        case $program_word in
        *.c | *.o) ;;
        *) program_options="$program_options $program_word" ;;
        esac
    done
    for program_source; do
        shift
        case $program_source in
        *.c)
            program_object=$out/.objects/$program_file/$(echo "$program_source" | tr / +).o
            mkdir -p "$out/.objects/$program_file"
            # shellcheck disable=SC2086
            "$compiler" $FLAGS $REAL_FLAG ${EXTRA-} $program_options -c "$program_source" -o "$program_object" || return
            program_source=$program_object
            ;;
        esac
        set -- "$@" "$program_source"
    done
    # shellcheck disable=SC2086
    "$compiler" $FLAGS ${EXTRA-} "$@" -o "$out/$program_file" -lm
}

# waited PROCESS COMMAND...: waits until the command succeeds, for as long as the process, which it waits for, lives.
waited()
{
    waited_for=$1
    shift
    until "$@"; do
        kill -0 "$waited_for" 2>/dev/null || return 1
        sleep 0.05
    done
}

# joined NAME COMMAND...: runs a command that prints TAP and joins its results, each headed by NAME.
joined()
{
    joined_name=$1
    shift
    joined_status=0
    "$@" >"$out/tap" || joined_status=$?
    awk -v name="$joined_name" -v n="$tests" -v counts="$out/joined" '
        /^1\.\.[0-9]+$/ { planned = substr($0, 4); next }
        match($0, /^(not )?ok [0-9]+ - /) {
            ran++
            failed += /^not/
            sub(/[0-9]+ - /, ++n " - " name ": ")
        }
        { print }
        END { print ran + 0, failed + 0, (planned == "" ? "none" : planned) >counts }' "$out/tap"
    read -r ran failed planned <"$out/joined"
    tests=$((tests + ran))
    failures=$((failures + failed))
    if [ "$planned" != "$ran" ] || { [ "$joined_status" -ne 0 ] && [ "$failed" -eq 0 ]; }; then
        result 1 "$joined_name: ended with status $joined_status"
    fi
}

# bare_numbers: $out/bare has the numbers of core without what puts a stranger's flags right, for who looks there first.
bare_numbers()
{
    mkdir -p "$out/bare/core/numbers"
    cp core/numbers/*.h "$out/bare/core/numbers"
    sed '/^#pragma/d' core/numbers/real.h >"$out/bare/core/numbers/real.h"
}

# finish: the plan, and the script's exit status.
finish()
{
    echo "1..$tests"
    [ "$failures" -eq 0 ] && [ "$tests" -gt 0 ]
    exit
}
