#!/bin/sh
# Runs a test where its folder says: exec.sh build/tests/VARIANT/REAL/PROGRAM, or a script.
# Whatever runs for more than ten minutes is killed, has no plan, and counts as failed.
limit="timeout 600"
case $1 in
build/tests/memcheck/*)
    exec $limit valgrind --quiet --error-exitcode=99 --leak-check=full --show-leak-kinds=all \
        --errors-for-leak-kinds=all "$@"
    ;;
build/tests/m4f/*)
    exec $limit qemu-system-arm -M mps2-an386 -icount shift=10,align=off,sleep=off -display none -monitor none \
        -serial none -semihosting-config enable=on,target=native -kernel "$1"
    ;;
build/tests/exhaustive/*)
    exec $limit "$@" "${TEST_STRIDE:-1}"
    ;;
*.sh | *.t)
    exec $limit sh "$@"
    ;;
*)
    exec $limit "$@"
    ;;
esac
