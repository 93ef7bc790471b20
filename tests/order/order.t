#!/bin/sh
# The order of every method, observed on a generated plant and on a hand-written one.
. tests/host/test.sh
begin order
ours="tests/order/order.c tests/order/plant.c tests/host/report.c"

# A plant of an implicit method has a Jacobian for all.
# shellcheck disable=SC2086
build/isoc models/double_pendulum.scene -o "$out/double_pendulum" --real double --method bdf4 >/dev/null &&
    EXTRA="-DPLANT=\"$out/double_pendulum/plant.c\"" program double_pendulum.run $ours tests/order/double_pendulum.c
result $? "double_pendulum builds"
joined double_pendulum "$out/double_pendulum.run"

# shellcheck disable=SC2086
EXTRA='-DPLANT="models/oscillator.c"' program oscillator.run $ours tests/order/oscillator.c
result $? "oscillator builds"
joined oscillator "$out/oscillator.run"
finish
