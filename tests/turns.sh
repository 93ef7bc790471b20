#!/bin/sh
# Runs each turn of a test as `make test` runs one that begins with no object compiled, and prints for each the seconds
# of processor time, the processes, and `ok` or what failed; all that it printed is in build/tests/turns/TEST/TURN. The
# last line is a row for tests/starts: the most processes that a turn started, the test, how many turns were run.
#
#     turns.sh TEST [TURN...]
#
# The status is 0 if each passed, and none started more than the row in tests/starts allows.
test=$1
shift
parts=$(sed -n 's/^turns=\([0-9]\{1,2\}\)$/\1/p; s/.*turn_of \([0-9]\{1,2\}\) .*/\1/p' "$test" | sort -n | tail -n 1)
[ $# -gt 0 ] || [ -n "$parts" ] || {
    echo "$test has no turns, or more than 99: then it is told which" >&2
    exit 1
}
[ $# -gt 0 ] || set -- $(seq 0 $((parts - 1)))
mkdir -p build
(unset MAKEFLAGS MAKELEVEL && flock build/lock make -s tools build/tests/requests build/tests/shared build/simavr_trace build/tests/once/once build/tests/measured >&2) || exit 1
out=build/tests/turns/$test
rm -rf "$out"
mkdir -p "$out/once"
cp -RP build/tests/once/[!s]* "$out/once" && export TEST_BUILT=yes PATH="$PWD/$out/once:$PATH" || exit 1
failures=0 most=0
for TEST_TURN; do
    export TEST_TURN
    rm -rf "$out/once/store"
    mkdir "$out/once/store"
    said=ok
    build/tests/measured 1800 "$out/takes" sh "$test" >"$out/$TEST_TURN" 2>&1 || said="failed, see $out/$TEST_TURN"
    [ "$said" = ok ] || failures=$((failures + 1))
    read -r seconds started <"$out/takes"
    [ "$started" = - ] || [ "$started" -le "$most" ] || most=$started
    printf 'turn %3d %7.1f s %6s processes: %s\n' "$TEST_TURN" "$seconds" "$started" "$said"
    grep '^not ok' "$out/$TEST_TURN"
done
rm -rf "$out/once"
budget=$(awk -v test="$test" '$2 == test { print $1 }' tests/starts)
printf '%7d %s %d\n' "$most" "$test" $#
[ "$most" -le "$((${budget:-100} * 11 / 10 + 20))" ] || {
    echo "$test: its budget in tests/starts is ${budget:-100}"
    failures=$((failures + 1))
}
[ "$failures" -eq 0 ]
