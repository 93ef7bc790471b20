#!/bin/sh
# The order of every method, observed on a generated plant, on a closed loop and on a hand-written plant; of semi-implicit
# Euler on bodies that turn freely too.
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
build/isoc tests/order/four_bar.scene -o "$out/four_bar" --real double >/dev/null &&
    EXTRA="-DPLANT=\"$out/four_bar/plant.c\"" program four_bar.run $ours tests/order/four_bar.c
result $? "four_bar builds"
joined four_bar "$out/four_bar.run"

# shellcheck disable=SC2086
EXTRA='-DPLANT="models/oscillator.c"' program oscillator.run $ours tests/order/oscillator.c
result $? "oscillator builds"
joined oscillator "$out/oscillator.run"

for name in tumble top; do
    build/isoc "tests/order/$name.scene" -o "$out/$name" --real double >/dev/null &&
        EXTRA="-DPLANT=\"$out/$name/plant.c\"" program "$name.run" tests/order/turning.c tests/order/plant.c tests/host/report.c
    result $? "$name builds"
    joined "$name" "$out/$name.run"
done
finish
