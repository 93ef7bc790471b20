#!/bin/sh
# Draws files of gnuplot's commands, each as svg and as png beside it, and names both. A line `# size WIDTH HEIGHT` in
# it is the size; where there is none, nothing is to be drawn. With DRAWN=svg in the environment it draws no png. With
# the words of a picture (picture.sh) it writes the file first.
#
#     draw.sh NAME.gnuplot [PICTURE ARGUMENT...]
#     draw.sh NAME.gnuplot NAME.gnuplot...
set -eu
case ${2-} in
'' | *.gnuplot) ;;
*)
    file=$1
    shift
    sh "${0%draw.sh}picture.sh" "$@" >"$file"
    set -- "$file"
    ;;
esac

# draw FILE...: by one gnuplot, which looks for its fonts once.
draw()
{
    for file; do
        shift
        name=${file%.gnuplot}
        for drawn in "$name.svg" "$name.png" "$name.drawn"; do
            [ ! -e "$drawn" ] || rm -f "$name.svg" "$name.png" "$name.drawn"
        done
        size=
        while read -r mark word width height; do
            [ "$mark $word" != '# size' ] || size=$width,$height
        done <"$file"
        [ -n "$size" ] || continue
        set -- "$@" -e "set terminal svg size $size font 'sans-serif,11' background rgb 'white'; set output '$name.drawn'" "$file" \
            -e 'reset session'
        [ "${DRAWN-}" = svg ] ||
            set -- "$@" -e "set terminal pngcairo size $size font 'sans-serif,9'; set output '$name.png'" "$file" -e 'reset session'
    done
    [ $# -eq 0 ] || gnuplot "$@"
}

draw "$@"
for file; do
    shift
    [ ! -e "${file%.gnuplot}.drawn" ] || set -- "$@" "${file%.gnuplot}.drawn"
done
[ $# -gt 0 ] || exit 0
LC_ALL=C awk -f "${0%draw.sh}gnuplot.awk" -f "${0%draw.sh}compact.awk" "$@"
rm "$@"
for drawn; do
    echo "${drawn%.drawn}.svg"
    [ "${DRAWN-}" = svg ] || echo "${drawn%.drawn}.png"
done
