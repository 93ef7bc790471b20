# shellcheck shell=sh
# The C files by the reals that they are written for; read by checkers with `. tests/host/sources.sh`.

# Programs that need a plant made by a test are compiled by that test: those of tests/firmware, and what includes one.
needy=$(grep -rlE --include='*.c' '^#include (PLANT|"(new|old)\.h")' tests | xargs grep -L '^#ifndef PLANT')
# For both reals; the rest, for the host only: the tools, which are always in double, and tests, of which that is checked.
both=$(find core port/sim models tests/unit tests/exhaustive tests/check tests/tap.c -name '*.c' | sort)
once=$(find tools tests -name '*.c' ! -path 'tests/firmware/*' | sort | grep -vxF "$both
$needy")
