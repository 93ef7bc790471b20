#!/bin/sh
# Work-precision of every method on one scene. Called by `make report`; everything stands in build/report/NAME/:
# report.html, the page (page.sh); report.txt and report.tsv, the tables; work_precision.svg and .png, the picture. Of a
# scene with inputs, whose inputs keep their values there, also in a loop, where they change at every tick: loop.tsv,
# loop.svg and loop.png.
WHAT="make report"
dir=build/report/$FOLDER
. tools/measure/methods.sh

# drawn NAME: names the picture, where there was something to draw.
drawn()
{
    [ ! -e "$dir/$1.svg" ] || printf '%s\n' "$dir/$1.svg" "$dir/$1.png"
}

start
# shellcheck disable=SC2086
each points "float compensated double" $METHODS
measured=
while read -r kind method; do
    measured="$measured $dir/$kind-$method/measured"
done <"$dir/each"
# shellcheck disable=SC2086
cat $measured >"$dir/measured.txt"
: >"$dir/reference.txt"
references "$dir/measured.txt"

compute reference -f tools/measure/errors.awk "$dir/reference.txt" "$dir/measured.txt" >"$dir/report.tsv.new" &&
    mv "$dir/report.tsv.new" "$dir/report.tsv" || exit 1
{
    echo "$NAME after $time s: error of the state, 2-norm over all states in SI units (m, rad, s)"
    echo "${resting:-Inputs keep their values at the start.} The time of a float is the sum of its steps as float has them."
    awk '{ print "Reference after " $1 " s: rk4 and abm4_pecece in double with compensated sums; they differ by " $2 }' \
        "$dir/reference.txt"
    echo
    compute text "$dir/report.tsv"
} >"$dir/report.txt"

# looped KIND REFERENCE: the table of a loop with inputs of this kind.
looped()
{
    for method in $fixed; do
        cat "$dir/double-$method/looped-$1"
    done >"$dir/looped.txt"
    compute reference -f tools/measure/errors.awk "$dir/$2.txt" "$dir/looped.txt"
}

# Where the methods do not agree on the motion in the loop, the report has no loop.
rm -f "$dir/loop.tsv"
if [ "$inputs" -gt 0 ] && ! (loop_references) 2>"$dir/unlooped"; then
    sed 's/^make report: /In a loop: /' "$dir/unlooped" >>"$dir/report.txt"
    inputs=0
fi
if [ "$inputs" -gt 0 ]; then
    # shellcheck disable=SC2086
    each points_in_loop double $fixed
    { looped smooth smooth && looped held restarted >"$dir/held.rows" && sed 1d "$dir/held.rows"; } >"$dir/loop.tsv" || exit 1
    {
        echo
        echo "In a loop: inputs change at every tick (tools/measure/signals.h, or recorded). Held inputs against the staircase with ticks"
        echo "of $step s, smooth ones, sampled at every step, against the continuous signal"
        echo
        compute text "$dir/loop.tsv"
    } >>"$dir/report.txt"
    picture loop work_precision "$NAME in a loop" "$time" "$dir/loop.tsv"
fi
picture work_precision work_precision "$NAME" "$time" "$dir/report.tsv"
. tools/measure/page.sh

cat "$dir/report.txt"
printf '%s\n' '' "$dir/report.html" "$dir/report.txt" "$dir/report.tsv"
[ "$inputs" -eq 0 ] || {
    echo "$dir/loop.tsv"
    drawn loop
}
drawn work_precision
