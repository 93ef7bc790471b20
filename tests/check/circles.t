#!/bin/sh
# Files of isoc call one another in one direction: what a reader follows from a file downward does not lead back to it.
# Only two languages call themselves, statements and formulas as they are read, and formulas as they are evaluated.
. tests/host/test.sh
. tests/host/plain.sh
begin check/circles

MOST_CIRCLES=2 MOST_FILES=4

# calls FOLDER: the calls between the files of isoc below a folder as a graph, FILE -> FILE for each that uses what
# another has at its top.
calls()
{
    (cd "$1" && find tools/isoc -name '*.c' | sort | xargs awk "$PLAIN"'
        # What is read and not called is data, or a function of two words that stands in a table.
        function edge(pair, is_read, part) {
            split(pair, part, SUBSEP)
            if (!(part[1] in has) || has[part[1]] == part[2] || (pair in own) || (is_read && !data[part[1]] && part[1] !~ /_/)) return
            print "\"" part[2] "\" -> \"" has[part[1]] "\""
        }
        FNR == 1 { inside = 0; file = FILENAME; sub(/^tools\/isoc\//, "", file); sub(/\.c$/, "", file) }
        {
            line = plain($0)
            if (line ~ /^[a-z]/ && line !~ /^(typedef|struct|enum) / && line !~ /^[^=]*;$/ &&
                match(line, /[a-z_0-9]+(\(|(\[[A-Za-z_0-9]*\])* = )/)) {
                name = substr(line, RSTART, RLENGTH)
                is_data = name !~ /\($/
                sub(/[^a-z_0-9].*/, "", name)
                if (line ~ /^static /) own[name, file]
                else { has[name] = file; data[name] = is_data }
            }
            while (match(line, /(^|[^.>a-z_0-9])[a-z_0-9]+/)) {
                name = substr(line, RSTART, RLENGTH)
                line = substr(line, RSTART + RLENGTH)
                sub(/^[^a-z_0-9]/, "", name)
                if (line ~ /^\(/) calls[name, file]
                else reads[name, file]
            }
        }
        END {
            print "strict digraph calls {"
            for (pair in calls) edge(pair, 0)
            for (pair in reads) edge(pair, 1)
            print "}"
        }')
}

# circles GRAPH: the files of each circle on a line.
circles()
{
    sccmap "$1" 2>"$out/said" | awk '
        /scc_map/ { exit }
        $2 == "->" { gsub(/"/, ""); if (!(($1, count) in seen)) line = line (line == "" ? "" : " ") $1; seen[$1, count] }
        /^}/ { if (line != "") print line; line = ""; count++ }'
}

# few NAME: whether the circles of $out/NAME.gv are as few and as small as they may be.
few()
{
    circles "$out/$1.gv" >"$out/$1.circles"
    awk -v circles=$MOST_CIRCLES -v files=$MOST_FILES 'NF > files { bad = 1 } END { exit (bad || NR > circles) }' "$out/$1.circles"
}

calls . >"$out/isoc.gv"
few isoc
status=$?
sed 's/^/# a circle: /' "$out/isoc.circles"
result $status "files of isoc call one another in at most $MOST_CIRCLES circles, none through more than $MOST_FILES of them"

# planted NUMBER: beside those of isoc so many files, of which each calls the next, and the last one the first.
planted()
{
    rm -rf "$out/tree"
    mkdir -p "$out/tree/tools/isoc/graph"
    cp tools/isoc/graph/*.c "$out/tree/tools/isoc/graph"
    for number in $(seq "$1"); do
        printf '/* */ int planted_%d(void); /* planted_9( */\n\nint planted_%d(void)\n{\n    return planted_%d();\n}\n' \
            $((number % $1 + 1)) "$number" $((number % $1 + 1)) >"$out/tree/tools/isoc/graph/planted_$number.c"
    done
    calls "$out/tree" >"$out/planted.gv"
}

planted 4 && few planted && [ "$(wc -w <"$out/planted.circles")" -eq 4 ]
result $? "a circle of four files is let through"
planted 5 && ! few planted && [ "$(wc -w <"$out/planted.circles")" -eq 5 ]
result $? "found: a circle of five files"

{
    echo 'strict digraph calls {'
    for name in a b c; do printf '"%s1" -> "%s2"\n"%s2" -> "%s1"\n' $name $name $name $name; done
    echo '}'
} >"$out/three.gv"
! few three && [ "$(wc -l <"$out/three.circles")" -eq 3 ]
result $? "found: three circles"
finish
