#!/bin/sh
# Whole runs of the adams method.
. tests/host/test.sh
begin adams

program adams.run tests/core/methods/adaptive/adams.c tests/core/methods/adaptive/problems.c tests/host/report.c
result $? "the runs build"
joined adams "$out/adams.run"
finish
