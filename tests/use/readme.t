#!/bin/sh
# Depends on: *.md core port models tools tests/tests.mk Makefile
# What the Markdown files say is so: the commands in their `sh` blocks run, in a copy of the project, and print the
# lines shown below them; C in them compiles; the commands of isochron and make in their text are known; their links
# lead somewhere, and lines are not too long. One with a thing changed is found. (Generated tables:
# tests/use/test_tables.py; pictures: tests/use/gallery.t.)
. tests/host/test.sh
. tests/host/project.sh
begin check/readme
project
unoptimised
mkdir -p "$out/printed"
find . -name .git -prune -o -path ./build -prune -o -print >"$out/exists"
documents=$(sed -n 's|^\./\([^.].*\.md\)$|\1|p' "$out/exists" | sort)

# commands FILE...: those after `$ ` in their ```sh blocks, one on a line, behind 1 if a line below it is an error, else
# 0, and the file.
commands()
{
    awk -v OFS='\t' '
        function ended() { if (command != "") print has_error, file, command; command = ""; has_error = 0 }
        /^```/ || FNR == 1 { ended(); shell = $0 == "```sh"; file = FILENAME; next }
        shell && sub(/^\$ /, "") { ended(); command = $0; next }
        /: error: / { has_error = 1 }
        END { ended() }' "$@"
}

# mentioned FILE...: the commands of make and isochron in their text and tables, one on a line.
mentioned()
{
    awk '
        function ended() {
            for (; match(text, /`(make|isochron) [^`]*`/); text = substr(text, RSTART + RLENGTH)) print substr(text, RSTART + 1, RLENGTH - 2)
            text = ""
        }
        FNR == 1 { ended() }
        /^```/ { code = !code; next }
        !code { text = text " " $0 }
        END { ended() }' "$@" | sort -u
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

# try FAILS COMMAND: runs it in the copy. A command whose output shows an error, FAILS is 1, must fail, every other must
# not.
try()
{
    ran=$((ran + 1))
    printf '%s\n' "$2" >>"$out/ran"
    (cd "$out/project" && PATH=$PWD/tools:$PATH && unset -f isochron && eval "$2") </dev/null >"$out/printed/$ran" 2>&1
    [ $(($? != 0)) -eq "$1" ]
}

# known COMMAND: whether make has its goals and its variables, names that begin a line of the Makefile, or of that of
# the tests; or isochron the command and its options.
goals=$(sed -n 's/^\([^ :]*\):.*/ \1 /p' Makefile tests/tests.mk)
variables=$(sed -n 's/^\([^ =]*\) *=.*/ \1 /p' Makefile tests/tests.mk)
known()
{
    case $1 in
    isochron\ *)
        # shellcheck disable=SC2086
        set -- ${1#isochron }
        case $1 in
        --help | help) return 0 ;;
        esac
        tools/isochron help "$1" >"$out/help" 2>&1 || return 1
        for word; do
            case $word in
            --*) grep -q -- "^  ${word%%=*} " "$out/help" || return 1 ;;
            esac
        done
        return 0
        ;;
    esac
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

# wrong [folder=FOLDER] FILE...: what they say that is not so, a line each, behind the name of the file and a tab:
# commands that were not run, and lines that they did not print; links that lead nowhere, of a file in its folder, or in
# this one; text of more than 120 characters, but for tables and pictures.
wrong()
{
    awk -v printed="$out/printed/" -v exists_in="$out/exists" -v ran="$out/ran" '
        function say(problem) { print FILENAME "\t" problem }
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
            close(target)
        }
        # check_links: of the text of this line.
        function check_links(text,    link, path, target) {
            while (match(text, /\]\([^)]*\)/)) {
                link = substr(text, RSTART + 2, RLENGTH - 3)
                text = substr(text, RSTART + RLENGTH)
                if (link ~ /^https?:/) continue
                path = link
                sub(/#.*/, "", path)
                target = path == "" ? FILENAME : plain(place "/" path)
                if (path != "" && !(target in exists)) {
                    say("leads nowhere: " link)
                } else if (link != path) {
                    read_anchors(target)
                    if (!((target, substr(link, length(path) + 2)) in anchors)) say("no such heading: " link)
                }
            }
        }
        # begin_command COMMAND: what it printed is in `has` from here on, if it was run.
        function begin_command(text,    line) {
            command = text
            if (!(command in number)) {
                say("not run: " command)
                command = ""
            } else if (!(command in known)) {
                known[command]
                while ((getline line <(printed number[command])) > 0) has[command, line]
                close(printed number[command])
            }
        }
        BEGIN {
            while ((getline line <exists_in) > 0) exists[line]
            while ((getline line <ran) > 0) {
                runs++
                if (!(line in number)) number[line] = runs
            }
        }
        FNR == 1 {
            shell = command = ""
            place = FILENAME
            if (folder != "") place = folder
            else if (!sub(/\/[^\/]*$/, "", place)) place = "."
        }
        length > 120 && !/^[|!<]/ { say("longer than 120: " $0) }
        { check_links($0) }
        /^```/ { shell = $0 == "```sh"; command = ""; next }
        !shell { next }
        /^\$ / { begin_command(substr($0, 3)); next }
        command != "" && !((command, $0) in has) { say("not printed by \047" command "\047: " $0) }' "$@"
}

# write_code FILE...: in the copy, the files of their blocks in C and Python, the first line of which is a comment, /*
# NAME */.
write_code()
{
    awk -v root="$out/project/" '
        /^```(c|python)$/ {
            getline
            name[++count] = root $2
            folder = name[count]
            sub(/\/[^\/]*$/, "", folder)
            folders = folders " " folder
            open = 1
        }
        /^```$/ { open = 0 }
        open { text[count] = text[count] $0 "\n" }
        END {
            system("mkdir -p" folders)
            for (i = 1; i <= count; i++) printf "%s", text[i] >name[i]
        }' "$@"
}

# shellcheck disable=SC2086
write_code $documents
tab=$(printf '\t')
# shellcheck disable=SC2086
commands $documents >"$out/commands" && printf '# %s\n' $documents
while IFS=$tab read -r fails document command; do
    ! has_run "$command" || continue
    try "$fails" "$command"
    status=$?
    [ $status -eq 0 ] || tail -n 5 "$out/printed/$ran" | sed 's/^/# /'
    result $status "$document: $command"
done <"$out/commands"
# shellcheck disable=SC2086
mentioned $documents >"$out/mentioned"
count=$(wc -l <"$out/mentioned")
[ "$count" -ge 10 ]
result $? "the text has commands: $count"
while IFS= read -r command; do
    known "$command"
    result $? "known: $command"
done <"$out/mentioned"
# shellcheck disable=SC2086
wrong $documents >"$out/wrong"
# right FILE: whether nothing in $out/wrong is of it; that is shown in comments.
right()
{
    right_status=0
    while IFS=$tab read -r right_other right_problem; do
        [ "$1" = "$right_other" ] || continue
        right_status=1
        echo "# $right_problem"
    done <"$out/wrong"
    return $right_status
}
for document in $documents; do
    right "$document"
    result $? "$document shows what its commands print; its links lead somewhere; its lines are short enough"
done

# unnamed FILE: $unnamed are the folders of tools that have no line in its table.
unnamed()
{
    first_cells=$(awk -F '|' '/^[|] / { print $2 }' "$1")
    unnamed=
    for folder in tools/*/; do
        folder=${folder#tools/}
        case $first_cells in
        *"\`${folder%/}\`"*) ;;
        *) unnamed="$unnamed ${folder%/}" ;;
        esac
    done
}
unnamed tools/README.md
[ -z "$unnamed" ]
result $? "tools/README.md has a line for each folder"
grep -v '^| `table` ' tools/README.md >"$out/tools.md"
unnamed "$out/tools.md"
[ "$unnamed" = ' table' ]
result $? "found: a folder without one"

lines=0
first_hash=
while IFS= read -r line; do
    lines=$((lines + 1))
    case $line in
    'hash '*) : "${first_hash:=$lines}" ;;
    esac
done <README.md
[ "$lines" -le 200 ]
result $? "README.md has $lines lines, at most 200"
[ "${first_hash:-41}" -le 40 ]
result $? "it shows what a scene prints within the first 40"

# change NAME FILE SED: a file so changed, $out/changed.NUMBER, says something wrong; it is added to $changed.
changes=0
changed=
: >"$out/changes"
change()
{
    changes=$((changes + 1))
    folder=${2%/*}
    [ "$folder" != "$2" ] || folder=.
    sed "$3" "$2" >"$out/changed.$changes"
    ! cmp -s "$2" "$out/changed.$changes"
    printf '%s\t%s\n' $? "$1" >>"$out/changes"
    changed="$changed folder=$folder $out/changed.$changes"
}

change "a digit of a hash" README.md '/^hash /s/.$/x/'
change "a number of a step" README.md '/^instructions_per_step /s/$/0/'
change "a number of the scene" README.md 's/^step 1 ms/step 2 ms/'
change "a word of an error" tools/isoc/README.md "s/did you mean 'kg'/did you mean 'g'/"
change "a command that was not run" README.md 's/^\$ isochron run.*/& --seconds 3/'
change "a link to nothing" README.md 's|(models/chains.md)|(models/chain.md)|'
change "a link to a heading that is not there" README.md 's|#the-summary-of-a-run|#the-summary|'
# shellcheck disable=SC2086
wrong $changed >"$out/wrong"
number=0
while IFS=$tab read -r status name; do
    number=$((number + 1))
    [ "$status" -eq 0 ] && ! right "$out/changed.$number" >/dev/null
    result $? "found: $name"
done <"$out/changes"
sed 's/iso_plant_tick(/iso_plant_tock(/' core/README.md >"$out/changed.md"
write_code "$out/changed.md"
! try 0 "$(commands core/README.md | sed -n 's/^.*\t\(.*balance.*a\.out\)$/\1/p')"
result $? "found: code that does not compile"
! known 'make cleaner' && ! known 'make run SCEEN=models/pendulum.scene' && ! known 'isochron run --metod rk4'
result $? "found: a target and a variable that are not there"
! try 0 'isochron run models/absent.scene'
result $? "found: a command that fails"
finish
