#!/bin/sh
# Constants below the least normal float, 1.2e-38, that follow from numbers that a float holds: random products,
# quotients and sums against fractions.
. tests/host/test.sh
begin language_tiny
one_isoc
real float
optimised -O0

# rows PLANT: its outputs in rows 0 to 10.
rows()
{
    EXTRA="-I$1" program show tests/isoc/effects/laws/rows.c "$1/plant.c" && "$out/show" 10 >"$out/rows"
}

for seed in 1 2 3; do
    python3 -B tests/isoc/scene/language/tiny.py write $seed "$out/tiny.scene"
    isoc "$out/summary" "$out/errors" "$out/tiny.scene" -o "$out/plant" && rows "$out/plant" &&
        python3 -B tests/isoc/scene/language/tiny.py compare "$out/tiny.scene" "$out/rows" >"$out/compared"
    result $? "60 formulas of seed $seed are rounded as others are"
    cat "$out/errors" "$out/compared"
done

# The control: products that are not scaled down.
mkdir -p "$out/unscaled"
cp "$out/plant/plant.h" "$out/unscaled"
sed 's/ \* R(1.1754944e-38)//' "$out/plant/plant.c" >"$out/unscaled/plant.c"
rows "$out/unscaled" && ! python3 -B tests/isoc/scene/language/tiny.py compare "$out/tiny.scene" "$out/rows" >"$out/compared"
result $? "found: a scale that is left out, $(sed -n 's/.*compared, //p' "$out/compared")"

# A divisor has no scale, and a sum that is itself as small has fewer digits: both are refused.
for formula in 's / (1e-20 * 1e-20)' '1e-20 * 1e-20 + 1e-35 * s'; do
    sed "s|^    output f0 = .*|    output f0 = $formula|; s|^input v = .*|input v = 1e-9 * (1 + time / (1 s))|" "$out/tiny.scene" >"$out/refused.scene"
    ! isoc "$out/summary" "$out/errors" "$out/refused.scene" -o "$out/refused" &&
        grep -q 'the equations contain' "$out/errors"
    result $? "refused: $formula"
    cat "$out/errors"
done
finish
