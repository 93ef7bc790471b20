#!/bin/sh
# The order of every method, observed on a generated plant and on a hand-written one.
. tests/host/test.sh
begin order
ours="tests/order/order.c tests/host/report.c"

# shellcheck disable=SC2086
scene double_pendulum &&
    program double_pendulum.run $ours tests/order/double_pendulum.c "$out/double_pendulum/plant.c"
result $? "double_pendulum builds"
joined double_pendulum "$out/double_pendulum.run"

# shellcheck disable=SC2086
program oscillator.run $ours tests/order/oscillator.c models/oscillator.c
result $? "oscillator builds"
joined oscillator "$out/oscillator.run"
finish
