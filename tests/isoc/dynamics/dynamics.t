#!/bin/sh
# Generated plants against dynamics written in other ways: maximal coordinates and formulas by hand, in long double.
. tests/host/test.sh
begin dynamics
one_isoc
optimised -O0
. tests/isoc/dynamics/solver.sh

for real in float double; do
    real $real
    compare
    for name in arm6 tree pendulum double_pendulum cart_pole; do
        for formulation in articulated composite; do
            # shellcheck disable=SC2086
            scene "$name" --formulation $formulation &&
                program "$name.compare" "tests/isoc/dynamics/table_$name.c" "$out/$name/plant.c" $compare
            result $? "$name builds in $real, $formulation"
            joined "$name in $real, $formulation" "$out/$name.compare"
        done
    done
done

for name in arm6 tree pendulum double_pendulum cart_pole; do
    program "$name.power" tests/isoc/dynamics/power.c "tests/isoc/dynamics/table_$name.c" tests/host/report.c "$out/$name/plant.c"
    result $? "$name builds with its power"
    joined "$name" "$out/$name.power"
done

for name in pendulum double_pendulum cart_pole; do
    for plant in "$out/$name/plant.c" "tests/promises/handwritten/$name.c"; do
        # shellcheck disable=SC2086
        program "$name.closed" tests/isoc/dynamics/closed.c "tests/isoc/dynamics/closed_$name.c" \
            "tests/isoc/dynamics/table_$name.c" "$plant" $solver
        result $? "$plant builds with its formula"
        joined "$plant" "$out/$name.closed"
    done
done
finish
