#!/bin/sh
# The methods at equal step and at equal error, as a Markdown table, with answers; with inputs that keep their values,
# and for a scene with inputs in a loop, where they change at every tick. Called by `make bench`; all files are in
# build/bench/NAME/.
# shellcheck disable=SC2086
WHAT="make bench"
dir=build/bench/$FOLDER
. tools/measure/methods.sh
error=1e-6
export error

start
each search double $METHODS
each instructions float $METHODS

build/isoc --methods >"$dir/methods.md"
for method in $METHODS; do
    echo "$method $(cat "$dir/double-$method/bench" "$dir/float-$method/instructions" | tr '\n' ' ')"
done | compute bench -v time="$time" -v step="$step" -v error="$error" "$dir/methods.md" -

[ "$inputs" -gt 0 ] || exit 0
loop_references
each search_in_loop double $fixed
echo
for method in $fixed; do
    echo "$method $(cat "$dir/double-$method/loop" "$dir/float-$method/instructions" "$dir/smooth_float-$method/instructions" | tr '\n' ' ')"
done | compute loop -v time="$time" -v step="$step" -v error="$error"
