#!/bin/sh
# Generated pendulums against reference solutions: the error is that of the method, within 3x.
. tests/host/test.sh
begin reference
one_isoc
. tests/reference/digits.sh

for name in pendulum double_pendulum; do
    scene "$name" && program "$name.run" tests/reference/reference.c "tests/reference/$name.c" tests/host/report.c \
        "$out/$name/plant.c"
    result $? "$name builds"
    joined "$name" "$out/$name.run"
    digits "$(echo "$name" | tr _ ' ')" double 1ms
done
listed -E '^. (double )?pendulum'
finish
