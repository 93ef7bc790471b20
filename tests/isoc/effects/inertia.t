#!/bin/sh
# inertia of BODY and of JOINT in the formulas of effects: what a push meets; and what contact derives from it.
. tests/host/test.sh
begin effects_inertia
one_isoc
quick

# met SCENE: its pushes, tried.
met()
{
    isoc "$out/summary" '' "$1" -o "$out/$real" --real "$real" &&
        EXTRA="-DPLANT=\"$out/$real/plant.c\"" program "$real.run" tests/isoc/effects/inertia.c tests/host/report.c
}
for number in float double; do
    real $number
    met tests/isoc/effects/inertia.scene
    joined $number "$out/$number.run"
done
sed 's/inertia of on at beside/inertia of on/' tests/isoc/effects/inertia.scene >"$out/planted.scene"
met "$out/planted.scene"
! "$out/double.run" >"$out/tap" && [ "$(grep -c '^not ok' "$out/tap")" -eq 3 ]
result $? 'found: the inertia at another point'

# chosen NAME: what isoc chose in the summary.
chosen()
{
    sed -n "s/^stable floor\.$1 \([^ ]*\).*/\1/p" "$out/summary"
}

# near NUMBER FORMULA: to the digits that are printed.
near()
{
    awk -v found="$1" "BEGIN { expected = $2; exit !(found != \"\" && (found - expected)^2 <= (1e-8 * expected)^2) }"
}
contact='gravity (0, 0, -9.81) m/s^2; step 1 ms; method rk4; output energy = energy'
ball='body ball { sphere 5 cm of 0.3 kg }; joint air free { parent ground; child ball; start at (0, 0, 0.3) m }
effect floor contact { ball ball; radius 5 cm; impact 1 m/s; rest 1; friction 0.4 }'
printf '%s\n' "$contact" "$ball" >"$out/ball.scene"
isoc "$out/summary" '' "$out/ball.scene" -o "$out" && near "$(chosen load)" 0.3 &&
    near "$(chosen stiffness)" '0.3 * (3.14159265358979 / 16 * 1000)^2' && near "$(chosen grip)" '0.3 / 4 * 2.7853 * 500'
result $? "contact of a ball has its mass: $(chosen load) kg, $(chosen stiffness) N/m, $(chosen grip) N*s/m"

# Its slip moves the wheel alone, inertia / radius^2 = 0.04 kg; a quarter of all is too much for the step.
wheel='body cart { mass 10 kg }; body wheel { cylinder (50, 20) mm of 80 g rotate 90 deg about x }
joint slide prismatic { parent ground; child cart; axis z; start 6 cm }
joint axle revolute { parent cart; child wheel; axis y; continuous; speed 1 rad/s }
effect floor contact { ball wheel; radius 5 cm; impact 1 m/s; friction 0.4'
printf '%s\n' "$contact" "$wheel }" >"$out/wheel.scene"
isoc "$out/summary" "$out/told" "$out/wheel.scene" -o "$out" && [ ! -s "$out/told" ] && near "$(chosen load)" 10.08 &&
    near "$(chosen grip)" '0.04 * 2.7853 * 500'
result $? "contact of a light wheel under a heavy body grips by the wheel: $(chosen load) kg, $(chosen grip) N*s/m"
printf '%s\n' "$contact" "$wheel; grip 10.08 kg / 4 * 2.7853 * 500 /s }" >"$out/wheel.scene"
isoc "$out/summary" "$out/told" "$out/wheel.scene" -o "$out" && grep -q "warning: the effect 'floor' is too fast" "$out/told"
result $? 'found: a grip by the whole mass is too fast for the step'
finish
