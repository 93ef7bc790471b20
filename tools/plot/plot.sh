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
    rm -f "$dir/$kind.svg" "$dir/$kind.png"
    awk -v kind=$kind -f tools/plot/plot.awk \
        part=scene - part=run "$dir/summary.txt" part=trace "$dir/trace.csv" <"$scene" >"$dir/$kind.gnuplot"
    size=$(sed -n 's/^# size \([0-9]*\) \([0-9]*\)$/\1,\2/p' "$dir/$kind.gnuplot")
    [ -n "$size" ] || continue
    gnuplot -e "set terminal svg size $size font 'sans-serif,11' background rgb 'white'; set output '$dir/$kind.svg'" \
        "$dir/$kind.gnuplot"
    gnuplot -e "set terminal pngcairo size $size font 'sans-serif,9'; set output '$dir/$kind.png'" "$dir/$kind.gnuplot"
    echo "$dir/$kind.svg"
    echo "$dir/$kind.png"
done
