#!/bin/sh
# Draws a file of gnuplot's commands, as svg and as png beside it, and names both. A line `# size WIDTH HEIGHT` in it is
# the size; where there is none, nothing is to be drawn.
#
#     draw.sh NAME.gnuplot
set -eu
name=${1%.gnuplot}
for file in "$name.svg" "$name.png"; do
    [ ! -e "$file" ] || rm -f "$name.svg" "$name.png"
done
size=
while read -r mark word width height; do
    [ "$mark $word" != '# size' ] || size=$width,$height
done <"$1"
[ -n "$size" ] || exit 0

gnuplot -e "set terminal svg size $size font 'sans-serif,11' background rgb 'white'; set output '$name.drawn'" "$1" \
    -e 'reset session' -e "set terminal pngcairo size $size font 'sans-serif,9'; set output '$name.png'" "$1"
LC_ALL=C awk -f "${0%draw.sh}gnuplot.awk" -f "${0%draw.sh}compact.awk" "$name.drawn" >"$name.svg"
rm "$name.drawn"
echo "$name.svg"
echo "$name.png"
