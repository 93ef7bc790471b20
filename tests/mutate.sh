#!/bin/sh
# Mutates lines of FILE... one at a time in a copy of the project, runs the tests that use the file, and lists the
# mutations that no test finds: what a test is missing for.
#
#     MUTATIONS=20 SEED=1 sh tests/mutate.sh core/runtime/policy.h tools/isoc/base/nearest.c
#
#     MUTATIONS  so many of each file, drawn with SEED; default: all
#     SECONDS    for all files together; what is left is told; default: no limit
#     TESTS      these tests, instead of those that follow from the file (tests/mutate/mutate.py says which)
#     AGAIN      yes: also mutations that an earlier call has tried; else their results are taken over from build/tests/mutations/results
#
# Exit status 1 if a mutation survives that tests/mutate/equivalent.txt does not have.
set -e
[ $# -gt 0 ] || {
    sed -n '2,/^$/s/^#\( \|$\)//p' "$0"
    exit 1
}
mkdir -p build/tests/mutations
exec python3 tests/mutate/mutate.py "$@"
