#!/bin/sh
# The generated tables in Markdown files are those that their commands print. (tests/digits.md: tests/reference/*.t.) A
# table with one thing changed is found, and what writes the tables again leaves a file alone if a command fails.
. tests/host/test.sh
. tests/host/project.sh
begin check/tables
project

# What takes long is measured by turns: every eighth row of the tables of isochron cost; two lengths of chains; and the
# tables of isochron drift and isochron bench whole, one at a time. Of eight turns this one follows from what the tables
# say and what they follow from. With the argument `all` all is measured; `isochron tables` always does that.
turn=$(turn_of 8 "${1-}" models core tools port)
echo "# turn $turn of 8"

# The lengths of this turn: both kinds of chains. Growth is printed from 8 to 16.
growth=' nothing'
case $turn in
all) ;;
0) lengths='8 16' growth=' [a-z]*, 8 to 16 ' ;;
*) lengths="$turn $((16 - turn))" ;;
esac

# due COMMAND: whether it is measured at all.
due()
{
    case $turn-$1 in
    [!15]-isochron\ bench\ models/double_pendulum.scene | [!26]-isochron\ bench\ models/cart_pole.scene\ * | [!37]-isochron\ drift*) return 1 ;;
    esac
}

# commands FILE: those of its tables.
commands()
{
    sed -n 's/^<!-- \(make .*\|isochron .*\|build\/isoc .*\) -->$/\1/p' "$1"
}

# table FILE COMMAND: what it has of it.
table()
{
    awk -v head="<!-- $2 -->" '
        $0 == "<!-- end -->" && on { exit }
        on > 2 { print before }
        on { on++; before = $0 }
        $0 == head { on = 1 }' "$1"
}

# measured COMMAND: of a table, what is measured.
measured()
{
    case $turn-$1 in
    [0-7]-isochron\ chains) rows="^[|-]([^,]*, (${lengths% *}|${lengths#* }) | chain|---|$growth)" of_eight= ;;
    [0-7]-isochron\ cost*) rows='^[|-]' of_eight=$turn ;;
    *) rows='^[|-]' of_eight= ;;
    esac
    awk -v rows="$rows" -v turn="$of_eight" '$0 ~ rows && (turn == "" || ++n <= 2 || (n - 3) % 8 == turn)'
}

# run COMMAND: in the copy.
run()
{
    case $turn-$1 in
    [0-7]-isochron\ chains) set -- "$1 --lengths '$lengths'" ;;
    [0-7]-isochron\ cost*) set -- "TURN=$turn/8 $1" ;;
    esac
    (unset -f isochron && cd "$out/project" && PATH=$PWD/tools:$PATH && eval "$1") </dev/null
}

# found FILE COMMAND: one character changed in the last row that is measured, and that row left out; $out/whole has all
# rows, and $printed is what the command prints.
found()
{
    row=
    while IFS= read -r line; do
        case $line in
        *[a-z0-9]*) row=$line ;;
        esac
    done <"$out/table"
    row="$row" awk -v changed="$out/changed in" -v left="$out/left out" '
        BEGIN { printf "" >changed; printf "" >left }
        $0 != ENVIRON["row"] { print >changed; print >left; next }
        {
            n++
            match($0, /[a-z0-9][^a-z0-9]*$/)
            print substr($0, 1, RSTART - 1) "7x" substr($0, RSTART + 1) >changed
        }
        END { exit n == 0 }' "$out/whole"
    found_status=$?
    for change in 'changed in' 'left out'; do
        [ $found_status -eq 0 ] && [ -s "$printed" ] && measured "$2" <"$out/$change" >"$out/other" && ! cmp -s "$out/other" "$printed"
        result $? "found: $change '$2': $row"
    done
}

commands=0
for document in models/costs.md models/README.md models/chains.md models/drift.md core/methods.md core/README.md; do
    commands "$document" >"$out/commands"
    [ -s "$out/commands" ]
    result $? "$document has tables"
    while IFS= read -r command; do
        due "$command" || { echo "# not this time: $command" && continue; }
        commands=$((commands + 1))
        printed=$out/printed.$commands
        run "$command" >"$out/output" 2>"$out/errors" && grep '^[|-]' "$out/output" >"$printed"
        expect $? "$command"
        table "$document" "$command" >"$out/whole"
        measured "$command" <"$out/whole" >"$out/table"
        diff "$out/table" "$printed" >"$out/unlike"
        status=$?
        [ ! -s "$out/unlike" ] || sed 's/^/# /' "$out/unlike"
        result $status "$document has what it prints: $(grep -c . "$out/table") lines"
        found "$document" "$command"
    done <"$out/commands"
done

# The picture beside the table of isochron drift, but for the name of the gnuplot that drew it.
if due 'isochron drift'; then
    picture=models/pictures/four_bar_violation.svg
    grep -v '^<desc>' "$out/project/build/drift/four_bar/violation.svg" >"$out/picture.svg"
    [ -s "$out/picture.svg" ] && grep -v '^<desc>' $picture | cmp -s - "$out/picture.svg"
    result $? "$picture is what isochron drift draws"
fi

# The budgets of models/README.md: what the same takes that is written by hand.
for budget in 'friction 85' 'stop 150' 'lag 30'; do
    step=$(sed -n "s/^| \`${budget% *}\` .* | +\([0-9]*\) | [+-][0-9]* |\$/\1/p" models/README.md)
    [ "${step:-0}" -gt 0 ] && [ "$step" -le "${budget#* }" ]
    result $? "${budget% *}: $step instructions of a step, at most ${budget#* }"
done

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
