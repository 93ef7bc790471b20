#!/bin/sh
# Where two ways to assemble a loop meet, its start is a double root: found to the rounding, not to its root, and said;
# where loops have a freedom, or meet what no start can tell apart, that is said instead. `make run` shows what was
# assembled.
. tests/host/test.sh
. tests/host/project.sh
begin scenes/assembly
project

# slider_crank CRANK PIN GUIDE [SECOND]: a crank of 153 mm and a rod of 306 mm, with these properties of their joints;
# with a second such loop beside it, if there is a fourth argument.
slider_crank()
{
    printf 'step 1 ms\n'
    for side in a ${4:+b}; do
        cat <<END
body crank_$side { mass 38 g; inertia (1, 1, 1) * 1e-4 kg*m^2 }
body rod_$side { mass 38 g; inertia (1, 1, 1) * 1e-4 kg*m^2 }
body slider_$side { mass 76 g }
joint shaft_$side revolute { parent ground; child crank_$side; axis z; $1 }
joint pin_$side revolute { parent crank_$side at (153, 0, 0) mm; child rod_$side; axis z; $2 }
joint guide_$side prismatic { parent ground; child slider_$side; axis x; $3 }
close piston_$side line { parent slider_$side; child rod_$side at (306, 0, 0) mm; axis z }
END
    done
    echo 'output place = position of guide_a'
}

# assembled TEXT NAME [NOT]: what isoc says of the scene in $out/linkage.scene holds, or does not hold, a line like
# this.
assembled()
{
    build/isoc "$out/linkage.scene" -o "$out" --real double >"$out/said" 2>&1
    if [ $# -gt 2 ]; then
        ! grep -Eq "$1" "$out/said" && grep -q '^state_bytes' "$out/said"
    else
        grep -Eq "$1" "$out/said"
    fi
    result $? "$2"
}

near_zero='(0|-?[0-9.]+e-(1[3-9]|[2-9][0-9]))'
slider_crank 'start about 20 deg' '' 'start 459 mm' >"$out/linkage.scene"
assembled '^dead_position shaft_a pin_a$' 'an outer dead centre is said'
grep -Eq "^assembled shaft_a $near_zero rad$" "$out/said"
result $? "and found: $(sed -n 's/^assembled shaft_a //p' "$out/said")"
slider_crank '' '' 'start 459 mm' >"$out/linkage.scene"
assembled '^dead_position shaft_a pin_a$' 'likewise from where no gap is left'
slider_crank '' '' 'start 459 mm' >"$out/linkage.scene"
assembled '^assembled pin' 'and what is there already is not moved' not
slider_crank 'start about 170 deg' 'start about 170 deg' 'start 153 mm' >"$out/linkage.scene"
assembled '^dead_position shaft_a pin_a$' 'an inner dead centre is said'
slider_crank 'start about 20 deg' '' 'start 459 mm' second >"$out/linkage.scene"
assembled '^dead_position shaft_a pin_a shaft_b pin_b$' 'two loops at their dead centres are said'
[ "$(grep -Ec "^assembled shaft_[ab] $near_zero rad$" "$out/said")" = 2 ]
result $? "and both are found: $(sed -n 's/^assembled shaft_. //p' "$out/said" | paste -s -)"
slider_crank 'start about 20 deg' '' 'start 458.99 mm' >"$out/linkage.scene"
assembled '^dead_position' 'control: 10 um beside it there are two ways' not
grep -Eq '^assembled shaft_a 0.0[0-9]+ rad$' "$out/said"
result $? "one of which is found: $(sed -n 's/^assembled shaft_a //p' "$out/said")"
slider_crank 'start about 20 deg' '' '' >"$out/linkage.scene"
assembled 'leave 1 of 3 coordinates undetermined' 'a freedom is no dead centre'

# A distance that is the least possible one, as the axle of a car axis has it.
cat >"$out/linkage.scene" <<'END'
step 1 ms
body left { mass 1 kg }
body right { mass 1 kg }
joint strut prismatic { parent ground; child left; axis y; start 0.5 m }
body hub { mass 1 kg }
joint swing revolute { parent ground at (1, 0, 0) m; child hub; axis z; start 0 rad }
joint leg prismatic { parent hub; child right; axis y }
close axle distance { parent left; child right; length 1 m }
output place = position of leg
END
assembled '^assembled leg 0\.5(0000000)? m$' 'the least distance is found'
grep -qx 'dead_position leg' "$out/said"
result $? 'and said'

# A flat parallelogram, which could fold: its ways meet there; and its freedom is still one.
parallelogram()
{
    sed -e 's/^stabilisation .*/stabilisation baumgarte/' -e 's/^ *\(start\|speed\) .*//' models/parallelogram.scene
}
parallelogram >"$out/linkage.scene"
assembled 'leave 1 of 3 coordinates undetermined' 'a flat parallelogram has one freedom'
parallelogram | sed '/joint crank_shaft/s/$/ start 0 deg/' >"$out/linkage.scene"
assembled 'ways to move meet at the start, where the constraints have rank 1, and 2 beside it' 'and two ways to move'

slider_crank '' 'start about 90 deg' 'start 400 mm' >"$out/project/shown.scene"
isochron run shown.scene --seconds 0.01
grep -Eq '^assembled shaft_a [-0-9.]+ rad$' "$out/output"
result $? 'make run shows what was assembled'
finish
