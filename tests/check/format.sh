#!/bin/sh
# Every C file stands as .clang-format says.
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
finish
