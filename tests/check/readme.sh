#!/bin/sh
# README.md says what is so: its commands run, in a copy of the project, and print the lines shown below them; its tables are
# those of `make cost`, `make chains`, `make bench`, `make drift`, `make digits` and `build/isoc --methods`, its scene and its
# pictures those of models/, its links lead somewhere. A README with one thing changed is found.
. tests/host/test.sh
. tests/host/project.sh
begin check/readme
project
mkdir -p "$out/printed"

# commands README: those after `$ ` in its ```sh blocks, one on a line.
commands()
{
    awk '/^```/ { shell = $0 == "```sh"; next } shell && sub(/^\$ /, "")' "$1"
}

# mentioned README: commands of make in its text and tables, one on a line.
mentioned()
{
    awk '/^```/ { code = !code; next } !code' "$1" | tr '\n' ' ' | grep -o '`make [^`]*`' | tr -d '`' | sort -u
}

# shown README COMMAND: the lines below a command.
shown()
{
    awk -v command="$ $2" '
        /^```/ { on = 0 }
        on && /^\$ / { on = 0 }
        on
        $0 == command { on = 1 }' "$1"
}

# printed COMMAND: the file with what a command printed.
printed()
{
    echo "$out/printed/$(printf %s "$1" | cksum | tr ' ' -)"
}

# The lengths of which `make chains` is run again: with equations composite and articulated, copied and called, of both
# kinds of chain, and those that its list is of.
lengths='2 8 16'

# try COMMAND: runs it in the copy. A command whose output shows an error must fail, every other must not.
try()
{
    (cd "$out/project" && eval "$1 $([ "$1" != 'make chains' ] || echo "LENGTHS='$lengths'")") </dev/null >"$(printed "$1")" 2>&1
    status=$?
    if shown README.md "$1" | grep -q ': error: '; then
        [ $status -ne 0 ]
    else
        [ $status -eq 0 ]
    fi
}

# The tables: how their first lines begin, and what prints them.
tables='| model |:make cost
| steps of |:make cost
| dearest step of |:make cost
| effect on:make cost
| chain |:make chains
| method | order | evaluations | Jacobians |:build/isoc --methods
| method | order | evaluations | error,:make bench
| stabilisation | largest violation |:make drift
| reference | real | step |:make digits'

# table README BEGINNING: the table whose first line begins so, and the list that follows it, if there is one.
table()
{
    awk -v beginning="$2" '
        index($0, beginning) == 1 {
            on = 1
            gap = 0
            n++
        }
        !/^[|-]/ && (gap || $0 != "") || gap && !/^-/ { on = 0 }
        { gap = $0 == "" }
        on && !gap
        END { exit n != 1 }' "$1"
}

# again BEGINNING: of the table of README.md that begins so, what is measured again: rows of those lengths, if it is of chains.
again()
{
    awk -F ' *[|,] *' -v chains="$([ "$1" != '| chain |' ] || echo " $lengths ")" '
        chains == "" || !/^[|] [a-z]*, / || index(chains, " " $3 " ")'
}

# exact: a table without its column of isoc, which another compiler of isoc changes.
exact()
{
    awk '/^[|] [a-z]* [|].* isoc [|]$/ { isoc = 1 } isoc && /^[|]/ { sub(/[^|]*[|]$/, "") } { print }'
}

# unlike ONE OTHER: rows of two tables whose isoc differs by more than a quarter, and what rounding makes of millions.
unlike()
{
    paste -d '|' "$1" "$2" | awk -F ' *[|] *' '
        /^[|] [a-z]* [|].* isoc [|]/ { isoc = (NF + 1) / 2 - 1 }
        isoc && /^[|] [a-z]/ && NR > 1 {
            a = $isoc
            b = $(NF - 1)
            if (a > 1.25 * b + 1 || b > 1.25 * a + 1)
                print "isoc takes " b ", not " a ": " $2
        }'
}

# operations: the rows of chains, of all lengths, as far as isoc tells them.
operations()
{
    for kind in planar spatial; do
        for n in 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16; do
            sh tools/build/chain.sh "$n" "$kind" >"$out/chain.scene"
            build/isoc "$out/chain.scene" -o "$out/chain" --method euler |
                awk -v name="$kind, $n" '/ kept / { kept = $2 }
                    $1 == "derivative" { print "| " name " | " kept " | " $3 " | " $5 " | " $7 " | " $9 " |" }'
        done
    done
}

# first_block README: the text in the first ``` block.
first_block()
{
    awk '/^```/ { if (n++) exit; next } n' "$1"
}

# targets README: whether the commands of make that take long, or away what is made, have a recipe.
targets()
{
    for target in test check clean; do
        mentioned "$1" | grep -qx "make $target" && grep -q "^$target:" Makefile tests/tests.mk || return 1
    done
}

# wrong README: what it says that is not so.
wrong()
{
    commands "$1" | while IFS= read -r command; do
        if [ ! -s "$(printed "$command")" ]; then
            echo "not run: $command"
            continue
        fi
        shown "$1" "$command" | while IFS= read -r line; do
            grep -qxF -- "$line" "$(printed "$command")" || echo "not printed by '$command': $line"
        done
    done
    echo "$tables" | while IFS=: read -r beginning command; do
        table "$1" "$beginning" >"$out/whole" || echo "not one table that begins: $beginning"
        again "$beginning" <"$out/whole" >"$out/table"
        table "$(printed "$command")" "$beginning" >"$out/measured" || echo "$command prints no table: $beginning"
        exact <"$out/table" >"$out/table.exact"
        exact <"$out/measured" | diff "$out/table.exact" -
        unlike "$out/table" "$out/measured"
    done
    table "$1" '| chain |' | grep -o '^| [a-z]*, [0-9]* | [a-z]* |\( [0-9]* |\)\{4\}' | diff - "$out/operations"
    first_block "$1" | diff - models/pendulum.scene
    grep -o '](\([^)]*\))' "$1" | tr -d ']()' | while IFS= read -r file; do
        [ -e "$file" ] || echo "leads nowhere: $file"
    done
    awk 'length > 120 { print "longer than 120: " $0 }' "$1"
}

commands README.md >"$out/commands"
mentioned README.md | grep -Evx 'make (test|check|clean)' >"$out/mentioned"
[ "$(grep -c . "$out/commands")" -ge 4 ] && [ "$(grep -c . "$out/mentioned")" -ge 6 ]
result $? "README.md has commands: $(grep -c . "$out/commands") with what they print, $(grep -c . "$out/mentioned") of make"
{ cat "$out/commands" "$out/mentioned" && echo "build/isoc --methods"; } >"$out/all"
while IFS= read -r command; do
    try "$command"
    status=$?
    [ $status -eq 0 ] || tail -n 5 "$(printed "$command")" | sed 's/^/# /'
    result $status "$command"
done <"$out/all"
targets README.md
result $? "make test, make check and make clean are there"

operations >"$out/operations"
wrong README.md >"$out/wrong"
sed 's/^/# /' "$out/wrong"
[ ! -s "$out/wrong" ]
result $? "README.md shows what its commands print, and what is in models/"

# The picture, but for the name of the gnuplot that drew it.
picture=$out/project/build/host/float/double_pendulum/path.svg
(cd "$out/project" && make plot) >/dev/null 2>&1
grep -v '^<desc>' "$picture" >"$out/picture.svg"
[ -s "$out/picture.svg" ] && grep -v '^<desc>' models/double_pendulum.svg | cmp -s - "$out/picture.svg"
result $? "models/double_pendulum.svg is what make plot draws"
[ "$(wc -c <models/double_pendulum.svg)" -lt 100000 ]
result $? "the picture is smaller than 100 kB"

grep -v '^<desc>' "$out/project/build/drift/four_bar/violation.svg" >"$out/picture.svg"
[ -s "$out/picture.svg" ] && grep -v '^<desc>' models/four_bar_violation.svg | cmp -s - "$out/picture.svg"
result $? "models/four_bar_violation.svg is what make drift draws"

# texts FILE: the texts of a drawing, one on a line.
texts()
{
    grep -o '<text>.*</text>' "$1" | sed 's/<[^>]*>//g'
}

# The picture of the report, but for its points: those of the host depend on its compiler.
picture=models/double_pendulum_work_precision.svg
texts $picture >"$out/texts"
texts "$out/project/build/report/double_pendulum/work_precision.svg" | cmp -s - "$out/texts" && [ -s "$out/texts" ]
result $? "$picture has the axes and the methods that make report draws"
[ "$(wc -c <$picture)" -lt 100000 ]
result $? "and is smaller than 100 kB"

# found NAME SED: README.md so changed says something wrong.
found()
{
    sed "$2" README.md >"$out/changed.md"
    ! cmp -s README.md "$out/changed.md" && [ -n "$(wrong "$out/changed.md")" ]
    result $? "found: $1"
}

found "a digit of a hash" '/^hash /s/.$/x/'
found "a number of a step" '/^instructions_per_step /s/$/0/'
found "a price of a model" '/^| arm6 /s/|\([^|]*\)|$/|\10 |/'
found "a price of a chain" '/^| planar, 16 /s/| \([0-9]* | [0-9]* |\)$/| 1\1/'
found "an operation of a chain that is not run again" '/^| spatial, 13 /s/| 1119 /| 1118 /'
found "the time of isoc for it" '/^| planar, 16 /s/ |$/0 |/'
found "a dearest step" '/^| arm6, found /s/| - |$/| 0 |/'
found "an order of a method" '/^| rk4 | 4 | 4 | 0/s/| 4/| 3/'
found "an error of a method" '/^| rk4 | 4 | 4 | [1-9]/s/e-0/e-1/'
found "an answer" 's/^- abm4 takes [0-9.]*/&1/'
found "a price of an effect" '/^| damping |/s/+/+1/'
found "an error of a reference" '/^| Bricard | double /s/e-/e-1/'
found "a violation" '/^| projection | [0-9]/s/e-/e-1/'
found "a row left out" '/^| cart_pole /d'
found "a number of the scene" 's/^step 1 ms/step 2 ms/'
found "a word of an error" "s/did you mean 'kg'/did you mean 'g'/"
found "a command that was not run" 's/^\$ make run.*/& SECONDS=3/'
found "a link to nothing" 's|(core/runtime/plant.h)|(core/plants.h)|'
sed 's/`make clean`/`make cleaner`/' README.md >"$out/changed.md"
! targets "$out/changed.md"
result $? "found: a target that is none"
! try 'make run SCENE=models/absent.scene'
result $? "found: a command that fails"
finish
