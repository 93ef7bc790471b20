#!/bin/sh
# Whole runs of the adams method.
. tests/host/test.sh
begin adams

program adams.run tests/adams/adams.c tests/adams/problems.c tests/host/report.c
result $? "the runs build"
joined adams "$out/adams.run"
finish
