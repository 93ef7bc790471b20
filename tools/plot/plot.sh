#!/bin/sh
# Draws the run in a folder, its trace.csv and summary.txt, with gnuplot: trace.svg and trace.png, all outputs over time;
# path.svg and path.png, the way of a point of the mechanism, if the scene puts one out.
#
#     plot.sh DIR SCENE
set -eu
dir=$1
scene=$2
case $scene in
*.c) scene=/dev/null ;;
esac

for kind in trace path; do
    awk -v kind=$kind -f tools/plot/plot.awk \
        part=scene - part=run "$dir/summary.txt" part=trace "$dir/trace.csv" <"$scene" >"$dir/$kind.gnuplot"
    sh tools/plot/draw.sh "$dir/$kind.gnuplot"
done
