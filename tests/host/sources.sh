# shellcheck shell=sh
# The C files by the reals that they are written for; read by checkers with `. tests/host/sources.sh`.

# Programs of tests/firmware are compiled by their own test, with the plants that it makes.
# For both reals; the rest, for the host only: the tools, which are always in double, and tests, of which that is checked.
both=$(find core port/sim models tests/unit tests/exhaustive tests/check tests/tap.c -name '*.c' | sort)
once=$(find tools tests -name '*.c' ! -path 'tests/firmware/*' | sort | grep -vxF "$both")
