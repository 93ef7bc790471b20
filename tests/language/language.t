#!/bin/sh
# What the scene language computes and abbreviates, against the same scene written out in numbers.
. tests/host/test.sh
begin language

program elementary tests/language/elementary.c tools/isoc/base/elementary.c
joined elementary "$out/elementary"

# plant FOLDER: compiles the scene on stdin.
plant()
{
    mkdir -p "$out/$1"
    cat >"$out/$1/same.scene"
    build/isoc "$out/$1/same.scene" -o "$out/$1" --real double >"$out/$1/summary"
}

# same NAME: whether the last plants in the folders new and old are one, but for the scene's lines that comments quote.
same()
{
    for of in new old; do
        sed 's|/\*.*\*/||' "$out/$of/plant.c" >"$out/$of.c"
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
finish
