#!/bin/sh
# Draws a file of gnuplot's commands, as svg and as png beside it, and names both. A line `# size WIDTH HEIGHT` in it is
# the size; where there is none, nothing is to be drawn. With the words of a picture (picture.sh) it writes the file first.
#
#     draw.sh NAME.gnuplot [PICTURE ARGUMENT...]
set -eu
file=$1
shift
[ $# -eq 0 ] || sh "${0%draw.sh}picture.sh" "$@" >"$file"
name=${file%.gnuplot}
for drawn in "$name.svg" "$name.png"; do
    [ ! -e "$drawn" ] || rm -f "$name.svg" "$name.png"
done
size=
while read -r mark word width height; do
    [ "$mark $word" != '# size' ] || size=$width,$height
done <"$file"
[ -n "$size" ] || exit 0

gnuplot -e "set terminal svg size $size font 'sans-serif,11' background rgb 'white'; set output '$name.drawn'" "$file" \
    -e 'reset session' -e "set terminal pngcairo size $size font 'sans-serif,9'; set output '$name.png'" "$file"
LC_ALL=C awk -f "${0%draw.sh}gnuplot.awk" -f "${0%draw.sh}compact.awk" "$name.drawn" >"$name.svg"
rm "$name.drawn"
echo "$name.svg"
echo "$name.png"
