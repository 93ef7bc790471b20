# shellcheck shell=sh
# Plants with what they put right after a step in reach of a test (settled.c); read after tests/host/test.sh.

# settled NAME SOURCE OBJECT [FLAG]: the program $out/NAME.run of the plant in this source, and of the test's object.
settled()
{
    settled_pivots=$(pivots_in "$2")
    EXTRA="-O0 -DPLANT=\"$2\" ${4-} ${settled_pivots:+-DPIVOTS=$settled_pivots}" program "$1.run" tests/core/methods/order/settled.c "$3" \
        tests/host/report.c
}
