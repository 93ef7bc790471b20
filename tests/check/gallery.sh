#!/bin/sh
# The pictures of the gallery, models/README.md, are those that `make pictures` draws, one for each model. Those of gnuplot are
# the same to the last byte; in graphs the places are a matter of the machine's fonts. A point that is moved is found.
. tests/host/test.sh
. tests/host/project.sh
begin check/gallery
project

# told FILE: the nodes, edges and texts of a graph; of another drawing all.
told()
{
    if grep -q 'class="graph"' "$1"; then
        grep -o '<title>.*</title>\|>[^<]*</text>' "$1"
    else
        cat "$1"
    fi
}

rm -r "$out/project/models/pictures"
unoptimised
call pictures
expect $? "make pictures"
for scene in models/*.scene hil; do
    picture=models/pictures/$(basename "$scene" .scene).svg
    grep -qF "](${picture#models/})" models/README.md
    result $? "$picture is in models/README.md"
    told "$out/project/$picture" >"$out/drawn"
    told "$picture" | cmp -s - "$out/drawn" && [ "$(wc -c <"$out/drawn")" -gt 50 ]
    result $? "it is what make pictures draws"
    [ "$(wc -c <"$picture")" -lt 45000 ]
    result $? "it has $(wc -c <"$picture") bytes, fewer than 45,000"
done
told "$out/project/models/pictures/pendulum.svg" >"$out/drawn"
sed '0,/ L1/s// L2/; 0,/d=.M1/s//d='"'"'M2/' models/pictures/pendulum.svg >"$out/changed.svg"
! cmp -s models/pictures/pendulum.svg "$out/changed.svg" && ! told "$out/changed.svg" | cmp -s - "$out/drawn"
result $? "found: a point that is moved"
finish
