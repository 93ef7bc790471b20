# shellcheck shell=sh
# The independent dynamics, compiled once; read after tests/host/test.sh and `begin`. $solver is what a program that
# uses it is linked with, and $compare is the comparison of a plant with it, in the real of now, after `compare`. It is
# optimised, however little its plants are: it is compiled in a second, and runs for longer.

solver=
quick=$(optimised -O2 && echo "$FLAGS")
for part in tests/isoc/dynamics/motion.c tests/isoc/dynamics/hold.c tests/isoc/dynamics/linear.c tests/isoc/dynamics/solve.c \
    tests/isoc/dynamics/close.c tests/isoc/dynamics/measure.c tests/host/report.c; do
    object=${part##*/}
    object=$out/${object%.c}.o
    # shellcheck disable=SC2086
    "$CC" $quick -c "$part" -o "$object"
    result $? "$part compiles"
    solver="$solver $object"
done

compare()
{
    compare=$solver
    for part in tests/isoc/dynamics/compare.c tests/isoc/dynamics/sample.c tests/isoc/dynamics/balance.c; do
        object=${part##*/}
        object=$out/${object%.c}.$real.o
        # shellcheck disable=SC2086
        "$CC" $quick $REAL_FLAG -c "$part" -o "$object"
        result $? "$part compiles in $real"
        compare="$compare $object"
    done
}
