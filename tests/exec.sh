#!/bin/sh
# Runs a test where its folder says: exec.sh build/tests/VARIANT/REAL/PROGRAM, or a script.
# Whatever runs for more than ten minutes is killed, has no plan, and counts as failed. What it takes of the processor, as
# `times` prints it, goes to $TEST_TIMES/NAME, if that is set.
name=$1
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
    set -- "$@" "${TEST_STRIDE:-1}"
    ;;
*.sh | *.t)
    set -- sh "$@"
    ;;
esac
[ -n "${TEST_TIMES-}" ] || exec timeout 600 "$@"
timeout 600 "$@"
status=$?
times >"$TEST_TIMES/$(echo "$name" | tr / :)"
exit $status
