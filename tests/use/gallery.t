#!/bin/sh
# The pictures of the gallery, models/README.md, are those that `isochron pictures` draws, one for each model. Those of
# gnuplot are the same to the last byte; in graphs the places are a matter of the machine's fonts. A point that is moved
# is found.
. tests/host/test.sh
. tests/host/project.sh
begin check/gallery
project

# compared NAME FILE DRAWN...: of each picture a line: its name, whether the gallery has it, whether it is what was
# drawn, which is no less than 50 bytes, and how many bytes it has. Of a graph the nodes, edges and texts are compared,
# of another drawing all.
compared()
{
    LC_ALL=C awk '
        # told FILE: what is compared of it; its bytes are in `size`.
        function told(file,    line, all, texts, is_graph) {
            size = 0
            while ((getline line <file) > 0) {
                size += length(line) + 1
                all = all line "\n"
                is_graph = is_graph || index(line, "class=\"graph\"")
                for (; match(line, /<title>.*<\/title>|>[^<]*<\/text>/); line = substr(line, RSTART + RLENGTH))
                    texts = texts substr(line, RSTART, RLENGTH) "\n"
            }
            close(file)
            return is_graph ? texts : all
        }
        BEGIN {
            while ((getline line <"models/README.md") > 0) gallery = gallery line "\n"
            for (i = 1; i < ARGC; i += 3) {
                drawn = told(ARGV[i + 2])
                same = told(ARGV[i + 1]) == drawn && length(drawn) > 50
                print ARGV[i], (index(gallery, "](pictures/" ARGV[i] ".svg)") > 0), same, size
            }
        }' "$@"
}

rm -r "$out/project/models/pictures"
unoptimised
isochron pictures
expect $? "isochron pictures"
set --
for scene in models/*.scene hil; do
    name=${scene##*/}
    name=${name%.scene}
    set -- "$@" "$name" "models/pictures/$name.svg" "$out/project/models/pictures/$name.svg"
done
compared "$@" >"$out/compared"
while read -r name is_named is_same size; do
    [ "$is_named" -eq 1 ]
    result $? "models/pictures/$name.svg is in models/README.md"
    [ "$is_same" -eq 1 ]
    result $? "it is what isochron pictures draws"
    [ "$size" -lt 45000 ]
    result $? "it has $size bytes, fewer than 45,000"
done <"$out/compared"
[ $((3 * $(wc -l <"$out/compared"))) -eq $# ]
result $? "one for each model, and one of isochron hil"

sed '0,/ L1/s// L2/; 0,/d=.M1/s//d='"'"'M2/' models/pictures/pendulum.svg >"$out/changed.svg"
compared pendulum "$out/changed.svg" "$out/project/models/pictures/pendulum.svg" >"$out/compared"
read -r name is_named is_same size <"$out/compared"
! cmp -s models/pictures/pendulum.svg "$out/changed.svg" && [ "$is_named $is_same" = '1 0' ]
result $? "found: a point that is moved"
finish
