#!/bin/sh
# A thin disc rolls in general position: steady motions, and motions that tumble, on planes and with axles of several
# directions, by an explicit and by an implicit method; and discs that cannot stand are refused.
. tests/host/test.sh
begin rolling_disc

# disc NAME METHOD: the plant of a disc as the variables say.
disc()
{
    mkdir -p "$out/$1"
    cat >"$out/$1/disc.scene" <<END
step 0.5 ms
method $2
stabilisation projection
gravity -9.81 m/s^2 * $normal
body disc { mass 2 kg; inertia $inertia kg*m^2 }
joint air free { parent ground; child disc; start at 0.3 m * sin(theta) * $normal $turned; spin $spin rad/s }
constant theta = $theta rad
close floor rolling { parent ground; child disc; axis $axis; radius 30 cm; wheel $wheel }
output at = position of disc
output axle = position of disc at 1 m * $wheel
output energy = energy
output contact = force of floor
END
    build/isoc "$out/$1/disc.scene" -o "$out/$1" --real double >"$out/$1/said" 2>&1
}

# rolls NAME METHOD: that disc against the equations by hand.
rolls()
{
    disc "$1" "$2" && program "$1.run" tests/isoc/closure/rolling/disc.c "$out/report.o" "$out/$1/plant.c"
    result $? "$1 builds"
    # shellcheck disable=SC2086
    joined "$1" "$out/$1.run" $theta $pqr $normal_numbers
}

# across AXIS: where the disc is, from theta, p, q and r: on the ground, below a ceiling that pulls it up, on a slope;
# with its axle along z, x, or between them.
place()
{
    # shellcheck disable=SC2086
    set -- "$1" $pqr
    case $1 in
    ground)
        axis=z normal='(0, 0, 1)' wheel='(0, 0, 1)' inertia='(0.045, 0.045, 0.09)'
        turned='rotate theta about x'
        spin="($2, $3, $4)"
        ;;
    ceiling)
        axis=-y normal='(0, -1, 0)' wheel='(1, 0, 0)' inertia='(0.09, 0.045, 0.045)'
        turned='rotate theta - 90 deg about z'
        spin="($4, -($3), $2)"
        ;;
    slope)
        axis='(0, 3, 4)' normal='(0, 0.6, 0.8)' wheel='(0.6, 0, 0.8)'
        inertia='(0.0612, 0.045, 0.0738; 0, 0.0216, 0)'
        turned='rotate asin(-0.6) about x rotate theta about x rotate -asin(0.6) about y'
        spin="(0.8 * ($2) + 0.6 * ($4), $3, 0.8 * ($4) - 0.6 * ($2))"
        ;;
    esac
    normal_numbers=$(echo "$normal" | tr -d '(),')
}

# shellcheck disable=SC2086
"$CC" $FLAGS $REAL_FLAG -c tests/host/report.c -o "$out/report.o"
theta=1.1
pqr='0.5 1 -4'
place ground
rolls tumbling rk4
rolls tumbling_bdf4 bdf4
place ceiling
rolls tumbling_below rk4
place slope
rolls tumbling_on_a_slope rk4

# Steady: a precession of 2 rad/s at this angle, with the spin that it needs.
theta=1.2
pqr=$(awk -v t=$theta 'BEGIN {
    s = sin(t); c = cos(t); psi = 2
    printf "0 %.17g %.17g", psi * s, (0.045 * psi * psi * s * c - 2 * 9.81 * 0.3 * c) / ((0.09 + 2 * 0.09) * psi * s) }')
place ground
rolls steady rk4
place ceiling
rolls steady_below rk4

# refused TEXT NAME
refused()
{
    ! disc refused rk4 && grep -q "$1" "$out/refused/said"
    result $? "$2"
}
place ground
turned='rotate 0 deg about x' theta=0
refused 'lies flat on its plane at the start, or is below it' 'a disc that lies flat is refused'
turned='rotate -90 deg about x' theta=-1.5707963267948966
refused 'lies flat on its plane at the start, or is below it' 'a disc below its plane is refused'
finish
