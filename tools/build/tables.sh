#!/bin/sh
# Rewrites the generated tables in Markdown files. A table is between the lines
#
#     <!-- make cost PARTS=models -->
#     <!-- end -->
#
# the first of which names the command that prints it; tables and lists of its output are kept. Called by `make tables`:
#
#     tables.sh FILE...
set -u

fail()
{
    echo "$1" >&2
    exit 1
}

# rewritten: the file on the input, with the output of its commands.
rewritten()
{
    inside=no
    while IFS= read -r line; do
        case $line in
        '<!-- end -->') inside=no ;;
        esac
        [ $inside = yes ] || printf '%s\n' "$line"
        case $line in
        '<!-- isochron '* | '<!-- build/isoc '*)
            inside=yes
            command=${line#<!-- }
            command=${command% -->}
            case $command in
            isochron*) command="tools/$command" ;;
            esac
            text=$(sh -c "$command" </dev/null) || fail "failed: $command"
            text=$(printf '%s\n' "$text" | grep '^[|-]\|^$')
            printf '\n%s\n\n' "$text"
            ;;
        esac
    done
    [ $inside = no ] || fail "a table without an end"
}

mkdir -p build
for file; do
    rewritten <"$file" >build/rewritten.md || fail "$file stays as it is"
    if cmp -s build/rewritten.md "$file"; then
        echo "$file is unchanged"
    else
        cat build/rewritten.md >"$file"
        echo "$file is rewritten"
    fi
done
