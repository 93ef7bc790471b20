#!/bin/sh
# cppcheck finds nothing: in double everywhere, and in float in what goes to a target.
. tests/host/test.sh
. tests/host/sources.sh
begin check/cppcheck

# cppcheck reads no header of the system: what core asks of <float.h> and <limits.h> it has from the compiler.
"$CC" -std=c11 -E -dM -include float.h -include limits.h -x c /dev/null |
    grep -E '^#define (_*CHAR_BIT_*|_*(FLT|DBL)_[A-Z0-9_]+) ' >"$out/limits.h"

# check ARGUMENT...: fails if there is anything to say.
check()
{
    cppcheck --quiet --std=c11 --enable=warning,performance,portability --inline-suppr --error-exitcode=1 -I. \
        -D__GNUC__ -D__NO_MATH_ERRNO__ '-D_Noreturn=__attribute__((noreturn))' --include="$out/limits.h" "$@" >"$out/found" 2>&1
    status=$?
    sed 's/^/# /' "$out/found" | head -n 40
    return $status
}

# What goes to a target, always; of the tools and the tests a tenth by turns, all with the argument `all`.
turn=$(turn_of 10 "${1-}")
echo "# turn $turn of the tools and the tests"
number=0
for file in $both $once; do
    case $file in
    tools/* | tests/*) number=$((number + 1)) && { [ "$turn" = all ] || [ $((number % 10)) -eq "$turn" ]; } && echo "$file" ;;
    *) echo "$file" ;;
    esac
done >"$out/files"

check core port models
result $? "cppcheck has nothing to say in float"
check -DISO_REAL_DOUBLE --file-list="$out/files" port/mps2
result $? "cppcheck has nothing to say in double"

printf 'int f(int n);\nint f(int n)\n{\n    int a[2] = {1, 2};\n    return n > 0 ? a[n] : a[2];\n}\n' >"$out/planted.c"
! check "$out/planted.c" >/dev/null
result $? "found: an index beyond the end"
finish
