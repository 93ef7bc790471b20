#!/bin/sh
# A step that prepares the first evaluation of the next one makes the states of one that does not, to the last bit,
# whatever its inputs do: an arm with outputs of accelerations beside the same without them.
. tests/host/test.sh
begin prepared
one_isoc
optimised -O1

sed '/^output .* = acceleration /d' models/arm6.scene >"$out/bare.scene"
cp models/arm6.scene "$out/arm6.scene"

# states SCENE METHOD [ARGUMENT]: in $out/SCENE.METHOD, of its plant in $real.
states()
{
    isoc "$out/summary" '' "$out/$1.scene" -o "$out/$1" --method "$2" --real "$real" &&
        program "$1.run" tests/promises/cost/prepared.c "$out/$1/plant.c" && "$out/$1.run" >"$out/$1.$2" &&
        [ "$(sort -u "$out/$1.$2" | grep -c .)" -gt 20 ]
}

for case in 'double rk4' 'float rk4' 'float euler'; do
    real "${case% *}"
    states arm6 "${case#* }" && states bare "${case#* }" && cmp "$out/arm6.${case#* }" "$out/bare.${case#* }"
    result $? "$case: the same states"
    grep -q 'prepare(memory->x' "$out/arm6/plant.c" && ! grep -q prepare "$out/bare/plant.c"
    result $? "$case: one prepares its steps, the other does not"
done
"$out/arm6.run" untold >"$out/untold" && ! cmp -s "$out/untold" "$out/arm6.euler" &&
    [ "$(head -n 12 "$out/untold")" = "$(head -n 12 "$out/arm6.euler")" ]
result $? "control: written states of which the plant is not told"
finish
