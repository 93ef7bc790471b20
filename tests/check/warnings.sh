#!/bin/sh
# No warning from gcc or clang, on the host and for the Cortex-M4F, in float and in double. -Wdouble-promotion is among
# the warnings: with it the float build has no double arithmetic that crept in. Nothing is optimised, which takes
# most of the time: clang warns before, and what gcc's optimiser warns of stops the tests that build the same files.
# The tools and the unit tests are compiled with gcc and these warnings by make itself before any test runs, and what
# belongs to a model's test by that test: of these only clang is asked here, and make whether its flags are the same. Files
# of isoc make compiles a folder at once: here each stands alone with gcc too, with all its includes and all warnings.
. tests/host/test.sh
. tests/host/sources.sh
begin check/warnings
turn=$(turn_of 3 "${1-}" tools tests)
echo "# turn $turn of the tools and the tests for clang, and of isoc's files alone"

target=$(find core port/mps2 models/*.c tests/unit tests/tap.c -name '*.c' | sort)
m4f="-mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16"

# compile COMMAND FILE...: compiles each file to nothing; fails if one does not compile in silence.
compile()
{
    command=$1
    shift
    case $command in
    clang*) command="$command -fsyntax-only" ;;
    *) command="$command -O0 -S -o /dev/null" ;;
    esac
    printf '%s\n' "$@" | xargs -P 2 -I{} $command {} >"$out/found" 2>&1
    status=$?
    sed 's/^/# /' "$out/found" | head -n 40
    [ $status -eq 0 ] && [ ! -s "$out/found" ]
}

of_turn=$(printf '%s\n' $once | awk -v turn="$turn" 'turn == "all" || NR % 3 == turn')
# shellcheck disable=SC2086
compile "clang $FLAGS -D_POSIX_C_SOURCE=200809L -DISO_REAL_DOUBLE" $of_turn
result $? "clang for the host, tools and models' tests"
of_isoc=$(printf '%s\n' $of_turn | grep '^tools/isoc/')
# shellcheck disable=SC2086
[ -n "$of_isoc" ] && compile "gcc -fsyntax-only $FLAGS -D_POSIX_C_SOURCE=200809L -DISO_REAL_DOUBLE" $of_isoc
result $? "gcc for each file of isoc alone"
for real in "" -DISO_REAL_DOUBLE; do
    name=$([ -n "$real" ] && echo double || echo float)
    # shellcheck disable=SC2086
    compile "clang $FLAGS $real" $both
    result $? "clang for the host, $name"
    # shellcheck disable=SC2086
    compile "gcc $FLAGS $real" $host
    result $? "gcc for the host, $name"
    # shellcheck disable=SC2086
    compile "arm-none-eabi-gcc $FLAGS $m4f $real" $target
    result $? "gcc for the Cortex-M4F, $name"
done

# warns OBJECT: the command by which make would compile it has all flags of this test, but for those of the optimiser.
warns()
{
    env -u MAKEFLAGS -u MFLAGS -u MAKELEVEL make -n -W "$source" "$1" 2>"$out/errors" | grep " -c $source -o $1\$" >"$out/command" || return
    for flag in $FLAGS; do
        [ "${flag#-O}" = "$flag" ] || continue
        grep -qF -- " $flag " "$out/command" || return
    done
}

source=tools/trace/main.c
warns build/obj/tools/trace/main.o
result $? "make compiles the tools with the same warnings"
source=tests/tap.c
for folder in plain/float plain/double m4f/float m4f/double; do
    warns build/tests/$folder/tests/tap.o
    result $? "make compiles the unit tests with the same warnings: $folder"
done
! { FLAGS="$FLAGS -Wcast-qual" && warns build/tests/plain/float/tests/tap.o; } && [ -s "$out/command" ]
result $? "found: a warning that make does not ask for"
FLAGS=${FLAGS% -Wcast-qual}

# planted COMPILER NAME CODE: the code must not compile in silence.
planted()
{
    printf '%s\n' "$3" >"$out/planted.c"
    ! compile "$1 $FLAGS" "$out/planted.c" >/dev/null
    result $? "found by $1: $2"
}

for compiler in gcc clang arm-none-eabi-gcc; do
    planted $compiler "a float that turns into a double" 'float f(float x); float f(float x) { return (float)(x * 0.5); }'
    planted $compiler "a variable that is not used" 'int f(int x); int f(int x) { int y = 1; return x; }'
    planted $compiler "a name that hides one outside" 'extern int y; int f(int x); int f(int x) { const int y = x; return y; }'
    planted $compiler "a conversion that loses bits" 'char f(int x); char f(int x) { return x; }'
    planted $compiler "a function that is not used" 'static int f(void) { return 1; }'
    planted $compiler "a way without a value" 'int f(int x); int f(int x) { if (x) { return 1; } }'
    planted $compiler "an array of variable length" 'int f(int n); int f(int n) { int a[n]; a[0] = 1; return a[0]; }'
done
# The flags of every build, with the optimiser.
for compiler in gcc arm-none-eabi-gcc; do
    printf 'int g(int); int f(int n); int f(int n) { int x; if (n > 3) { x = g(n); } return g(n) > 2 ? x : 0; }\n' >"$out/planted.c"
    # shellcheck disable=SC2086
    ! $compiler $FLAGS -c "$out/planted.c" -o /dev/null 2>"$out/found" && grep -q maybe-uninitialized "$out/found"
    result $? "found by $compiler where it optimises: a variable that may have no value"
done
finish
