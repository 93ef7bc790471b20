#!/bin/sh
# Every C file stands as .clang-format says, and comments of scripts and makefiles end at column 120.
. tests/host/test.sh
begin check/format

find core port models tools tests -name '*.[ch]' | sort | xargs clang-format -n --Werror >"$out/found" 2>&1
status=$?
grep error: "$out/found" | sed 's/^/# /' | head -n 20
result $status "clang-format has nothing to change"

printf 'int  f(void){return 1;}\n' >"$out/planted.c"
clang-format -n --Werror "$out/planted.c" >/dev/null 2>&1
[ $? -ne 0 ]
result $? "found: a line that is not formatted"

# wide FILE...: comment lines beyond column 120, but for indented ones, which show a call.
wide()
{
    awk 'length > 120 && /^ *# [^ ]/ && !/^ *# shellcheck / { print "# " FILENAME ":" FNR; found = 1 } END { exit !found }' "$@"
}
find Makefile core port models tools tests -name Makefile -o -name '*.sh' -o -name '*.t' -o -name '*.awk' -o -name '*.mk' >"$out/scripts"
# shellcheck disable=SC2046
! wide $(cat "$out/scripts")
result $? "comments end at column 120"
printf '%121s\n' ' ' | sed 's/^../# a/' >"$out/planted.sh"
wide "$out/planted.sh" >"$out/found"
result $? "found: a comment that is wider"
finish
