#!/bin/sh
# After a projection the closures hold to the second order of what the states were off by: the speeds are those that the
# closures demand where the positions have moved to, also where sums of angles turn as one
# (tools/isoc/dynamics/phasors.c).
. tests/host/test.sh
begin order_projected
. tests/core/methods/order/settled.sh
quick
program projected.o -c tests/core/methods/order/projected.c
result $? "tests/core/methods/order/projected.c compiles"

# projected NAME: runs the plant of that folder.
projected()
{
    settled "$1" "$out/$1/plant.c" "$out/projected.o" && "$out/$1.run" >"$out/$1.tap"
}

for scene in models/four_bar models/n_four_bar models/slider_crank models/squeezer tests/core/methods/order/governor tests/core/methods/order/spatial; do
    name=${scene##*/}
    sed '/^stabilisation/d' "$scene.scene" >"$out/$name.scene"
    build/isoc "$out/$name.scene" -o "$out/$name" --real double --method ab4 >"$out/$name.summary" 2>&1 && projected "$name"
    result $? "$name: $(sed -n 's/.*ok 2 - //p' "$out/$name.tap")"
done

# Control: sines and cosines that turn the wrong way.
cp -r "$out/n_four_bar" "$out/wrong"
sed -i '/Projection of the speeds/,/Closures/s/ + \(.*\) \* / - \1 * /' "$out/wrong/plant.c"
! cmp -s "$out/n_four_bar/plant.c" "$out/wrong/plant.c" && ! projected wrong && grep -q '^not ok 2' "$out/wrong.tap"
result $? "control: n_four_bar, turned the wrong way: $(sed -n 's/.*ok 2 - //p' "$out/wrong.tap")"
finish
