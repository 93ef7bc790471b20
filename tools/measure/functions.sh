#!/bin/sh
# The functions of core/numbers as a table: domain, largest error, and the instructions of a call that is inlined, with
# the constants that it loads, without those that load its arguments and keep its result. The errors are the bounds that
# the tests in tests/core/numbers/exhaustive hold. Called by `make functions`, with the compiler and objdump in $COMPILE
# and $OBJDUMP.
set -eu
out=build/functions
mkdir -p "$out"

# word | header | arguments | value | bound, or its file and name in tests/core/numbers/exhaustive | domain in float |
# in double | outside of it
list()
{
    cat <<'END'
sin and cos|sincos|1|iso_sincos(x[0])|sincos cosine_bound|up to 10,000|up to 10,000|meaningless; NaN of an infinity and of a NaN
exp|exp|1|iso_exp(x[0])|exp bound|up to 87.33|up to 708.39|the value at the end of the domain; of a NaN too, by its sign
log|log|1|iso_log(x[0])|log bound|from 1.2e-38|from 2.2e-308|below: the value there; below 0: NaN; of an infinity that of the largest number; of a NaN up to 0.7 more, or NaN, by its sign
tanh|tanh|1|iso_tanh(x[0])|tanh bound|all|all|of a NaN 1, with its sign
atan2|angle|2|iso_atan2(x[0], x[1])|angle bound|all|all|of two zeros: 0, or pi where x is -0, with the sign of y; of two infinities, or a NaN: NaN
asin|angle|1|iso_asin(x[0])|angle inverse_bound|up to 1|up to 1|NaN
acos|angle|1|iso_acos(x[0])|angle inverse_bound|up to 1|up to 1|NaN
sqrt|sqrt|1|iso_sqrt(x[0])|0.5|from 0|from 0|NaN; -0 of -0
1 / sqrt|root|1|iso_inverse_root(x[0])|root bound|from 4.0e-31|from 4.1e-292|finite at and near 0; below: NaN; of an infinity 0; of a NaN: NaN
floor|pieces|1|iso_floor(x[0])|exact|all|all|an infinity and a NaN stay
round|pieces|1|iso_round(x[0])|exact|all|all|an infinity and a NaN stay
sign|pieces|1|iso_sign(x[0])|exact|all|all|of a NaN 1, with its sign
abs|real|1|iso_abs(x[0])|exact|all|all|of a NaN: NaN
min, max|real|2|iso_min(x[0], x[1])|exact|all|all|of a NaN: it or the other number
max(x, 0)|real|1|iso_positive(x[0])|exact|all|all|of a NaN: it or 0, by its sign
min(x, 0)|real|1|iso_negative(x[0])|exact|all|all|of a NaN: 0 or it, by its sign
clamp|real|3|iso_clamp(x[0], x[1], x[2])|exact|all|all|of a NaN: it or a limit
comparison|real|2|iso_above(x[0], x[1])|exact|all|all|of a NaN, or of an infinity with itself: 0 or 1
noise, once a tick|noise|1|iso_noise(iso_bits_of(x[0]), 7)|mean 0, variance 1|all ticks|all ticks|
if|pieces|3|iso_where(x[0], x[1]) + iso_unless(x[0], x[2])|exact|all|all|a condition that is a NaN holds or does not
END
}

# The code of each row as a function f1, f2, ... of its arguments x.
{
    echo '#include "core/numbers/turns.h"'
    list | cut -d '|' -f 2 | sort -u | sed 's|.*|#include "core/numbers/&.h"|'
    list | awk -F '|' '{
        name = "f" NR "(real *restrict const y, const real *restrict const x)"
        result = $4 ~ /sincos/ ? "const iso_sine_cosine s = " $4 "; y[0] = s.sin; y[1] = s.cos;" : "y[0] = " $4 ";"
        printf "void %s;\nvoid %s\n{\n    %s\n}\n", name, name, result
    }'
} >"$out/calls.c"
$COMPILE -c "$out/calls.c" -o "$out/calls.o"

# The number of instructions of each; lines of data and padding do not count.
$OBJDUMP -d "$out/calls.o" | awk '
    /^[0-9a-f]+ <f[0-9]+>:/ { row = substr($2, 3) + 0 }
    /^ +[0-9a-f]+:/ && $3 != ".word" && $3 != "nop" { count[row]++ }
    END { for (row in count) print row, count[row] }' >"$out/counts"

echo '| function | domain in float | in double | largest error, ulp | outside of the domain | instructions |'
echo '|---|---|---|---|---|--:|'
list | while IFS='|' read -r word header arguments value error float double outside; do
    row=$((${row:-0} + 1))
    case $error in
    "$header "*)
        error=$(sed -n "s/.*[ ,]${error#* } = \([0-9.]*\)[,;].*/\1/p" "tests/core/numbers/exhaustive/$header.c")
        error=${error%.0}
        ;;
    esac
    [ $row -gt 1 ] || error="$error of 1.0"
    # Its loads, its store and the return are not its own; sine and cosine have a second store.
    own=$(awk -v row=$row -v less=$((arguments + 2 + (row == 1))) '$1 == row { print $2 - less }' "$out/counts")
    echo "| \`$word\` | $float | $double | $error | $outside | $own |"
done
