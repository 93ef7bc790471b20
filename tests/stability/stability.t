#!/bin/sh
# Where every method is stable, in float and in double.
. tests/host/test.sh
begin stability
rolled

for type in float double; do
    real $type
    program $type.run tests/stability/stability.c tools/isoc/mechanism/growth.c tools/isoc/mechanism/limits.c tests/host/report.c
    result $? "$type builds"
    joined $type "$out/$type.run"
done
finish
