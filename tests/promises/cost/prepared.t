#!/bin/sh
# A step that prepares the first evaluation of the next one makes the states of one that does not, to the last bit,
# whatever its inputs do: an arm with an output of an acceleration, and one with outputs that read sines, beside the
# same with outputs of angles alone; and a pendulum, whose step is one piece, with and without its tip.
. tests/host/test.sh
begin prepared
one_isoc
optimised -O1

cp models/arm6.scene models/pendulum.scene "$out"
sed '/^output .* = acceleration /d' models/arm6.scene >"$out/sines.scene"
sed '/^output .*\(acceleration\|tool\|energy\)/d' models/arm6.scene >"$out/bare.scene"
sed '/^output .*\(tip\|energy\)/d' models/pendulum.scene >"$out/angle.scene"

# states SCENE METHOD [ARGUMENT]: in $out/SCENE.METHOD, of its plant in $real.
states()
{
    isoc "$out/summary" '' "$out/$1.scene" -o "$out/$1" --method "$2" --real "$real" &&
        program "$1.run" tests/promises/cost/prepared.c "$out/$1/plant.c" && "$out/$1.run" >"$out/$1.$2" &&
        [ "$(sort -u "$out/$1.$2" | grep -c .)" -gt 3 ]
}

for case in 'double rk4' 'float rk4' 'float euler'; do
    real "${case% *}"
    states arm6 "${case#* }" && states bare "${case#* }" && cmp "$out/arm6.${case#* }" "$out/bare.${case#* }"
    result $? "$case: the same states"
    grep -q 'prepare(memory->x' "$out/arm6/plant.c" && ! grep -q prepare "$out/bare/plant.c"
    result $? "$case: one prepares its steps, the other does not"
    states sines "${case#* }" && cmp "$out/sines.${case#* }" "$out/bare.${case#* }"
    result $? "$case: the same with sines in common"
done
grep -q 'iso_find_sines(NULL, [0-9]*, memory->x' "$out/sines/plant.c"
[ $? = 1 ] && states sines rk4 && grep -q 'iso_find_sines(.*, [0-9]*, memory->x' "$out/sines/plant.c" && ! grep -q 'prepare(' "$out/sines/plant.c"
result $? "a method of several stages shares sines alone, where no output is an acceleration; one of one stage does not"
states pendulum rk4 && states angle rk4 && cmp "$out/pendulum.rk4" "$out/angle.rk4" &&
    grep -q prepared "$out/pendulum/plant.c" && ! grep -q prepared "$out/angle/plant.c"
result $? "a step in one piece shares them too"
"$out/pendulum.run" untold >"$out/untold" && ! cmp -s "$out/untold" "$out/pendulum.rk4"
result $? "control: written angles of which the plant is not told"
"$out/arm6.run" untold >"$out/untold" && ! cmp -s "$out/untold" "$out/arm6.euler" &&
    [ "$(head -n 12 "$out/untold")" = "$(head -n 12 "$out/arm6.euler")" ]
result $? "control: written states of which the plant is not told"
finish
