#!/bin/sh
# Draws the run in a folder, its trace.csv, units.csv and summary.txt, with gnuplot: trace.svg and trace.png, all outputs over time;
# path.svg and path.png, the way of a point of the mechanism, if an output is one.
#
#     plot.sh DIR
set -eu
for kind in trace path; do
    build/plot $kind "$1" >"$1/$kind.gnuplot"
    sh tools/plot/draw.sh "$1/$kind.gnuplot"
done
