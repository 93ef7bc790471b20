#!/bin/sh
# The stiff flyball governor (IFToMM benchmark A05) with the implicit methods and projection, 5 s in steps of 1 ms,
# where an explicit method needs steps below 0.34 ms. With springs and dampers as given, against the solution of its
# equations in two coordinates (Radau IIA, 58 digits); with 10,000 times of both, which leaves the legs rigid to 1e-8 m,
# the methods against each other.
. tests/host/test.sh
begin mechanism_governor
one_isoc

# stiff TIMES: the scene with springs and dampers that are so many times as stiff.
stiff()
{
    sed "s|^\\(constant stiffness =\\).*|\\1 8e5 N/m * $1|; s|^\\(constant damper =\\).*|\\1 4e4 N*s/m * $1|" \
        tests/core/methods/order/governor.scene
}

# governed NAME METHOD: arm and slider of $out/NAME.scene at 1 s and at 5 s.
governed()
{
    isoc "$out/$1.summary" '' "$out/$1.scene" -o "$out/$1" --real "$real" --method "$2" --step 1ms &&
        EXTRA=-O1 program "$1.run" tests/reference/columns.c "$out/$1/plant.c" &&
        "$out/$1.run" beta s | sed -n '10p; 50p' >"$out/$1.txt"
    result $? "$1: compiled and run"
}

# apart FILE FILE: the largest difference of two lists of numbers, four of each; of anything else nothing.
apart()
{
    paste -d ' ' "$1" "$2" | awk '{
        for (i = 1; i <= NF / 2; i++) { d = $i - $(i + NF / 2); if (d < 0) d = -d; if (d > most) most = d }
        for (i = 1; i <= NF; i++) n += $i ~ /^-?[0-9]/
    } END { if (n != 8) exit 1; printf "%.1e\n", most }'
}

# within WHAT FILE FILE LIMIT
within()
{
    off=$(apart "$2" "$3") && awk -v off="$off" -v limit="$4" 'BEGIN { exit !(off ~ /^[0-9]/ && off <= limit) }'
    result $? "$1: rad and m off by $off, at most $4"
}

printf '%s\n' '0.5218333016255462 0.5014209223795677' '0.4828745765869398 0.5355631037216435' >"$out/reference"
for method in rosenbrock bdf4; do
    stiff 1 >"$out/$method.scene"
    governed $method $method
    stiff 1e4 >"$out/stiff_$method.scene"
    governed stiff_$method $method
done
# The motion that is not damped has 7.35 rad/s: order three leaves at most (7.35 rad/s 1 ms)^3 of it.
within "rosenbrock" "$out/rosenbrock.txt" "$out/reference" 4e-7
within "bdf4" "$out/bdf4.txt" "$out/reference" 4e-7
within "10,000 times as stiff" "$out/stiff_rosenbrock.txt" "$out/stiff_bdf4.txt" 4e-7

# The springs and dampers of the legs, one as an effect, the other between points.
{
    stiff 1e4 | sed '/^    spring /d; /^    damping /d'
    echo 'effect strut { joint leg; value k N/m; value c N*s/m
    effort on leg = -k * (position of leg - 0.5 m) - c * speed of leg
}
effect strut1 strut { leg leg1; k stiffness; c damper }
spring strut2 { between eye2 and slider at (-0.05, 0, 0) m; stiffness stiffness; damping damper; length 0.5 m }'
} >"$out/struts.scene"
governed struts rosenbrock
within "an effect and a spring between points" "$out/struts.txt" "$out/stiff_rosenbrock.txt" 1e-9

# In float the augmented Lagrangian adds 2e-4 of itself to the Schur complement: a Jacobian that is off by as much does
# not hold the springs. The rounding of a state, 3e-8 in each of 5000 steps, adds up to 1.5e-4 at most.
real float
{
    stiff 1e4
    echo 'stabilisation lagrangian'
} >"$out/lagrangian.scene"
governed lagrangian bdf4
within "the augmented Lagrangian in float" "$out/lagrangian.txt" "$out/stiff_bdf4.txt" 1.5e-4

off=$(apart "$out/stiff_bdf4.txt" "$out/reference") && awk -v off="$off" 'BEGIN { exit !(off > 1e-5) }'
result $? "control: that is another motion, by $off"
finish
