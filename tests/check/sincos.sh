#!/bin/sh
# The measurement of sine and cosine (tests/exhaustive/sincos.c) notices a wrong digit in any constant of core/numbers/sincos.h.
. tests/host/test.sh
begin check/sincos

# measure FLAG STRIDE: builds with the core/ in $out/tree first, and runs.
measure()
{
    rm -f "$out/program"
    # shellcheck disable=SC2086
    $CC -I"$out/tree" $FLAGS $1 tests/exhaustive/sincos.c -o "$out/program" -lm && "$out/program" "$2" >"$out/tap"
}

# planted REAL FROM TO: the measurement fails with FROM changed into TO, by its own judgement.
planted()
{
    sed "s/$2/$3/" core/numbers/sincos.h >"$out/tree/core/numbers/sincos.h"
    flag=$([ "$1" = double ] && echo -DISO_REAL_DOUBLE)
    ! measure "$flag" 200 && grep -q '^not ok' "$out/tap" && grep -qx 1..3 "$out/tap" &&
        ! cmp -s core/numbers/sincos.h "$out/tree/core/numbers/sincos.h"
    result $? "found in $1: $2 changed into $3"
}

mkdir -p "$out/tree/core/numbers"
cp core/numbers/real.h core/numbers/sincos.h "$out/tree/core/numbers"
measure "" 200 && grep -qx 1..3 "$out/tap"
result $? "the copy is good in float"
measure -DISO_REAL_DOUBLE 200 && grep -qx 1..3 "$out/tap"
result $? "the copy is good in double"

planted float 1.6666654611e-1 1.6666754611e-1
planted float 8.3321608736e-3 8.3421608736e-3
planted float 4.166664568298827e-2 4.166764568298827e-2
planted float 7.54978995489188216e-8 7.56978995489188216e-8
planted float 'ISO_SIGN_SHIFT - 1' 'ISO_SIGN_SHIFT - 2'
planted double 1.57079632673412561417e+00 1.57079632673412661417e+00
planted double 6.07710050650619224932e-11 6.07710060650619224932e-11
planted double 8.33333333332248946124e-03 8.33333333342248946124e-03
planted double 2.08757232129817482790e-09 2.08767232129817482790e-09
finish
