#!/bin/sh
# `isochron digits`: the digits that reference solutions are met with, as the tests measure them.
mkdir -p build/tests
for name in reference mechanisms; do
    MAKES_DIGITS=yes sh "tests/reference/$name.t" >"build/tests/digits.$name" || {
        grep '^not ok' "build/tests/digits.$name" >&2
        exit 1
    }
done
echo '| reference | real | step | until | largest error | digits | demanded | energy off by, J | demanded |'
echo '|---|---|---|--:|--:|--:|--:|--:|--:|'
cat build/tests/reference/digits build/tests/reference_mechanisms/digits
