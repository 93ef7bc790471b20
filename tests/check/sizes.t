#!/bin/sh
# What a reader holds in mind at once: a source file has some hundred lines; in core and the tools a function fits a
# screen, and a struct has few members.
. tests/host/test.sh
. tests/host/plain.sh
begin check/sizes

MOST_LINES=60 MOST_MEMBERS=25 MOST_OF_A_FILE=600

# sizes FOLDER: "function NAME LINES FILE" and "struct NAME MEMBERS FILE" of each in core and the tools below a folder,
# as clang-format writes them.
sizes()
{
    (cd "$1" && find core tools -name '*.[ch]' | sort | xargs awk "$PLAIN"'
        FNR == 1 { inside = begins = depth = 0 }
        {
            line = plain($0)
            if (line ~ /^[A-Za-z_].*\(/) { head = FNR; name = line; sub(/\(.*/, "", name); sub(/.*[ *]/, "", name) }
            if (line == "{") begins = head
            if (line == "}" && begins) { print "function", name, FNR - begins + 1, FILENAME; begins = 0 }

            # Members of a struct are those of the structs without a name in it too.
            if (line ~ /^(typedef )?struct [a-z_0-9]+ \{$/) {
                depth = 1; members = 0; struct = line
                sub(/^(typedef )?struct /, "", struct); sub(/ .*/, "", struct)
            } else if (depth) {
                closes = gsub(/}/, "}", line)
                depth += gsub(/{/, "{", line) - closes
                gsub(/\[[^]]*\]/, "", line)
                while (gsub(/\([^()]*\)/, "", line)) { }
                members += gsub(/[,;]/, "", line) - (depth == 0)
                if (depth == 0) print "struct", struct, members, FILENAME
            }
        }')
}

# large SIZES: those that are too large. iso_model is the table by which core calls a plant: what it is made of stands
# in every generated plant.
large()
{
    awk -v lines=$MOST_LINES -v members=$MOST_MEMBERS '
        $2 == "iso_model" { next }
        $3 > ($1 == "function" ? lines : members)' "$1"
}

sizes . >"$out/sizes"
large "$out/sizes" | tee "$out/large" | sed 's/^/# /'
[ ! -s "$out/large" ]
result $? "no function of core and the tools has more than $MOST_LINES lines, no struct more than $MOST_MEMBERS members"

# A count that is known: of all that begins at the left, and of two structs.
[ "$(grep -c ^function "$out/sizes")" -eq "$(find core tools -name '*.[ch]' | xargs grep -c '^{$' | awk -F : '{ n += $2 } END { print n }')" ] &&
    grep -q '^struct mechanism 23 tools' "$out/sizes" && grep -q '^struct iso_quantity 5 core' "$out/sizes"
result $? "every function is counted, and what has many members"

# planted NAME TEXT: in a tree with this file, whether it is found, and nothing else.
planted()
{
    rm -rf "$out/tree"
    mkdir -p "$out/tree/core" "$out/tree/tools"
    printf '%b' "$2" >"$out/tree/tools/planted.c"
    sizes "$out/tree" >"$out/planted"
    [ "$(large "$out/planted" | awk '{ print $2 }')" = "$1" ]
}
lines=$(seq -f '    a += %.0f; /* } */\n' -s '' 56)
planted long "static int long(int a, /* a {\n */ int b)\n{\n$lines    return a;\n}\n\nint other(int a)\n{\n    return a;\n}\n"
result $? "found: a function of 61 lines"
planted "" "static int long(int a)\n{\n$lines    return a;\n}\n"
result $? "one of 60 is let through"
planted wide 'typedef struct wide {\n    int a, b[2], c; /* d, e; */\n    void (*call)(int a, int b, int c);\n    struct {\n        int x, y;\n    } pair;\n    int '"$(seq -f 'm%.0f' -s ', ' 19)"';\n} wide;\n'
result $? "found: a struct of 26 members"
planted "" 'typedef struct wide {\n    int '"$(seq -f 'm%.0f' -s ', ' 25)"';\n} wide;\n'
result $? "one of 25 is let through"

# long FOLDER: the source files in it that are too long, with their lines.
long()
{
    (cd "$1" && find . -name build -prune -o -type f \( -name '*.[chS]' -o -name '*.in' -o -name '*.sh' -o -name '*.t' -o -name '*.awk' \
        -o -name '*.py' -o -name '*.pm' -o -name '*.mk' -o -name Makefile -o -name '*.scene' -o -name '*.ld' \) -print | xargs wc -l |
        awk -v most=$MOST_OF_A_FILE '$2 != "total" && $1 > most { print $2, $1 }' | sed 's|^[.]/||')
}
long . | tee "$out/long" | sed 's/^/# /'
[ ! -s "$out/long" ]
result $? "no source file has more than $MOST_OF_A_FILE lines"
seq $((MOST_OF_A_FILE + 1)) >"$out/tree/tools/planted.sh"
seq $MOST_OF_A_FILE >"$out/tree/tools/other.sh"
[ "$(long "$out/tree")" = "tools/planted.sh $((MOST_OF_A_FILE + 1))" ]
result $? "found: a file of a line more"
finish
