# shellcheck shell=sh
# What the host tests share; read by each *.t with `. tests/host/test.sh`, from the project's root.
# A script runs programs that print TAP and joins their results into one stream.

: "${CC:=cc}"
FLAGS="-std=c11 -Wall -Wextra -Wpedantic -Wconversion -Wdouble-promotion -Wshadow -Wstrict-prototypes
    -Wmissing-prototypes -Wvla -Werror -O2 -ffp-contract=off -fno-math-errno
    -fno-tree-vectorize -fno-tree-slp-vectorize -I."
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

# rolled: the programs that follow run kernels of which the compiler knows neither recipe nor n. To unroll their loops would
# take it most of its time, and changes no bit; plants are compiled with it, and compared without it, by check/same_bits*.sh.
rolled()
{
    FLAGS="$FLAGS -DISO_UNROLL="
}

# optimised LEVEL: the programs that follow are compiled with it: -O0 where they run for less time than a compiler optimises.
# It changes no bit (check/same_bits*.sh), and what gcc warns of where it optimises other tests see.
optimised()
{
    FLAGS=$(echo "$FLAGS" | sed "s/ -O[0-9s] / $1 /")
}

# models METHOD: the scenes that are tried with it, one on a line. With rk4 alone: stewart, whose code takes a compiler several
# seconds and with an implicit method half a minute; and those with effects, which tests/effects tries with the methods.
models()
{
    case $1 in
    rk4) ls models/*.scene ;;
    *) grep -L '^ *effect ' models/*.scene | grep -vxF models/stewart.scene ;;
    esac
}

# in_depth SCENE: whether it is one of those that are run for long and built in every way: all kinds of them.
in_depth()
{
    case " pendulum double_pendulum cart_pole arm6 tree rigid_body four_bar " in
    *" $(basename "$1" .scene) "*) ;;
    *) return 1 ;;
    esac
}

# has_turn SCENE METHOD: whether the method shares no kernel, or it is the scene's turn. What is tried with rk4 alone has it.
has_turn()
{
    case $2 in
    euler | heun | rk4) sharing='euler heun rk4' ;;
    abm4 | abm4_pec | abm4_pecece) sharing='abm4 abm4_pec abm4_pecece' ;;
    *) return 0 ;;
    esac
    models euler | grep -qxF "$1" || return 0
    has_turn_line=$(models euler | grep -nxF "$1" | cut -d : -f 1)
    [ "$(echo "$sharing" | cut -d ' ' -f $((has_turn_line % 3 + 1)))" = "$2" ]
}

# fifth SCENE METHOD: whether it is tried this time, $turn of turn_of 5: one-step methods from one table always, of the other
# pairs a fifth.
fifth()
{
    case $2,$turn in
    euler,* | heun,* | rk4,* | *,all) ;;
    *) [ $(($(echo "$1 $2" | cksum | cut -d ' ' -f 1) % 5)) -eq "$turn" ] ;;
    esac
}

# turn_of PARTS ALL FOLDER...: which of so many parts is tried this time, from 0: a checksum of these folders, so that over
# commits each has its turn. `all` if ALL is that, or $TEST_WHOLE is not empty; ALL may be an empty word.
turn_of()
{
    turn_parts=$1
    turn_all=$2
    shift 2
    if [ "$turn_all" = all ] || [ -n "${TEST_WHOLE-}" ]; then
        echo all
        return
    fi
    find "$@" -type f | LC_ALL=C sort | tr '\n' '\0' | xargs -0 cat | cksum | awk -v parts="$turn_parts" '{ print $1 % parts }'
}

# scene NAME [OPTION...]: compiles models/NAME.scene into $out/NAME, with these options of isoc.
scene()
{
    scene_name=$1
    shift
    build/isoc "models/$scene_name.scene" -o "$out/$scene_name" --real "$real" "$@" >"$out/$scene_name.summary" &&
        [ -s "$out/$scene_name/plant.c" ]
}

# program FILE SOURCE...: compiles the sources into $out/FILE. Further flags stand in $EXTRA.
program()
{
    program_file=$1
    shift
    # shellcheck disable=SC2086
    "$CC" $FLAGS $REAL_FLAG ${EXTRA-} "$@" -o "$out/$program_file" -lm
}

# beside_table SOURCE SCENE: the program of the source, named as that, with the plant of the scene and $out/table.h, which has what
# is expected of it, in the present number type.
beside_table()
{
    build/isoc "$2" -o "$out/plant" --real "$real" >"$out/summary" 2>"$out/told" &&
        EXTRA="-I$out -DPLANT=\"$out/plant/plant.c\"" program "$(basename "$1" .c)" "$1" tests/host/report.c
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

# pivots_in FILE: of how many pivots the settle of this plant tells; empty where of none.
pivots_in()
{
    sed -n 's/^    real pivots\[\([0-9]*\)\];$/\1/p' "$1" | head -n 1
}

# joined NAME COMMAND...: runs a command that prints TAP and joins its results, each headed by NAME.
joined()
{
    joined_name=$1
    shift
    joined_status=0
    "$@" >"$out/tap" || joined_status=$?
    awk -v name="$joined_name" -v n="$tests" '
        /^1\.\.[0-9]+$/ { next }
        match($0, /^(not )?ok [0-9]+ - /) {
            sub(/[0-9]+ - /, ++n " - " name ": ")
        }
        { print }' "$out/tap"
    ran=$(grep -c '^\(not \)\{0,1\}ok ' "$out/tap")
    failed=$(grep -c '^not ok ' "$out/tap")
    tests=$((tests + ran))
    failures=$((failures + failed))
    if ! grep -q "^1\.\.$ran\$" "$out/tap" || { [ "$joined_status" -ne 0 ] && [ "$failed" -eq 0 ]; }; then
        result 1 "$joined_name: ended with status $joined_status"
    fi
}

# finish: the plan, and the script's exit status.
finish()
{
    echo "1..$tests"
    [ "$failures" -eq 0 ] && [ "$tests" -gt 0 ]
    exit
}
