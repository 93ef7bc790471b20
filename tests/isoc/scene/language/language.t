#!/bin/sh
# What the scene language computes and abbreviates, against the same scene written out in numbers.
. tests/host/test.sh
begin language
one_isoc

program elementary tests/isoc/scene/language/elementary.c tools/isoc/base/elementary.c
joined elementary "$out/elementary"

# plant FOLDER: compiles the scene on stdin.
plant()
{
    mkdir -p "$out/$1"
    cat >"$out/$1/same.scene"
    isoc "$out/$1/summary" '' "$out/$1/same.scene" -o "$out/$1" --real double
}

# same NAME: whether the last plants in the folders new and old are one, but for the scene's lines that comments quote.
same()
{
    for of in new old; do
        sed 's|/\*.*\*/||; /^ *$/d' "$out/$of/plant.c" >"$out/$of.c"
        rm -f "$out/$of/plant.c"
    done
    [ -s "$out/new.c" ] && cmp "$out/new.c" "$out/old.c"
    result $? "$1"
}

# A pendulum whose every number is a formula, and the same in numbers: exact ones, or the nearest double.
plant new <<'END'
gravity (0, -9.81, 0) m/s^2
step 1 ms
tunable phi = 30 deg
constant height = sqrt((3 m)^2 + (4 m)^2)
body bob { mass exp(0) * 1 kg; com (1 m * tan(phi), -max(2 m, 500 mm, 1 m), min(0, 1 m)); inertia (1, 1, 1) g*m^2 }
joint pivot revolute {
    parent ground at (height, 1 m * cos(90 deg), abs(-tan(45 deg)) * 1 m) rotate acos(1 / 2) about x
    child bob; axis z; start atan2(1, 1); speed log(2) * 1 rad/s; drive push
}
input push = 1 N*m * sin(3 Hz) + 1 N*m * asin(0.5) / (1 rad)
output angle = position of pivot
END
plant old <<'END'
gravity (0, -9.81, 0) m/s^2
step 1 ms
tunable phi = 30 deg
body bob { mass 1 kg; com (1 m * (sin(phi) / cos(phi)), -2 m, 0); inertia (1, 1, 1) g*m^2 }
joint pivot revolute {
    parent ground at (5, 0, 1) m rotate 1.0471975511965977462 rad about x
    child bob; axis z; start 45 deg; speed 0.69314718055994530942 rad/s; drive push
}
input push = 1 N*m * sin(3 Hz) + 0.52359877559829887308 N*m
output angle = position of pivot
END
same 'functions in values give the plant that their numbers give'

# A repeat is what it stands for.
sh tests/isoc/scene/language/n_four_bar.sh 3 | plant old
sed 's/^constant windows = 2/constant windows = 3/' models/n_four_bar.scene | plant new
same 'models/n_four_bar.scene with three windows is what n_four_bar.sh writes out'

# An operand that is a vector, one that has its default, and a quantity by its point and component.
plant new <<'END'
step 1 ms
gravity (0, 0, -9.81) m/s^2
body kite { mass 1 kg; com (0, 0, 1) m; inertia (1, 1, 1) g*m^2 }
joint line universal { parent ground; child kite; axis x; second y; start rotate 10 deg rotate 20 deg }
effect air {
    body on
    signal wind m/s = (0, 0, 0)
    value drag N*s/m = (0, 0, 0)
    let past = wind - velocity of on
    force on on = (1 N*s/m) * past - cross((0, 0, 1), wind) * 2 N*s/m + drag * (0 m/s)
    require dot(wind, wind) >= 0
    output past
}
input gust m/s = 1 m/s * sin(3 Hz)
signal blown = (1, 0, 0) * gust
effect up air { on kite at (0, 0, 1) m; wind blown }
effect calm air { on kite }
output z = velocity of kite at (0, 0, 1) m along z
output low = 2 * position of kite at (0, 0, -1) m along y
output past = up.past
END
plant old <<'END'
step 1 ms
gravity (0, 0, -9.81) m/s^2
body kite { mass 1 kg; com (0, 0, 1) m; inertia (1, 1, 1) g*m^2 }
frame under { on kite at (0, 0, -1) m }
joint line universal { parent ground; child kite; axis x; second y; start rotate 10 deg rotate 20 deg }
effect up_air {
    body on
    signal x m/s
    let wind = (1, 0, 0) * x
    let past = wind - velocity of on
    force on on = (1 N*s/m) * past - cross((0, 0, 1), wind) * 2 N*s/m
    output x_past = dot(past, (1, 0, 0))
    output y_past = dot(past, (0, 1, 0))
    output z_past = dot(past, (0, 0, 1))
}
effect calm_air {
    body on
    force on on = (-1 N*s/m) * velocity of on
}
input gust m/s = 1 m/s * sin(3 Hz)
effect up up_air { on kite at (0, 0, 1) m; x gust }
effect calm calm_air { on kite }
output z = velocity of kite at (0, 0, 1) m along z
output low = 2 * dot(position of under, (0, 1, 0))
output past_x = up.x_past
output past_y = up.y_past
output past_z = up.z_past
END
same 'operands can be vectors, and formulas ask for points and components'

# Two loops in one another, names with a rest, an index after a digit, and a file for each turn.
mkdir -p "$out/new/parts"
cat >"$out/new/parts/arm.scene" <<'END'
include "../mass.scene"
joint arm[i] universal { parent ground at (i, 0, 0) m; child bob2[i]; axis x; second y; start rotate 10 deg rotate (i) deg }
output a[i]_rate = speed of arm[i]_first
END
echo 'body bob2[i] { mass i * weight; com (0, 0, -1) m; inertia (1, 1, 1) g*m^2 }' >"$out/new/mass.scene"
plant new <<'END'
step 1 ms
gravity (0, 0, -9.81) m/s^2
constant weight = 100 g; constant most = 1 + 1
repeat i from 1 to most { include "parts/arm.scene" }
repeat i from 1 to 0 { step 2 ms }
repeat i from 0 to 1 { repeat j from 2 * i to 2 {
    output p[i][j] = position of bob2[i + 1] at (j, 0, 0) m along z } }
END
plant old <<'END'
step 1 ms
gravity (0, 0, -9.81) m/s^2
body bob2_1 { mass 100 g; com (0, 0, -1) m; inertia (1, 1, 1) g*m^2 }
joint arm1 universal { parent ground at (1, 0, 0) m; child bob2_1; axis x; second y; start rotate 10 deg rotate 1 deg }
output a1_rate = speed of arm1_first
body bob2_2 { mass 200 g; com (0, 0, -1) m; inertia (1, 1, 1) g*m^2 }
joint arm2 universal { parent ground at (2, 0, 0) m; child bob2_2; axis x; second y; start rotate 10 deg rotate 2 deg }
output a2_rate = speed of arm2_first
output p0_0 = position of bob2_1 at (0, 0, 0) m along z
output p0_1 = position of bob2_1 at (1, 0, 0) m along z
output p0_2 = position of bob2_1 at (2, 0, 0) m along z
output p1_2 = position of bob2_2 at (2, 0, 0) m along z
END
same 'repeats in one another, and files that are included in them'
build/isoc "$out/new/same.scene" --files | sed "s|$out/||" | tr '\n' ' ' >"$out/files"
[ "$(cat "$out/files")" = 'new/same.scene new/parts/arm.scene new/parts/../mass.scene new/parts/arm.scene new/parts/../mass.scene ' ]
result $? "--files lists them: $(cat "$out/files")"

# Frames on frames wherever a body can stand, and a body without mass: two hinges in series are a universal joint.
body='gravity (0, -9.81, 0) m/s^2; step 1 ms; tunable reach = 1 m; input push
body arm { mass 1 kg; com (0, -0.5, 0) m; inertia (1, 1, 1) g*m^2 }
body fore { mass 1 kg; com (0, -0.5, 0) m; inertia (1, 1, 2) g*m^2 }'
plant new <<END
$body
body cross { mass 0 }
frame last { on tip at (0, -10, 0) mm rotate 10 deg about x }
frame tip { on fore at (0, -reach, 0) }
frame base { on ground at (0, 1, 0) m rotate 90 deg about x }
frame end { on arm at (0, -1, 0) m rotate 30 deg about z }
joint shoulder revolute { parent base; child arm; axis z }
joint wrist_first revolute { parent end; child cross; axis x; start 20 deg; speed 1 rad/s }
joint wrist_second revolute { parent cross; child fore; axis y; start 30 deg; speed 2 rad/s }
close pin distance { parent base at (1, 0, 0) m; child last }
force kick { body last; axis y; drive push }
output place = position of last
output velocity = velocity of tip
output orientation = orientation of last
output spin = spin of last along y
output rest = position of base along y
output force = force of shoulder
END
plant old <<END
$body
body hand { mass 0 }
body peg { mass 0 }
joint shoulder revolute { parent ground at (0, 1, 0) m rotate 90 deg about x; child arm; axis z }
joint wrist universal {
    parent arm at (0, -1, 0) m rotate 30 deg about z; child fore; axis x; second y
    start rotate 20 deg rotate 30 deg; spin (1, 2) rad/s
}
joint glue fixed { parent fore at (0, -reach - 10 mm, 0) rotate 10 deg about x; child hand }
joint nail fixed { parent ground at (0, 1, 0) m rotate 90 deg about x; child peg }
close pin distance { parent peg at (1, 0, 0) m; child hand }
force kick { body hand; axis y; drive push }
output place = position of hand
output velocity = velocity of fore at (0, -reach, 0)
output orientation = orientation of hand
output spin = spin of hand along y
output rest = position of peg along y
output force = force of shoulder
END
same 'frames, and a body without mass'

# Solids: a turn about an axis through the centre takes one over the moment of inertia, which is computed by hand here.
{
    cat <<'END'
step 1 ms
input torque = 1 N*m
END
    number=0
    while read -r axis want words; do
        number=$((number + 1))
        echo "$want" >>"$out/moments"
        echo "body b$number { $words }"
        echo "joint j$number revolute { parent ground; child b$number; axis $axis; drive torque }"
        echo "output a$number = acceleration of j$number"
    done <<'END'
x 13/12*3 box (1, 2, 3) m of 3 kg
y 10/12*3 box (1, 2, 3) m of 3 kg
z 5/12*3 box (1, 2, 3) m of 3 kg
z 5/12*3+3*(0.25+4) box (1, 2, 3) m of 3 kg at (0.5, 2, 1) m
x 2*(3*0.04+0.25)/12 cylinder (0.2, 0.5) m of 2 kg
z 2*0.04/2 cylinder (0.2, 0.5) m of 2 kg
x 2*0.04/2 cylinder (0.2, 0.5) m of 2 kg rotate 90 deg about y
y 0.4*2*0.09 sphere 0.3 m of 2 kg
x 4/12*5 rod 2 m of 5 kg
x 4/12*5+5 rod 2 m of 5 kg at (0, 0, 1) m
x 4/12*5*0.75 rod 2 m of 5 kg rotate 30 deg about y rotate 0 deg about x; sphere 0 m of 1 kg
z 2*(0.09+0.04)/2 tube (0.3, 0.2, 1) m of 2 kg
y 2*(3*(0.09+0.04)+1)/12 tube (0.3, 0.2, 1) m of 2 kg
x 1*0.75+2*0.25 lump (1, 2, 2) kg*m^2 of 1 kg rotate 30 deg about z
z 2 lump (1, 2, 2) kg*m^2 of 1 kg rotate 30 deg about z
x 1*0.75+2*0.25 mass 1 kg; inertia (1, 2, 2) kg*m^2 rotate 30 deg about z
x 2*0.4*2*0.01+2*2*0.25+1/12 sphere 0.1 m of 2 kg at (0, 0, 0.5) m; sphere 10 cm of 2 kg at (0, 0, -0.5) m; rod 1 m of 1 kg
z 2*0.4*2*0.01 sphere 0.1 m of 2 kg at (0, 0, 0.5) m; sphere 10 cm of 2 kg at (0, 0, -0.5) m; rod 1 m of 1 kg
END
} >"$out/solids.scene"
count=$(wc -l <"$out/moments")
isoc "$out/solids.txt" '' "$out/solids.scene" -o "$out/solids" --real double &&
    EXTRA=-O0 program solids.run tests/isoc/scene/language/last.c "$out/solids/plant.c"
"$out/solids.run" 1 $(seq -f 'a%.0f' "$count") | tr ' ' '\n' | paste - "$out/moments" >"$out/pairs"
# Some ten roundings of 1.1e-16 each.
told=$(perl -lane '$off = abs $F[0] * eval($F[1]) - 1; $worst = $off unless $off <= $worst;
    END { printf "%.1e", $worst; exit !($. == 18 && $worst < 2e-15) }' "$out/pairs")
result $? "moments of inertia of solids are those by hand: off by $told"

# Lumps of one body are bodies that fixed joints weld to it.
plant new <<'END'
gravity (0, -9.81, 0) m/s^2; step 1 ms; tunable load = 2 kg
body arm {
    box (10, 20, 30) mm of load at (0, -0.3, 0) m rotate 30 deg about x rotate 10 deg about y
    cylinder (1, 30) cm of 1 kg at (0.1, 0, 0) m rotate 90 deg about y
    lump (3, 4, 5; 0.1, 0.2, 0.3) g*m^2 of 300 g at (0, 0, 5) mm
}
joint pivot spherical { parent ground; child arm; spin (1, 2, 3) rad/s }
output place = position of arm at (0, 1, 0) m
output energy = energy
END
plant old <<'END'
gravity (0, -9.81, 0) m/s^2; step 1 ms; tunable load = 2 kg
body arm { mass 0 }
body a1 { box (10, 20, 30) mm of load }
body a2 { mass 1 kg; inertia ((0.01 m)^2 / 4 + (0.3 m)^2 / 12, (0.01 m)^2 / 4 + (0.3 m)^2 / 12, (0.01 m)^2 / 2) * (1 kg) }
body a3 { mass 300 g; inertia (3, 4, 5; 0.1, 0.2, 0.3) g*m^2 }
joint pivot spherical { parent ground; child arm; spin (1, 2, 3) rad/s }
joint f1 fixed { parent arm at (0, -0.3, 0) m rotate 30 deg about x rotate 10 deg about y; child a1 }
joint f2 fixed { parent arm at (0.1, 0, 0) m rotate 90 deg about y; child a2 }
joint f3 fixed { parent arm at (0, 0, 5) mm; child a3 }
output place = position of arm at (0, 1, 0) m
output energy = energy
END
same 'a body of several solids is that of bodies welded together'

# told NAME SCENE LINE...: what isoc says of the scene, without the lines that it shows.
told()
{
    name=$1
    scene=$2
    shift 2
    printf '%s\n' "$@" >"$out/expected"
    ! isoc /dev/null "$out/said" "$scene" -o "$out/bad" && grep ': error: ' "$out/said" | sed "s|$out/||g" | cmp - "$out/expected"
    result $? "$name"
}

mkdir -p "$out/circle"
echo 'include "b.scene"' >"$out/circle/a.scene"
printf 'step 1 ms\ngravity (0, 0, 1) m; include "c.scene"\nbody one { mass 1 kg }\n' >"$out/circle/b.scene"
printf 'include "a.scene"\ninclude "none.scene"\ninclude "."\nbody one { mass 1 kg }\nstep 1 ms\n' >"$out/circle/c.scene"
told 'a circle, a missing file, and errors by the file they are in' "$out/circle/a.scene" \
    "circle/b.scene:2:9: error: gravity is in m/s^2; this is in m" \
    "circle/c.scene:1:9: error: an include in a circle: circle/a.scene includes circle/b.scene, which includes circle/c.scene, which includes circle/a.scene" \
    "circle/c.scene:2:9: error: cannot include 'none.scene': No such file or directory" \
    "circle/c.scene:3:9: error: cannot include '.': a directory, not a scene: name a .scene file in it" \
    "circle/c.scene:4:6: error: the name 'one' is already used in line 3 of circle/b.scene" \
    "circle/c.scene:5:1: error: a second 'step'; the first is in line 1 of circle/b.scene"
for n in $(seq 20); do
    echo "include \"$((n + 1)).scene\"" >"$out/circle/$n.scene"
done
told 'files 20 deep' "$out/circle/1.scene" 'circle/17.scene:1:1: error: repeats and includes in one another, more than 16 deep'
# A spin in the axes of the ground. The frame and the start turn x, y, z of the child to -x, z, y of the ground.
spinning()
{
    cat <<END
step 1 ms
body top { mass 1 kg; inertia (1, 2, 3) g*m^2 }
body base { mass 1 kg }
joint weld fixed { parent ground rotate 90 deg about z; child base }
joint air free { parent base; child top; start quaternion (0.5, 0.5, 0.5, 0.5); spin $1 }
output spin = spin of top
END
}
spinning '(1, 2, 3) rad/s in ground' | plant new
spinning '(-1, 3, 2) rad/s' | plant old
same "a spin in the ground's axes is that in the child's"

# The point of a quantity is a product, in outputs and within formulas; a sum stands in parentheses.
pointed()
{
    cat <<END
step 1 ms
body bob { mass 1 kg; com (0, -1, 0) m }
joint pivot revolute { parent ground; child bob; axis z; start 1 rad }
output tip = position of bob at $1
output shift = position of bob at $1 - (1, 0, 0) m
END
}
pointed '2 * (0, -1, 0) m' | plant new
pointed '((0, -1, 0) m + (0, -1, 0) m)' | plant old
same "a product and a sum in parentheses are the same point"
finish
