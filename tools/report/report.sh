#!/bin/sh
# Work-precision of every method on one scene. Called by `make report`; everything stands in build/report/NAME/:
# report.txt and report.tsv, the tables; work_precision.svg and .png, the picture.
WHAT="make report"
dir=build/report/$FOLDER
. tools/report/common.sh

start
reference "$time"
first_m4f
for kind in float compensated double; do
    for method in $METHODS; do
        echo $kind "$method"
    done
done >"$dir/all"
each tools/report/measure.sh <"$dir/all"

while read -r kind method; do
    sed "s/^/$kind $method /" "$dir/$kind-$method/measured"
done <"$dir/all" >"$dir/measured.txt"
cut -d ' ' -f 6 "$dir/measured.txt" | sort -u >"$dir/times"
: >"$dir/reference.txt"
while IFS= read -r at; do
    reference "$at"
done <"$dir/times"

build/accuracy errors "$dir/reference.txt" "$dir/measured.txt" >"$dir/report.tsv.new" &&
    mv "$dir/report.tsv.new" "$dir/report.tsv" || exit 1
{
    echo "$NAME after $time s: error of the state, 2-norm over all states in SI units (m, rad, s)"
    echo "Inputs keep their values at the start. The time of a float is the sum of its steps as float has them."
    awk '{ print "Reference after " $1 " s: rk4 and abm4_pecece in double with compensated sums; they differ by " $2 }' \
        "$dir/reference.txt"
    echo
    build/accuracy text "$dir/report.tsv"
} >"$dir/report.txt"

build/plot work_precision "$NAME" "$time" "$dir/report.tsv" >"$dir/work_precision.gnuplot" || exit 1

cat "$dir/report.txt"
echo
echo "$dir/report.txt"
echo "$dir/report.tsv"
sh tools/plot/draw.sh "$dir/work_precision.gnuplot" || fail "gnuplot does not draw $dir/work_precision.gnuplot"
