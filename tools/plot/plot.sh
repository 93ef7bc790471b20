#!/bin/sh
# Draws the run in a folder, its trace.csv, units.csv and summary.txt, with gnuplot: trace.svg and trace.png, all
# outputs over time, or these; path.svg and path.png, the way of a point of the mechanism, if an output is one;
# histogram.svg and histogram.png, the execution times, if the scene asks for them.
#
#     plot.sh DIR [OUTPUT...]
set -eu
folder=$1
shift
sh tools/plot/picture.sh trace "$folder" "$@" >"$folder/trace.gnuplot"
sh tools/plot/picture.sh path "$folder" >"$folder/path.gnuplot"
sh tools/plot/picture.sh histogram "$folder" >"$folder/histogram.gnuplot"
exec sh tools/plot/draw.sh "$folder/trace.gnuplot" "$folder/path.gnuplot" "$folder/histogram.gnuplot"
