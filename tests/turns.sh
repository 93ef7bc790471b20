#!/bin/sh
# Runs each turn of a test as `make test` runs one, and prints for each the seconds of processor time, the processes, and `ok` or
# what failed. The last line is a row for tests/starts: the most processes that a turn started, the test, how many turns were run.
#
#     turns.sh TEST [TURN...]
#
# The status is 0 if each passed, and none started more than the row in tests/starts allows. A test that prints the last lines
# of a turn that failed writes all of it to build/tests/turns/TEST/TURN.
test=$1
shift
parts=$(sed -n 's/.*turn_of \([0-9]\{1,2\}\) .*/\1/p' "$test" | sort -n | tail -n 1)
[ $# -gt 0 ] || [ -n "$parts" ] || {
    echo "$test has no turns, or more than 99: then it is told which" >&2
    exit 1
}
[ $# -gt 0 ] || set -- $(seq 0 $((parts - 1)))
mkdir -p build
(unset MAKEFLAGS MAKELEVEL && flock build/lock make -s tools build/simavr_trace build/tests/once/once build/tests/measured >&2) || exit 1
out=build/tests/turns/$test
mkdir -p "$out"
export TEST_BUILT=yes PATH="$PWD/build/tests/once:$PATH"
failures=0 most=0
for TEST_TURN; do
    export TEST_TURN
    said=ok
    build/tests/measured 1800 "$out/takes" sh "$test" >"$out/$TEST_TURN" 2>&1 || said="failed, see $out/$TEST_TURN"
    [ "$said" = ok ] || failures=$((failures + 1))
    read -r seconds started <"$out/takes"
    [ "$started" = - ] || [ "$started" -le "$most" ] || most=$started
    printf 'turn %3d %7.1f s %6s processes: %s\n' "$TEST_TURN" "$seconds" "$started" "$said"
    grep '^not ok' "$out/$TEST_TURN"
done
budget=$(awk -v test="$test" '$2 == test { print $1 }' tests/starts)
printf '%7d %s %d\n' "$most" "$test" $#
[ "$most" -le "$((${budget:-100} * 11 / 10 + 20))" ] || {
    echo "$test: its budget in tests/starts is ${budget:-100}"
    failures=$((failures + 1))
}
[ "$failures" -eq 0 ]
