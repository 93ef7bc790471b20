#!/bin/sh
# The measurement of sine and cosine (tests/core/numbers/exhaustive/sincos.c) notices a wrong digit in any constant of
# core/numbers/sincos.h.
. tests/host/test.sh
begin check/sincos

# measure FLAG STRIDE: builds with the core/ in $out/tree first, and runs.
measure()
{
    rm -f "$out/program"
    # shellcheck disable=SC2086
    $CC -I"$out/tree" $FLAGS $1 tests/core/numbers/exhaustive/sincos.c -o "$out/program" -lm && "$out/program" "$2" >"$out/tap"
}

# planted REAL FROM TO: the measurement fails with FROM changed into TO, by its own judgement.
planted()
{
    sed "s/$2/$3/" core/numbers/sincos.h >"$out/tree/core/numbers/sincos.h"
    flag=$([ "$1" = double ] && echo -DISO_REAL_DOUBLE)
    ! measure "$flag" 200 && grep -q '^not ok' "$out/tap" && grep -qx 1..4 "$out/tap" &&
        ! cmp -s core/numbers/sincos.h "$out/tree/core/numbers/sincos.h"
    result $? "found in $1: $2 changed into $3"
}

mkdir -p "$out/tree/core/numbers"
cp core/numbers/real.h core/numbers/sincos.h "$out/tree/core/numbers"
measure "" 200 && grep -qx 1..4 "$out/tap"
result $? "the copy is good in float"
measure -DISO_REAL_DOUBLE 200 && grep -qx 1..4 "$out/tap"
result $? "the copy is good in double"

planted float 1.666665673e-1 1.666675673e-1
planted float 8.333008736e-3 8.334008736e-3
planted float 4.166665673e-2 4.166765673e-2
planted float 8.90891020676e-6 8.93891020676e-6
planted float '<< ISO_SIGN_SHIFT' '<< (ISO_SIGN_SHIFT - 1)'
planted double 3.1415926534682512 3.1415926534683512
planted double 1.215420101301238e-10 1.215420201301238e-10
planted double 8.333333333333196e-03 8.333333333433196e-03
planted double 2.087659248648486e-09 2.088659248648486e-09
# A coefficient that is off by half of its last bit biases sin^2 + cos^2; that of the cosine, in double, by the bound's
# double.
planted double 1.6666666666666666e-01 1.6666666666666669e-01
finish
