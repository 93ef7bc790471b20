#!/bin/sh
# Writes gnuplot's commands for a picture: first a comment with the size, `# size WIDTH HEIGHT`; nothing where there is
# nothing to draw. NAME.awk beside it defines the picture NAME; tables that it reads have tabs between their cells.
#
#     picture.sh trace DIRECTORY [OUTPUT...]          of a run: trace.csv, units.csv and summary.txt there
#     picture.sh path DIRECTORY
#     picture.sh histogram DIRECTORY
#     picture.sh work_precision SCENE TIME report.tsv
#     picture.sh violation SCENE measured
#     picture.sh effects SCENE TARGET effects.tsv
#     picture.sh growth SCENE growth.tsv
#     picture.sh local_error SCENE local_error.tsv
#     picture.sh singular SCENE singular.tsv
#     picture.sh regions SCENE METHOD regions.tsv
#     picture.sh sweep SCENE random|listed columns.tsv sweep.tsv
#     picture.sh compare DIRECTORY DIRECTORY
#     picture.sh differences DIRECTORY DIRECTORY      as a table
#     picture.sh account DIRECTORY                    likewise
set -eu
here=${0%/*}
name=$1
shift
case $name in
trace | path | histogram | account) of="signals" ;;
work_precision | regions) of="looks" ;;
compare | differences) of="signals compared" ;;
*) of= ;;
esac
for file in $name $of gnuplot; do
    set -- -f "$here/$file.awk" "$@"
done
export LC_ALL=C
case $name in
work_precision) build/isoc --methods | awk -F '\t' "$@" ;;
*) exec awk -F '\t' "$@" ;;
esac
