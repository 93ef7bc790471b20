#!/bin/sh
# No warning from gcc or clang on the host, nor from the compiler of each port, in float and in double.
# -Wdouble-promotion is among the warnings: with it the float build has no double arithmetic that crept in. Nothing is
# optimised, which takes most of the time: clang warns before, and what gcc's optimiser warns of stops the tests that
# build the same files. The tools and the unit tests are compiled with gcc and these warnings by make itself before any
# test runs, on the host and for the Cortex-M4F, and what belongs to a model's test by that test: of these only clang is
# asked here, and make whether its flags are the same. Files of isoc make compiles a folder at once: here each stands
# alone with gcc too, with all its includes and all warnings.
. tests/host/test.sh
. tests/host/sources.sh
begin check/warnings
# The compilers themselves: what ccache prints has colours.
PATH=${PATH#/usr/lib/ccache:}
turn=$(turn_of 6 "${1-}")
echo "# turn $turn of the tools and the tests for clang, and of isoc's files alone"

plants=$(find core models/*.c -name '*.c' | sort)
host="$plants $(find port/host port/posix port/unix -name '*.c' | sort)"
mkdir -p "$out/code"
root=$PWD

# compile COMMAND FILE...: compiles these files to nothing, many at once; fails if one does not compile in silence, or
# there is none. Clang says all without code, and all of many files in one process, if it is started as clang itself
# starts it, which -### prints; gcc writes some.
compile()
{
    command=$1
    shift
    case $command in
    clang*)
        : >"$out/any.c"
        words=$($command -fsyntax-only -I"$root" "-###" "$out/any.c" 2>&1 |
            sed -n '$s/ "-main-file-name" "[^"]*"//; $s/ "-disable-free"//; $s/ "[^"]*any[.]c"$//p')
        (cd "$out/code" && eval "$words" "$(printf "'$root/%s' " "$@")") >"$out/found" 2>&1
        ;;
    *)
        # shellcheck disable=SC2086
        printf "$root/%s\n" "$@" | (cd "$out/code" && exec xargs -P 2 -n 32 $command -O0 -S -I"$root") >"$out/found" 2>&1
        ;;
    esac
    status=$?
    [ ! -s "$out/found" ] || sed -n '1,40s/^/# /p' "$out/found"
    [ $status -eq 0 ] && [ ! -s "$out/found" ] && [ $# -gt 0 ]
}

of_turn=$(printf '%s\n' $once | awk -v turn="$turn" 'turn == "all" || NR % 6 == turn')
# shellcheck disable=SC2086
compile "clang $FLAGS -D_POSIX_C_SOURCE=200809L -DISO_REAL_DOUBLE" $of_turn
result $? "clang for the host, tools and models' tests"
of_isoc=$(printf '%s\n' $of_turn | grep '^tools/isoc/')
# shellcheck disable=SC2086
[ -n "$of_isoc" ] && compile "gcc -fsyntax-only $FLAGS -D_POSIX_C_SOURCE=200809L -DISO_REAL_DOUBLE" $of_isoc
result $? "gcc for each file of isoc alone"
env -u MAKEFLAGS -u MFLAGS -u MAKELEVEL make -s -f tests/host/ports.mk >"$out/ports"
for real in "" -DISO_REAL_DOUBLE; do
    number=${#real}
    name=$([ -n "$real" ] && echo double || echo float)
    # shellcheck disable=SC2086
    compile "clang $FLAGS $real" $both
    result $? "clang for the host, $name"
    # shellcheck disable=SC2086
    compile "gcc $FLAGS $real" $host
    result $? "gcc for the host, $name"
    while IFS= read -r line; do
        # Half of the ports in this real, the others in the other, by turns.
        number=$((number + 1))
        [ "$turn" = all ] || [ $(((number + turn) % 2)) -eq 0 ] || continue
        port=${line%% *}
        files=${line##* -- }
        [ "$port" != port/cortex-m4f ] || files="$files $plants"
        flags=${line#* * }
        # No double of 64 bits has this compiler, and core refuses the other.
        [ "$name $port" != "double port/atmega1284p" ] || continue
        rest=${line#* }
        # shellcheck disable=SC2086
        compile "${rest%% *} $FLAGS ${flags% -- *} $real" $files
        status=$?
        # shellcheck disable=SC2086
        set -- $files
        result $status "$port by its compiler, $name: $# files"
    done <"$out/ports"
done
# shellcheck disable=SC2086
set -- $host
seen=" $(cat "$out/ports") $*"
unseen=
for file in port/*/*.c; do
    case $seen in
    *" ${file%/*}/"*) ;;
    *) unseen="$unseen $file" ;;
    esac
done
[ -z "$unseen" ]
result $? "each folder of a port is compiled for one:$unseen"

# warns OBJECT [WORD...]: the command by which make, with these words, would compile it has all flags of this test, but
# for those of the optimiser.
warns()
{
    warns_object=$1
    shift
    env -u MAKEFLAGS -u MFLAGS -u MAKELEVEL make "$@" -n -W "$source" "$warns_object" 2>"$out/errors" |
        grep " -c $source -o $warns_object\$" >"$out/command" || return
    read -r asked <"$out/command"
    for flag in $FLAGS; do
        case $flag,$asked in
        -O* | *,*" $flag "*) ;;
        *) return 1 ;;
        esac
    done
}

source=tools/trace/main.c
warns build/obj/tools/trace/main.o
result $? "make compiles the tools with the same warnings"
source=tests/tap.c
for folder in plain/float plain/double m4f/float m4f/double; do
    warns build/tests/$folder/tests/tap.o -f tests/units.mk VARIANT=${folder%/*} REAL=${folder#*/}
    result $? "make compiles the unit tests with the same warnings: $folder"
done
! { FLAGS="$FLAGS -Wcast-qual" && warns build/tests/plain/float/tests/tap.o -f tests/units.mk VARIANT=plain REAL=float; } && [ -s "$out/command" ]
result $? "found: a warning that make does not ask for"
FLAGS=${FLAGS% -Wcast-qual}

# What no compiler takes in silence: a name, and code. First stands what clang tells only where nothing was wrong
# before.
while IFS='|' read -r name code; do
    echo "$code" >"$out/$name.c"
    planted="${planted-} $out/$name.c"
done <<'END'
a_function_that_is_not_used|static int f(void) { return 1; }
a_float_that_turns_into_a_double|float f(float x); float f(float x) { return (float)(x * 0.5); }
a_variable_that_is_not_used|int f(int x); int f(int x) { int y = 1; return x; }
a_name_that_hides_one_outside|extern int y; int f(int x); int f(int x) { const int y = x; return y; }
a_conversion_that_loses_bits|char f(int x); char f(int x) { return x; }
a_way_without_a_value|int f(int x); int f(int x) { if (x) { return 1; } }
an_array_of_variable_length|int f(int n); int f(int n) { int a[n]; a[0] = 1; return a[0]; }
END
{ awk '!seen[$2]++' "$out/ports" | sed 's/ -- .*//' && printf '%s\n' "host gcc" "host clang"; } >"$out/compilers"
while read -r _ compiler flags; do
    # shellcheck disable=SC2086
    compile "$compiler $FLAGS $flags" $planted >"$out/shown"
    found=$(cat "$out/found")
    for file in $planted; do
        # A port may do without a warning of conversions, where its compiler has false ones.
        case $flags:$file in
        *-Wno-conversion*:*/a_conversion_that_loses_bits.c) continue ;;
        esac
        case $found in
        *"${file##*/}:1:"*' error: '*) true ;;
        *) false ;;
        esac
        result $? "found by $compiler: ${file##*/}"
    done
done <"$out/compilers"
# The flags of every build, with the optimiser.
while read -r _ compiler flags; do
    [ "$compiler" != clang ] || continue
    printf 'int g(int); int f(int n); int f(int n) { int x; if (n > 3) { x = g(n); } return g(n) > 2 ? x : 0; }\n' >"$out/planted.c"
    # shellcheck disable=SC2086
    ! $compiler $FLAGS $flags -c "$out/planted.c" -o /dev/null 2>"$out/found" && grep -q maybe-uninitialized "$out/found"
    result $? "found by $compiler where it optimises: a variable that may have no value"
done <"$out/compilers"
finish
