#!/bin/sh
# States whose derivative is one number throughout a step (steady, core/methods/equations.h): isoc finds those of bodies
# that nothing accelerates, and no others; and they move as these say.
. tests/host/test.sh
begin steady
one_isoc

# found NAME WANTED METHOD SCENE: the states that a scene, on the line, has in its plant as steady are these.
found()
{
    printf 'step 1 ms\nmethod %s\n%s\n' "$3" "$4" | tr ';' '\n' >"$out/$1.scene"
    isoc "$out/summary" "$out/told" "$out/$1.scene" -o "$out/$1" --real "$real"
    result $? "$1 is compiled in $real"
    sed -n '/^static const bool steady/,/^};/s/^    \[PLANT_X_\(.*\)\] = true,$/\1/p' "$out/$1/plant.c" | tr '\n' ' ' >"$out/states"
    [ "$(cat "$out/states")" = "${2:+$2 }" ]
    result $? "$1, $3: $(cat "$out/states")"
}

body='output energy = energy; body b {; mass 2 kg; inertia (1, 2, 3) kg*m^2; }'
free='joint space free {; parent ground; child b; speed (0.1, -0.3, 0.7) m/s; spin (0.01, 5, 0.01) rad/s; }'
slide='joint rail prismatic {; parent ground; child b; axis x; start 0.1 m; speed 0.3 m/s'
for number in float double; do
    real $number
    for method in rk4 heun; do
        found free 'SPACE_X SPACE_Y SPACE_Z' $method "$body; $free"
        EXTRA="-DPLANT=\"$out/free/plant.c\"" program free.$method.$real tests/isoc/plant/steady/steady.c tests/host/report.c
        joined "free, $method, $real" "$out/free.$method.$real"
    done
    found rail RAIL rk4 "$body; $slide; }"
    EXTRA="-DPLANT=\"$out/rail/plant.c\"" program rail.$real tests/isoc/plant/steady/steady.c tests/host/report.c
    joined "rail, $real" "$out/rail.$real"
done
found falling 'SPACE_X SPACE_Y' rk4 "gravity (0, 0, -9.81) m/s^2; $body; $free"
found damped '' rk4 "$body; $slide; damping 1 N*s/m; }"
found driven '' rk4 "input push; $body; $slide; drive push; }"
found slow '' rk4 "$body; $free; effect air drag {; on b; area 1 m^2; }"
for method in euler ab4 bdf4; do
    found free_by_$method '' $method "$body; $free"
done

# A spin that is called steady too shows.
sed 's/^static const bool steady.*/&\n    [PLANT_X_SPACE_TURN_X_SPEED] = true,/' "$out/free/plant.c" >"$out/planted.c"
cp "$out/free/plant.h" "$out"
EXTRA="-DPLANT=\"$out/planted.c\"" program planted tests/isoc/plant/steady/steady.c tests/host/report.c
! "$out/planted" >"$out/tap" && grep -q '^not ok 2 ' "$out/tap"
result $? 'found: a state that does not move steadily'
finish
