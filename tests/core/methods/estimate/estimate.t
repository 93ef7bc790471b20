#!/bin/sh
# The local error that a method tells, beside the true one, on the double pendulum.
. tests/host/test.sh
begin estimate
one_isoc
optimised -O1
rolled
ours="tests/core/methods/estimate/local_error.c tests/core/methods/order/plant.c tests/core/methods/order/double_pendulum.c tests/host/report.c"

# A plant of an implicit method has a Jacobian for all. Articulated bodies round less: more errors are more than
# rounding.
# shellcheck disable=SC2086
for number in double float; do
    real $number
    isoc /dev/null '' models/double_pendulum.scene -o "$out/$number" --real $number --method bdf4 --formulation articulated &&
        EXTRA="-DPLANT=\"$out/$number/plant.c\"" program $number.run tests/core/methods/estimate/estimate.c tests/general.c $ours &&
        EXTRA="-DPLANT=\"$out/$number/plant.c\"" program adams.$number.run tests/core/methods/estimate/adams.c $ours
    result $? "double_pendulum builds in $number"
    joined double_pendulum "$out/$number.run"
    joined "adams in $number" "$out/adams.$number.run"
done
finish
