#!/bin/sh
# Runs a test where its folder says: exec.sh build/tests/VARIANT/REAL/PROGRAM, or a script. A program of a whole domain
# is told how few numbers to try, and a number made of the text of core, which says whose turn it is. Whatever runs for
# more than half an hour is killed, has no plan, and counts as failed. Under the harness the seconds of the processor
# that it takes go to $TEST_TAKES/NAME.
#
# If the harness found that it passed, with the hash $TEST_STATE of all that a test follows from (tests/host/state.sh),
# what it printed then is printed again, and the test is not run.
#
# Tools and programs that have changed are built first; not under the harness, which has built all, and says so in
# $TEST_BUILT.
name=$1
if [ -z "${TEST_BUILT-}" ]; then
    mkdir -p build
    case $1 in
    build/tests/*/float/* | build/tests/*/double/*) goals="tools $1" ;;
    *) goals='tools build/tests/requests build/simavr_trace build/import' ;;
    esac
    # shellcheck disable=SC2086
    (unset MAKEFLAGS MAKELEVEL && flock build/lock make -s $goals >&2) || exit 1
    export TEST_BUILT=yes
fi
case $1 in
build/tests/memcheck/*)
    set -- valgrind --quiet --error-exitcode=99 --leak-check=full --show-leak-kinds=all \
        --errors-for-leak-kinds=all "$@"
    ;;
build/tests/m4f/*)
    set -- qemu-system-arm -M mps2-an386 -icount shift=10,align=off,sleep=off -display none -monitor none \
        -serial none -semihosting-config enable=on,target=native -kernel "$1"
    ;;
build/tests/exhaustive/*)
    [ -z "${TEST_WHOLE-}" ] || TEST_STRIDE=all
    set -- "$@" "${TEST_STRIDE:-1}" "$(cat core/*/*.[ch] | cksum | cut -d ' ' -f 1)"
    ;;
*.sh | *.t)
    set -- sh "$@"
    ;;
*.py)
    set -- pytest-3 -p no:cacheprovider --no-header -q --tap "$@"
    ;;
esac
[ -n "${TEST_TAKES-}" ] || exec timeout 1800 "$@"

kept=$TEST_KEPT/$name
if [ -n "$TEST_STATE" ] && [ -f "$kept/state" ] && read -r state <"$kept/state" && [ "$state" = "$TEST_STATE" ]; then
    echo "# not run again: it passed, and nothing that it follows from has changed since"
    exec cat "$kept/output"
fi
# A test that calls this for a program of its own is measured with it.
takes=$TEST_TAKES/$name
unset TEST_TAKES
timeout 1800 "$@"
status=$?
times >"$takes"
exit $status
