#!/bin/sh
# What the Markdown files say is so: the commands in their `sh` blocks run, in a copy of the project, and print the lines shown
# below them; C in them compiles; the commands of make in their text are known to make; their links
# lead somewhere, and lines are not too long. One with a thing changed is found. (Generated tables: tests/check/tables.sh;
# pictures: tests/check/gallery.sh.)
. tests/host/test.sh
. tests/host/project.sh
begin check/readme
project
unoptimised
mkdir -p "$out/printed"
find . -name .git -prune -o -path ./build -prune -o -print >"$out/exists"
documents=$(find . -name '*.md' ! -path './build/*' ! -path './.*/*' | sed 's|^\./||' | sort)

# commands FILE: those after `$ ` in its ```sh blocks, one on a line.
commands()
{
    awk '/^```/ { shell = $0 == "```sh"; next } shell && sub(/^\$ /, "")' "$1"
}

# mentioned FILE: the commands of make in its text and tables, one on a line.
mentioned()
{
    awk '/^```/ { code = !code; next } !code' "$1" | tr '\n' ' ' | grep -o '`make [^`]*`' | tr -d '`' | sort -u
}

# shows_error FILE COMMAND: whether a line below a command is an error.
shows_error()
{
    awk -v command="$ $2" '
        /^```/ { on = 0 }
        on && /^\$ / { on = 0 }
        on && /: error: / { found = 1; exit }
        $0 == command { on = 1 }
        END { exit !found }' "$1"
}

# What was run: on each line of $out/ran a command, in the order of the files $out/printed/NUMBER with what it printed.
: >"$out/ran"
ran=0
has_run()
{
    while IFS= read -r has_run_other; do
        [ "$1" != "$has_run_other" ] || return 0
    done <"$out/ran"
    return 1
}

# try FILE COMMAND: runs it in the copy. A command whose output shows an error must fail, every other must not.
try()
{
    ran=$((ran + 1))
    printf '%s\n' "$2" >>"$out/ran"
    (cd "$out/project" && eval "$2") </dev/null >"$out/printed/$ran" 2>&1
    try_status=$?
    if shows_error "$1" "$2"; then
        [ $try_status -ne 0 ]
    else
        [ $try_status -eq 0 ]
    fi
}

# known COMMAND: whether make has its goals and its variables: names that begin a line of the Makefile, or of that of the tests.
goals=" $(sed -n 's/^\([^ :]*\):.*/\1/p' Makefile tests/tests.mk | tr '\n' ' ')"
variables=" $(sed -n 's/^\([^ =]*\) *=.*/\1/p' Makefile | tr '\n' ' ')"
known()
{
    for word in ${1#make }; do
        case $word in
        *=*) known_among=$variables word=${word%%=*} ;;
        *) known_among=$goals ;;
        esac
        case $known_among in
        *" $word "*) ;;
        *) return 1 ;;
        esac
    done
}

# unlike_commands FILE: commands that were not run, and lines that they did not print.
unlike_commands()
{
    awk -v file="$1" -v printed="$out/printed/" '
        FILENAME != file { if (!($0 in number)) number[$0] = FNR; next }
        /^```/ { shell = $0 == "```sh"; command = ""; next }
        !shell { next }
        sub(/^\$ /, "") {
            command = $0
            if (!(command in number)) {
                print file ": not run: " command
                command = ""
            } else if (!(command in read)) {
                read[command]
                while ((getline line <(printed number[command])) > 0) has[command, line]
            }
            next
        }
        command != "" && !((command, $0) in has) { print file ": not printed by \047" command "\047: " $0 }' "$out/ran" "$1"
}

# dead_links FILE [FOLDER]: links of a file, as one of this folder, that lead nowhere.
dead_links()
{
    folder=${1%/*}
    [ "$folder" != "$1" ] || folder=.
    awk -v file="$1" -v folder="${2-$folder}" '
        # plain PATH: without its empty steps and those that lead back.
        function plain(path,    steps, count, i, depth, kept, joined) {
            count = split(path, steps, "/")
            depth = 0
            for (i = 1; i <= count; i++) {
                if (steps[i] == ".." && depth > 0) depth--
                else if (steps[i] != "" && steps[i] != ".") kept[++depth] = steps[i]
            }
            joined = "."
            for (i = 1; i <= depth; i++) joined = joined "/" kept[i]
            return joined
        }
        function read_anchors(target,    line, code) {
            if (target in read) return
            read[target]
            code = 0
            while ((getline line <target) > 0) {
                if (line ~ /^```/) code = !code
                else if (!code && sub(/^##* /, "", line)) {
                    line = tolower(line)
                    gsub(/ /, "-", line)
                    gsub(/[^a-z0-9_-]/, "", line)
                    anchors[target, line]
                }
            }
        }
        FILENAME != file { exists[$0]; next }
        {
            text = $0
            while (match(text, /\]\([^)]*\)/)) {
                link = substr(text, RSTART + 2, RLENGTH - 3)
                text = substr(text, RSTART + RLENGTH)
                if (link ~ /^https?:/) continue
                path = link
                sub(/#.*/, "", path)
                target = path == "" ? file : plain(folder "/" path)
                if (path != "" && !(target in exists)) {
                    print file ": leads nowhere: " link
                } else if (link != path) {
                    read_anchors(target)
                    if (!((target, substr(link, length(path) + 2)) in anchors)) print file ": no such heading: " link
                }
            }
        }' "$out/exists" "$1"
}

# write_code FILE: in the copy, the files of its blocks in C and Python, the first line of which is a comment, /* NAME */.
write_code()
{
    awk -v root="$out/project/" '
        /^```(c|python)$/ { getline; name = $2; system("mkdir -p $(dirname " root name ")"); printf "" >(root name) }
        /^```$/ && name != "" { close(root name); name = "" }
        name != "" { print >(root name) }' "$1"
}

# long_lines FILE: text of more than 120 characters; a table or a picture may be wider.
long_lines()
{
    awk -v file="$1" 'length > 120 && !/^[|!<]/ { print file ": longer than 120: " $0 }' "$1"
}

# wrong FILE [FOLDER]: what it says that is not so.
wrong()
{
    unlike_commands "$1"
    dead_links "$@"
    long_lines "$1"
}

echo "# $documents" | tr '\n' ' '
echo
for document in $documents; do
    write_code "$document"
    commands "$document" >"$out/commands"
    while IFS= read -r command; do
        ! has_run "$command" || continue
        try "$document" "$command"
        status=$?
        [ $status -eq 0 ] || tail -n 5 "$out/printed/$ran" | sed 's/^/# /'
        result $status "$document: $command"
    done <"$out/commands"
done
for document in $documents; do
    mentioned "$document"
done | sort -u >"$out/mentioned"
[ "$(grep -c . "$out/mentioned")" -ge 10 ]
result $? "the text has commands of make: $(grep -c . "$out/mentioned")"
while IFS= read -r command; do
    known "$command"
    result $? "make knows: $command"
done <"$out/mentioned"
for document in $documents; do
    wrong "$document" >"$out/wrong"
    [ ! -s "$out/wrong" ] || sed 's/^/# /' "$out/wrong"
    [ ! -s "$out/wrong" ]
    result $? "$document shows what its commands print; its links lead somewhere; its lines are short enough"
done
# unnamed FILE: folders of tools that have no line in its table.
unnamed()
{
    printf '%s\n' tools/*/ | awk -F / '
        FILENAME == "-" { folder[++n] = $2; next }
        /^[|] / { split($0, cell, "|"); first = first " " cell[2] }
        END { for (i = 1; i <= n; i++) if (!index(first, "`" folder[i] "`")) print folder[i] }' - "$1"
}
[ -z "$(unnamed tools/README.md)" ]
result $? "tools/README.md has a line for each folder"
grep -v '^| `plot` ' tools/README.md >"$out/tools.md"
[ "$(unnamed "$out/tools.md")" = plot ]
result $? "found: a folder without one"

[ "$(wc -l <README.md)" -le 200 ]
result $? "README.md has $(wc -l <README.md) lines, at most 200"
head -n 40 README.md | grep -q '^hash '
result $? "it shows what a scene prints within the first 40"

# found NAME FILE SED: a file so changed says something wrong.
found()
{
    sed "$3" "$2" >"$out/changed.md"
    ! cmp -s "$2" "$out/changed.md" && [ -n "$(wrong "$out/changed.md" "$(dirname "$2")")" ]
    result $? "found: $1"
}

found "a digit of a hash" README.md '/^hash /s/.$/x/'
found "a number of a step" README.md '/^instructions_per_step /s/$/0/'
found "a number of the scene" README.md 's/^step 1 ms/step 2 ms/'
found "a word of an error" tools/isoc/README.md "s/did you mean 'kg'/did you mean 'g'/"
found "a command that was not run" README.md 's/^\$ make run.*/& SECONDS=3/'
found "a link to nothing" README.md 's|(models/chains.md)|(models/chain.md)|'
found "a link to a heading that is not there" README.md 's|#the-summary-of-a-run|#the-summary|'
sed 's/iso_plant_tick(/iso_plant_tock(/' core/README.md >"$out/changed.md"
write_code "$out/changed.md"
! try core/README.md "$(commands core/README.md | grep -F './a.out')"
result $? "found: code that does not compile"
! known 'make cleaner' && ! known 'make run SCEEN=models/pendulum.scene'
result $? "found: a target and a variable that are not there"
! try README.md 'make run SCENE=models/absent.scene'
result $? "found: a command that fails"
finish
