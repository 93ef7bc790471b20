#!/bin/sh
# Files of isoc call one another in one direction: what a reader follows from a file downward does not lead back to it. Only
# two languages call themselves, statements and formulas as they are read, and formulas as they are evaluated.
. tests/host/test.sh
begin check/circles

MOST_CIRCLES=2 MOST_FILES=4

# calls OBJECT...: the calls between the objects as a graph, FILE -> FILE for each that needs a symbol of another.
calls()
{
    nm -A "$@" | awk '
        { file = $1; sub(/:.*/, "", file); sub(/\.o$/, "", file); type = $(NF - 1); symbol = $NF }
        type == "U" { needs[file, symbol] }
        type ~ /^[A-TV-Z]$/ { has[symbol] = file }
        END {
            print "strict digraph calls {"
            for (pair in needs) {
                split(pair, part, SUBSEP)
                if ((part[2] in has) && has[part[2]] != part[1]) print "\"" part[1] "\" -> \"" has[part[2]] "\""
            }
            print "}"
        }'
}

# circles GRAPH: the files of each circle on a line.
circles()
{
    sccmap "$1" 2>"$out/said" | awk '
        $2 == "->" { gsub(/"/, ""); if (!(($1, count) in seen)) line = line (line == "" ? "" : " ") $1; seen[$1, count] }
        /^}/ { if (line != "") print line; line = ""; count++ }'
}

# few NAME: whether the circles of $out/NAME.gv are as few and as small as they may be.
few()
{
    circles "$out/$1.gv" >"$out/$1.circles"
    awk -v circles=$MOST_CIRCLES -v files=$MOST_FILES 'NF > files { bad = 1 } END { exit (bad || NR > circles) }' "$out/$1.circles"
}

objects=$(find tools/isoc -name '*.c' | sort | sed 's|^|build/obj/|; s|\.c$|.o|')
# shellcheck disable=SC2086
calls $objects >"$out/isoc.gv"
few isoc
status=$?
sed 's|build/obj/tools/isoc/||g; s/^/# a circle: /' "$out/isoc.circles"
result $status "files of isoc call one another in at most $MOST_CIRCLES circles, none through more than $MOST_FILES of them"

# Every file of isoc is in the graph, with what it calls.
[ "$(grep -c -- '-> "build/obj/tools/isoc/graph/graph"' "$out/isoc.gv")" -gt 20 ] && grep -q '/main" -> .*/pipeline"' "$out/isoc.gv"
result $? "the graph has the calls that there are"

# planted FILES...: each file calls the next, and the last one the first; with isoc's own objects.
planted()
{
    count=$#
    for number; do
        printf 'void planted_%d(void);\nvoid planted_%d(void);\nvoid planted_%d(void)\n{\n    planted_%d();\n}\n' \
            "$number" $((number % count + 1)) "$number" $((number % count + 1)) >"$out/planted_$number.c"
        $CC -O0 -c "$out/planted_$number.c" -o "$out/planted_$number.o" || return
    done
    # shellcheck disable=SC2046
    calls $(for number; do echo "$out/planted_$number.o"; done) >"$out/planted.gv"
}

planted 1 2 3 4 && few planted && [ "$(wc -w <"$out/planted.circles")" -eq 4 ]
result $? "a circle of four files is let through"
planted 1 2 3 4 5 && ! few planted && [ "$(wc -w <"$out/planted.circles")" -eq 5 ]
result $? "found: a circle of five files"

{
    echo 'strict digraph calls {'
    for name in a b c; do printf '"%s1" -> "%s2"\n"%s2" -> "%s1"\n' $name $name $name $name; done
    echo '}'
} >"$out/three.gv"
! few three && [ "$(wc -l <"$out/three.circles")" -eq 3 ]
result $? "found: three circles"
finish
