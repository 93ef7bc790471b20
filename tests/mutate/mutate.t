#!/bin/sh
# tests/mutate.sh in a small project: a weak test lets mutations survive, which are listed with their place; a better
# one lets none; what is tried is not tried again; the files of the project stay as they are.
. tests/host/test.sh
begin mutate
mini=$out/mini
mkdir -p "$mini/core/numbers" "$mini/port" "$mini/tests/core/numbers" "$mini/tools/build"
cp tools/build/numerics "$mini/tools/build"
cp -r port/* "$mini/port"
mkdir "$mini/tests/mutate"
cp tests/mutate/mutate.py tests/mutate/equivalent.txt "$mini/tests/mutate"
cp tests/mutate.sh tests/tap.c tests/tap.h tests/times "$mini/tests"
cp -r core/application core/runtime core/methods "$mini/core"
cp core/numbers/*.h "$mini/core/numbers"
cat >"$mini/core/numbers/toy.h" <<'END'
static inline int toy(const int a, const int b)
{
    return a > b ? a - b : 7; /* a + b in a comment is left alone */
}
END

# unit CONDITION: the test of it.
unit()
{
    printf '#include "core/numbers/toy.h"\n#include "tests/tap.h"\nint main(void)\n{\n    tap_ok(%s, "toy");\n    tap_done();\n}\n' "$1" >"$mini/tests/core/numbers/toy.c"
}

# mutate: its answer in $out/answer.
mutate()
{
    (cd "$mini" && sh tests/mutate.sh core/numbers/toy.h) >"$out/answer" 2>&1
}

cp "$mini/core/numbers/toy.h" "$out/toy.h"
unit 'toy(3, 1) == 2'
! mutate && grep -q '^core/numbers/toy.h:3:13: return a > b ? .* ->  return a >= b ? ' "$out/answer" &&
    grep -q '^core/numbers/toy.h:3:28: .* : 8;' "$out/answer"
result $? "found: a weak test, by two mutations that survive: $(tail -n 1 "$out/answer")"
grep -q ': 4 mutations of 4: 2 killed, 2 survived, 0 equivalent' "$out/answer"
result $? "and it finds the other two"
unit 'toy(3, 1) == 2 && toy(1, 3) == 7 && toy(2, 2) == 7'
AGAIN=yes mutate && grep -q ': 4 killed, 0 survived' "$out/answer"
result $? "a better test finds all"
sed -i 's/tests\/core\/numbers\/toy.c$/survived/' "$mini/build/tests/mutations/results"
! mutate && grep -q ', 4 survived' "$out/answer"
result $? "what is tried is taken over from the results"
unit 'false'
! mutate && grep -q 'a test fails without a mutation: tests/core/numbers/toy.c' "$out/answer"
result $? "refused: a test that fails without a mutation"
cmp -s "$out/toy.h" "$mini/core/numbers/toy.h"
result $? "the file is as it was"
finish
