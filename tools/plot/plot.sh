#!/bin/sh
# Draws the run in a folder, its trace.csv, units.csv and summary.txt, with gnuplot: trace.svg and trace.png, all outputs over time,
# or these; path.svg and path.png, the way of a point of the mechanism, if an output is one;
# histogram.svg and histogram.png, the execution times, if the scene asks for them.
#
#     plot.sh DIR [OUTPUT...]
set -eu
folder=$1
shift
sh tools/plot/draw.sh "$folder/trace.gnuplot" trace "$folder" "$@"
sh tools/plot/draw.sh "$folder/path.gnuplot" path "$folder"
sh tools/plot/draw.sh "$folder/histogram.gnuplot" histogram "$folder"
