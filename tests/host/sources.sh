# shellcheck shell=sh
# The C files by the reals that they are written for; read by checkers with `. tests/host/sources.sh`.

# Programs that need a plant are compiled by the test that makes it: those of tests/use/firmware, what includes one, and
# what is of plants side by side. A header of the project is named with its folder.
needy=$(grep -rlE --include='*.c' '^#include (PLANT|CLOCK_OF|CHANNEL_OF|"[a-z_]+\.[ch]")' tests tools | xargs grep -L '^#ifndef PLANT'
    grep -rl --include='*.c' --exclude-dir=isoc 'ISO_LANES' tools)
# For both reals; the rest, for the host only: the tools, which are always in double, and tests, of which that is
# checked.
# The parts of a unit test stand in the folder of its name.
units=$(for unit in tests/core/*/*.c; do
    echo "$unit"
    [ ! -d "${unit%.c}" ] || echo "${unit%.c}"
done)
# shellcheck disable=SC2086
both=$(find core port/host port/posix port/unix models/*.c $units tests/core/numbers/exhaustive tests/check tests/tap.c -name '*.c' | sort)
once=$(find tools tests -name '*.c' ! -path 'tests/use/firmware/*' | sort | grep -vxF "$both
$needy")
