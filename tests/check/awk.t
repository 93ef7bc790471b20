#!/bin/sh
# Programs of awk are such that each awk runs them: those in files are parsed by that of Kernighan, which has the
# grammar of POSIX; those in scripts print no comparison without brackets, which that refuses and mawk does not; and no
# variable has the name of a function or a word of gawk.
. tests/host/test.sh
begin check/awk
mkdir "$out/empty"

# parses FILE: in an empty folder, since an awk that has parsed a program also runs it.
parses()
{
    (cd "$out/empty" && exec original-awk -f "$OLDPWD/$1" </dev/null >../said 2>&1)
    ! grep 'syntax error\|illegal statement' "$out/said"
}

# unbracketed FILE...: the lines of scripts in which awk prints a choice by a comparison without brackets around it.
compares=' (<|==|<=|>=|!=|~) '
unbracketed()
{
    grep -nE "(print|printf) [^;}']*$compares[^;}']*\?" "$@" | grep -vE "\(([^()]|\([^()]*\))*$compares[^()]*\?"
}

# of_gawk FILE...: the lines of files that give such a name to a variable by -v.
words='adump|and|asort|asorti|bindtextdomain|case|compl|dcgettext|dcngettext|default|extension|fflush|func|gensub|include|isarray'
words="$words|load|lshift|mkbool|mktime|namespace|or|patsplit|rshift|stopme|strftime|strtonum|switch|systime|typeof|xor"
of_gawk()
{
    grep -nE -- "-v ($words)=" "$@"
}

for file in $(find core models port tests tools -name '*.awk' | sort); do
    parses "$file" >&2 || wrong="${wrong-}$file "
done
[ -z "${wrong-}" ]
result $? "programs of awk in files are those of POSIX; others: ${wrong-none}"
find core models port tests tools Makefile \( -name '*.sh' -o -name '*.t' -o -name '*.mk' -o -name Makefile \) >"$out/scripts"
# shellcheck disable=SC2046
! unbracketed $(grep -vxF tests/check/awk.t "$out/scripts") >&2
result $? "nor do scripts print a comparison without brackets"
# shellcheck disable=SC2046
! of_gawk $(grep -vxF tests/check/awk.t "$out/scripts") >&2
result $? "no variable has a name of gawk"

echo 'END { print NR == 1 ? "one" : "more" }' >"$out/wrong.awk"
! parses "$out/wrong.awk" >"$out/found" && [ -s "$out/found" ]
result $? "found: a comparison that is printed without brackets"
echo "awk '{ print \$1, \$2 < 3 ? \"less\" : \"more\" }'" >"$out/wrong.sh"
unbracketed "$out/wrong.sh" >"$out/found"
result $? "found: one in a script"
echo 'awk -v load=3 "END { print load }"' >"$out/wrong.sh"
of_gawk "$out/wrong.sh" >"$out/found"
result $? "found: a variable load"
finish
