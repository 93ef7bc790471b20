#!/bin/sh
# The generated tables in Markdown files are those that their commands print. (tests/digits.md: tests/reference/*.t.) A table
# with one thing changed is found, and what writes the tables again leaves a file alone if a command fails.
. tests/host/test.sh
. tests/host/project.sh
begin check/tables
project

# Of the chains these lengths are measured again: with both formulations, equations copied and called.
lengths='2 8 16'

# commands FILE: those of its tables.
commands()
{
    sed -n 's/^<!-- \(make .*\|build\/isoc .*\) -->$/\1/p' "$1"
}

# table FILE COMMAND: what it has of it.
table()
{
    awk -v head="<!-- $2 -->" '
        $0 == "<!-- end -->" { on = 0 }
        on
        $0 == head { on = 1 }' "$1" | sed '1d;$d'
}

# printed COMMAND: the file with what it prints.
printed()
{
    echo "$out/printed/$(echo "$1" | tr -c 'a-z\n' _)"
}

# measured COMMAND: of a table, what is measured again.
measured()
{
    case $1 in
    'make chains') grep -E "^[|-]([^,]*, ($(echo "$lengths" | tr ' ' '|')) | chain |---)| 8 to 16 joints" ;;
    *) cat ;;
    esac
}

# run COMMAND: in the copy.
run()
{
    case $1 in
    'make chains') set -- "make chains LENGTHS='$lengths'" ;;
    esac
    (cd "$out/project" && eval "$1") </dev/null
}

mkdir -p "$out/printed"
for document in models/costs.md models/chains.md models/drift.md core/methods.md core/README.md; do
    commands "$document" >"$out/commands"
    [ -s "$out/commands" ]
    result $? "$document has tables"
    while IFS= read -r command; do
        run "$command" >"$out/output" 2>"$out/errors" && grep '^[|-]' "$out/output" >"$(printed "$command")"
        expect $? "$command"
        table "$document" "$command" | measured "$command" | grep '^[|-]' >"$out/table"
        diff "$out/table" "$(printed "$command")" >"$out/unlike"
        status=$?
        sed 's/^/# /' "$out/unlike"
        result $status "$document has what it prints: $(grep -c . "$out/table") lines"
    done <"$out/commands"
done

# The picture beside the table of make drift, but for the name of the gnuplot that drew it.
picture=models/pictures/four_bar_violation.svg
grep -v '^<desc>' "$out/project/build/drift/four_bar/violation.svg" >"$out/picture.svg"
[ -s "$out/picture.svg" ] && grep -v '^<desc>' $picture | cmp -s - "$out/picture.svg"
result $? "$picture is what make drift draws"

# found NAME FILE COMMAND SED: the table so changed is another one.
found()
{
    table "$2" "$3" >"$out/whole"
    sed "$4" "$out/whole" >"$out/changed"
    ! cmp -s "$out/whole" "$out/changed" && ! measured "$3" <"$out/changed" | grep '^[|-]' | cmp -s - "$(printed "$3")"
    result $? "found: $1"
}

found "an operation of a model" models/costs.md 'make cost PARTS=models' '/^| arm6 /s/ |$/0 |/'
found "a row left out" models/costs.md 'make cost PARTS=methods' '/^| cart_pole /d'
found "the cost of a restart" models/costs.md 'make cost PARTS=restarts' '/^| arm6, detected /s/| - |$/| 0 |/'
found "the cost of an effect" models/costs.md 'make cost PARTS=effects' '/^| damping |/s/+/+1/'
found "the cost of a chain" models/chains.md 'make chains' '/^| planar, 16 /s/ |$/0 |/'
found "a violation" models/drift.md 'make drift' '/^| projection /s/e-/e-1/'
found "an order of a method" core/methods.md 'build/isoc --methods' '/^| rk4 /s/| 4/| 3/'
found "an error of a method" core/methods.md 'make bench' '/^| rk4 /s/e-/e-1/'
found "an answer" core/methods.md 'make bench' '/^- The /s/abm4_pec/abm4/'

# What writes them: only what is between the lines, and nothing if a command fails.
printf '%s\n' one '<!-- build/isoc --methods -->' two '<!-- end -->' three >"$out/project/good.md"
(cd "$out/project" && sh tools/build/tables.sh good.md) >"$out/output" 2>"$out/errors"
expect $? "tables.sh writes a table"
{ echo one && echo '<!-- build/isoc --methods -->' && echo && build/isoc --methods && echo && echo '<!-- end -->' && echo three; } |
    cmp -s - "$out/project/good.md"
result $? "between its lines"
printf '%s\n' '<!-- build/isoc --method -->' two '<!-- end -->' >"$out/bad.md"
cp "$out/bad.md" "$out/project/bad.md"
! (cd "$out/project" && sh tools/build/tables.sh bad.md) >"$out/output" 2>"$out/errors" && cmp -s "$out/bad.md" "$out/project/bad.md"
expect $? "found: a command that fails; the file stays as it is"
finish
