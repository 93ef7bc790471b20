#!/bin/sh
# Runs each turn of a test as `make test` runs one, and prints for each `ok` or what failed; all that it printed is in
# build/tests/turns/TEST/TURN.
#
#     turns.sh TEST [TURN...]
#
# The status is 0 if each passed.
test=$1
shift
parts=$(sed -n 's/^turns=\([0-9]\{1,2\}\)$/\1/p; s/.*turn_of \([0-9]\{1,2\}\)[ )].*/\1/p; s/.*[^a-z]turn(\([0-9]\{1,2\}\)[,)].*/\1/p' "$test" | sort -n | tail -n 1)
[ $# -gt 0 ] || [ -n "$parts" ] || {
    echo "$test has no turns, or more than 99: then it is told which" >&2
    exit 1
}
[ $# -gt 0 ] || set -- $(seq 0 $((parts - 1)))
out=build/tests/turns/$test
rm -rf "$out"
mkdir -p "$out"
failures=0
for TEST_TURN; do
    export TEST_TURN
    said=ok
    pytest-3 "$test" >"$out/$TEST_TURN" 2>&1 || said="failed, see $out/$TEST_TURN"
    [ "$said" = ok ] || failures=$((failures + 1))
    echo "turn $TEST_TURN: $said"
    grep '^not ok' "$out/$TEST_TURN"
done
[ "$failures" -eq 0 ]
