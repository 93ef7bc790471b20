#!/bin/sh
# Sub-steps of a tick (`substeps 4`): the plant moves as with a quarter of the step, to the bit, where its inputs are
# constant; on the board as on the host; and at four times the cost.
. tests/host/test.sh
begin substeps
one_isoc
quick

# same SCENE METHOD REAL: whether both plants have the same bits.
same()
{
    real "$3"
    # Functions of time are sampled once a tick: constants in their place.
    sed 's/^\(input [a-z]*\) = .*/\1 = 1.5 N/' "$1" >"$out/held.scene"
    sed '$asubsteps 4' "$out/held.scene" >"$out/parted.scene"
    isoc "$out/summary" "$out/errors" "$out/parted.scene" --step 1ms --method "$2" --real "$3" --name parted -o "$out/plants" &&
        isoc "$out/summary" "$out/errors" "$out/held.scene" --step 0.25ms --method "$2" --real "$3" --name fine -o "$out/plants" &&
        EXTRA="-I$out/plants" program compare tests/core/methods/substeps/compare.c "$out/plants/parted.c" "$out/plants/fine.c" &&
        "$out/compare" >"$out/hash" && read -r hash <"$out/hash"
}

for method in rk4 semi_implicit ab4 abm4 bdf4 rosenbrock; do
    same models/double_pendulum.scene $method float
    result $? "double_pendulum, $method, float: the bits of a quarter of the step: $hash"
done
same models/double_pendulum.scene abm4 double
result $? "double_pendulum, abm4, double: $hash"
for scene in models/four_bar models/gyroscope models/cart_pole tests/promises/hard/rotor; do
    same $scene.scene rk4 float
    result $? "${scene##*/}, rk4, float: $hash"
done
sed 's/PARTS = 4/PARTS = 3/' tests/core/methods/substeps/compare.c >"$out/three.c" &&
    EXTRA="-I$out/plants" program three "$out/three.c" "$out/plants/parted.c" "$out/plants/fine.c" && ! "$out/three" >"$out/hash"
result $? "found: another number of sub-steps"

# On the board.
run()
{
    tools/isochron run "$out/$1.scene" --target "$2" --seconds 0.5 >"$out/$1.$2" 2>"$out/errors"
}
value()
{
    sed -n "s/^$2 //p" "$out/$1"
}
cp models/double_pendulum.scene "$out/one.scene"
{ cat models/double_pendulum.scene && echo 'substeps 4'; } >"$out/four.scene"
run one cortex-m4f && run four cortex-m4f && run four host && [ "$(value four.host hash)" = "$(value four.cortex-m4f hash)" ]
result $? "the board has the bits of the host: $(value four.host hash)"
one=$(value one.cortex-m4f instructions_per_step) four=$(value four.cortex-m4f instructions_per_step)
[ "$four" -gt $((4 * one - 80)) ] && [ "$four" -lt $((4 * one + 80)) ]
result $? "four sub-steps take $four instructions, one number, a step $one"
stated core/README.md "the double pendulum takes $four instructions for $one."
result $? 'as core/README.md says'
isoc "$out/summary" '' "$out/one.scene" -o "$out/one" && { cat "$out/one.scene" && echo 'substeps 1'; } >"$out/one/one.scene" &&
    isoc "$out/summary" '' "$out/one/one.scene" -o "$out/again" && cmp -s "$out/one/plant.c" "$out/again/plant.c"
result $? "one sub-step is a step: the same bytes"
{ cat "$out/one.scene" && printf 'method adams\nsubsteps 8\n'; } | sed '/^method rk4/d' >"$out/adams.scene"
isoc "$out/summary" '' "$out/adams.scene" --method rk4 -o "$out/again" && ! grep -q 'part(' "$out/again/plant.c"
result $? "the budget of adams is no number of sub-steps of another method"
finish
