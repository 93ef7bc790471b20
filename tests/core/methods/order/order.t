#!/bin/sh
# The order of every method, observed on a generated plant, on a closed loop and on a hand-written plant; of
# semi-implicit Euler on bodies that turn freely too.
. tests/host/test.sh
begin order
one_isoc
optimised -O0
rolled
ours="tests/core/methods/order/order.c tests/core/methods/order/plant.c tests/host/report.c"

# A plant of an implicit method has a Jacobian for all.
# shellcheck disable=SC2086
isoc /dev/null '' models/double_pendulum.scene -o "$out/double_pendulum" --real double --method bdf4 &&
    EXTRA="-DPLANT=\"$out/double_pendulum/plant.c\"" program double_pendulum.run $ours tests/core/methods/order/double_pendulum.c
result $? "double_pendulum builds"
joined double_pendulum "$out/double_pendulum.run"

# shellcheck disable=SC2086
isoc /dev/null '' models/double_pendulum.scene -o "$out/sines" --real double --method rk4 &&
    EXTRA="-DPLANT=\"$out/sines/plant.c\"" program sines.run $ours tests/core/methods/order/double_pendulum.c
result $? "double_pendulum builds with stages that take sines from those of the start"
joined sines "$out/sines.run" sines

# shellcheck disable=SC2086
isoc /dev/null '' tests/core/methods/order/four_bar.scene -o "$out/four_bar" --real double &&
    EXTRA="-DPLANT=\"$out/four_bar/plant.c\"" program four_bar.run $ours tests/core/methods/order/four_bar.c
result $? "four_bar builds"
joined four_bar "$out/four_bar.run"

# shellcheck disable=SC2086
EXTRA='-DPLANT="models/oscillator.c"' program oscillator.run $ours tests/core/methods/order/oscillator.c
result $? "oscillator builds"
joined oscillator "$out/oscillator.run"

for name in tumble top; do
    isoc /dev/null '' "tests/core/methods/order/$name.scene" -o "$out/$name" --real double &&
        EXTRA="-DPLANT=\"$out/$name/plant.c\"" program "$name.run" tests/core/methods/order/turning.c tests/core/methods/order/plant.c tests/host/report.c
    result $? "$name builds"
    joined "$name" "$out/$name.run"
done

# In float the error of a method is that in double, and what rounding adds: each rounded coefficient of a method drives
# a state off by up to half an epsilon of all its motion, which is some 20 m or rad, or per second, in this second. So
# an order shows as far as that lets it. Steps of which nothing is carried to the next add half an ulp each: the
# control. near PLANT [plain]: whether all errors are.
near()
{
    "$out/$1.float" errors ${2:+"$2"} | paste - "$out/double.tsv" | awk -F'\t' '
        { off = $3 > $6 ? $3 - $6 : $6 - $3; wrong = wrong || $1 != $4 || $2 != $5 }
        off > most { most = off; name = $1 " with 2^-" $2 " s" }
        END { printf "%.1e, of %s", most, name; exit !(!wrong && NR >= 50 && most <= 20 * 2 ^ -23) }' >"$out/most"
}

# shellcheck disable=SC2086
for plant in double_pendulum oscillator; do
    source=models/oscillator.c
    if [ $plant = double_pendulum ]; then
        source=$out/float/plant.c
        isoc /dev/null '' models/double_pendulum.scene -o "$out/float" --real float --method bdf4
    fi
    real float
    EXTRA="-DPLANT=\"$source\"" program $plant.float $ours tests/core/methods/order/$plant.c
    result $? "$plant builds in float"
    real double
    "$out/$plant.run" errors >"$out/double.tsv"
    near "$plant"
    result $? "$plant in float: every error is that in double, to $(cat "$out/most")"
    if [ $plant = double_pendulum ]; then
        ! near "$plant" plain
        result $? "control: $plant in float, plain sums: to $(cat "$out/most")"
    fi
done
finish
