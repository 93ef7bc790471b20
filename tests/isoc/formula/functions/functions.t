#!/bin/sh
# Functions in the formulas of a scene: their values, their bits on the board, and that they are not there where nobody
# calls them.
. tests/host/test.sh
begin functions
one_isoc

# run TARGET REAL: all.scene for 5 s; the trace in $trace, the hash in $hash.
run()
{
    tools/isochron run tests/isoc/formula/functions/all.scene --seconds 5 --target "$1" --real "$2" >"$out/run" 2>&1
    trace=$(sed -n 's/^trace //p' "$out/run")
    hash=$(sed -n 's/^hash //p' "$out/run")
}

for number in float double; do
    real $number
    program all tests/isoc/formula/functions/all.c tests/tap.c port/host/*.c port/unix/console.c
    run host $number
    joined "$number" sh -c "'$out/all' <'$trace'"
done
run host float
host=$hash
run cortex-m4f float
[ -n "$host" ] && [ "$host" = "$hash" ]
result $? 'the same bits on the board'
grep -q '^instructions_per_step [0-9]*$' "$out/run"
result $? 'each step takes one number of instructions there'

# The planted error: the minimum in place of the maximum.
sed 's/max(q, v, -0.3)/min(q, v, -0.3)/' tests/isoc/formula/functions/all.scene >"$out/planted.scene"
tools/isochron run "$out/planted.scene" --seconds 2 --real double >"$out/run" 2>&1
! "$out/all" <"$(sed -n 's/^trace //p' "$out/run")" >"$out/tap" && grep -q '^not ok 16 - output 15' "$out/tap"
result $? 'found: a wrong function'

# The step and the outputs with all of the plant's memory undefined, by both compilers.
real float
cat >"$out/cases.c" <<END
#include <stddef.h>
#include "tests/promises/poison.h"
const poison_case poison_cases[] = {{"all", &iso_the_plant}, {NULL, NULL}};
END
isoc "$out/summary" '' tests/isoc/formula/functions/all.scene -o "$out/all_of_them"
for compiler in $CC clang; do
    CC=$compiler EXTRA="-I$out/all_of_them" program "poisoned.$compiler" "$out/cases.c" tests/promises/poison.c \
        "$out/all_of_them/plant.c"
    joined "$compiler" valgrind --quiet "$out/poisoned.$compiler"
done

# In a folder of its own.
isoc "$out/summary" '' tests/isoc/formula/functions/all.scene -o "$out/alone" --name alone --standalone
"$CC" -std=c11 -O2 -I"$out/alone" -c "$out/alone/alone.c" -o "$out/alone.o"
result $? 'a plant with every function compiles alone'

# Tables beyond their places; the control is one that does not end.
for number in float double; do
    real "$number"
    isoc "$out/summary" '' tests/isoc/formula/functions/table.scene -o "$out/table" --real "$number"
    EXTRA="-I$out/table" program ends tests/isoc/formula/functions/table.c tests/tap.c port/host/*.c port/unix/console.c "$out/table/plant.c"
    joined "table, $number" "$out/ends"
done
sed -i 's/iso_min(\(.*\), R(1.0))/(\1)/' "$out/table/plant.c"
EXTRA="-I$out/table" program planted tests/isoc/formula/functions/table.c tests/tap.c port/host/*.c port/unix/console.c "$out/table/plant.c" && ! "$out/planted" >"$out/tap"
result $? 'found: a table without an end'

# A plant includes the files of the functions that it calls.
isoc "$out/summary" '' models/pendulum.scene -o "$out/plain" && ! grep -E 'exp|log|tanh|numbers/angle|iso_angle|iso_atan2|pieces|sqrt' "$out/plain/plant.c"
result $? 'a scene without functions includes none'
for word in exp log tanh sqrt; do
    sed "s/^output rate.*/output rate = $word(2 + speed of pivot \/ (1 rad\/s))/" models/pendulum.scene >"$out/one.scene"
    isoc "$out/summary" '' "$out/one.scene" -o "$out/one" &&
        [ "$(grep -oE 'numbers/(exp|log|tanh|angle|pieces|sqrt)' "$out/one/plant.c")" = "numbers/$word" ]
    result $? "with $word that file alone"
done
finish
