# shellcheck shell=sh
# The C files by the reals that they are written for; read by checkers with `. tests/host/sources.sh`.

# Programs that need a plant are compiled by the test that makes it: those of tests/use/firmware, and what includes one.
# A header of the project is named with its folder.
needy=$(grep -rlE --include='*.c' '^#include (PLANT|CLOCK_OF|CHANNEL_OF|"[a-z_]+\.[ch]")' tests tools | xargs grep -L '^#ifndef PLANT')
# For both reals; the rest, for the host only: the tools, which are always in double, and tests, of which that is
# checked.
both=$(find core port/host port/posix port/unix models/*.c $(ls tests/core/*/*.c) $(ls -d tests/core/*/*/ | sed "s|/$||" | while read -r part; do [ ! -f "$part.c" ] || echo "$part"; done) tests/core/numbers/exhaustive tests/check tests/tap.c -name '*.c' | sort)
once=$(find tools tests -name '*.c' ! -path 'tests/use/firmware/*' | sort | grep -vxF "$both
$needy")
