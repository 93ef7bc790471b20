#!/bin/sh
# Writes the scene of the N-four-bar mechanism for N = $1 without a repeat: what models/n_four_bar.scene is in the
# short.
set -u
case ${1-} in
[1-9] | 10) ;;
*)
    echo 'usage: n_four_bar.sh N, from 1 to 10' >&2
    exit 1
    ;;
esac

# body NAME: a uniform rod of 1 kg and 1 m.
body()
{
    printf '\nbody %s {\n    mass 1 kg\n    com (0.5, 0, 0) m\n    inertia (0, 1, 1) * (1 kg * (1 m)^2 / 12)\n}\n' "$1"
}

# joint NAME PARENT CHILD START SPEED
joint()
{
    printf '\njoint %s revolute {\n    parent %s\n    child %s\n    axis z\n    start %s deg\n    speed %s rad/s\n}\n' "$@"
}

cat <<HEAD
# N windows of rods in a row for N = $1, benchmark A02 of the IFToMM library of multibody problems: N + 1 upright rods
# of 1 kg and 1 m, hinged to the ground, N such rods across their tops. Whenever all lie flat the closures lose rank.

gravity (0, -9.81, 0) m/s^2
step 1 ms
method rk4
stabilisation lagrangian
HEAD
i=0
while [ "$i" -le "$1" ]; do
    body "upright$i"
    joint "hinge$i" "ground at ($i, 0, 0) m" "upright$i" 90 -1
    i=$((i + 1))
done
i=0
while [ "$i" -lt "$1" ]; do
    body "bar$i"
    joint "corner$i" "upright$i at (1, 0, 0) m" "bar$i" -90 1
    printf '\nclose window%s line {\n    parent upright%s at (1, 0, 0) m\n    child bar%s at (1, 0, 0) m\n    axis z\n}\n' \
        "$i" $((i + 1)) "$i"
    i=$((i + 1))
done
cat <<TAIL

output angle = position of hinge0
output b0 = position of upright0 at (1, 0, 0) m
output b0_velocity = velocity of upright0 at (1, 0, 0) m
output violation = violation
output energy = energy
TAIL
