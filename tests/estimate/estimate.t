#!/bin/sh
# The local error that a checked method tells, beside the true one, on the double pendulum.
. tests/host/test.sh
begin estimate

# A plant of an implicit method has a Jacobian for all.
build/isoc models/double_pendulum.scene -o "$out/double_pendulum" --real double --method bdf4 >/dev/null &&
    EXTRA="-DPLANT=\"$out/double_pendulum/plant.c\"" program double_pendulum.run tests/estimate/estimate.c \
        tests/order/plant.c tests/order/double_pendulum.c tests/host/report.c
result $? "double_pendulum builds"
joined double_pendulum "$out/double_pendulum.run"
finish
