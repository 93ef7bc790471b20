#!/bin/sh
# Every effect of the library, from its start on, against a law that is written apart from it, in one scene with rk4.
. tests/host/test.sh
begin library_laws
one_isoc

library()
{
    python3 -B tests/isoc/effects/laws/library.py "$@"
}

library kinds models/effects
result $? 'each effect of the library has a law, and each of its outputs'
mkdir "$out/effects"
cp models/effects/*.scene "$out/effects"
cp models/effects/lag.scene "$out/effects/planted.scene"
echo 'output planted' >>"$out/effects/lag.scene"
! library kinds "$out/effects" >"$out/found" && grep -qx '# no law of planted' "$out/found" &&
    grep -qx '# no law of lag.planted' "$out/found"
result $? 'found: an effect and an output without a law'

# In double alone: in float the same text takes the same way (laws/effects.t), and hides more behind its rounding.
optimised -O0
library write "$out/library.scene"
isoc "$out/summary" '' "$out/library.scene" -o "$out/plant" --real double &&
    EXTRA="-I$out/plant" program show tests/isoc/effects/laws/rows.c "$out/plant/plant.c" && "$out/show" 8 >"$out/rows" &&
    library compare "$out/rows"
result $? 'rows 0 to 8 of each effect are what its law says'
for planted in late factor; do
    library compare "$out/rows" $planted
    result $? "found in each output: planted $planted"
done

# Effects with a defect, all in one scene: a kind, what it says, and what it says instead.
cp "$out/library.scene" "$out/planted.scene"
while IFS='|' read -r kind from to; do
    sed "s/$from/$to/" "models/effects/$kind.scene" >"$out/effect"
    ! cmp -s "$out/effect" "models/effects/$kind.scene" || result 1 "planted in $kind"
    cat "$out/effect" >>"$out/planted.scene"
    echo "$kind" >>"$out/planted"
done <<'END'
battery|next before = charge|next before = previous(before)
contact|arm = -radius|arm = radius
dc_motor|resistance \* warmth \* current - back|resistance * current - back
delayed|4 \* step|3 * step
encoder|floor(position|round(position
friction|0\.5 \* near^2|0.5 * abs(near)
gusts|side_2 + x \* side|side_2
imu|next turn = turned|next turn = turn
jammed|next held = if(active, held, position of along)|next held = position of along
rate_limit|-fall, rise|-rise, rise
sensor|next sampled = now|next sampled = previous(now)
stuck|next held = if(active, held, input)|next held = input
END
rm "$out/rows"
isoc "$out/summary" '' "$out/planted.scene" -o "$out/plant" --real double &&
    EXTRA="-I$out/plant" program show tests/isoc/effects/laws/rows.c "$out/plant/plant.c" && "$out/show" 8 >"$out/rows"
! library compare "$out/rows" >"$out/found" &&
    sed -n 's/^# \([a-z_]*\): .* in row .*/\1/p' "$out/found" | sort -u | cmp - "$out/planted"
result $? "found: a defect in $(tr '\n' ' ' <"$out/planted")and in no other"
finish
