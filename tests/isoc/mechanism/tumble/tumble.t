#!/bin/sh
# Free turns: the length of a quaternion in float, energy and momentum of a tumbling body with every method, a heavy
# top, a gyroscope.
. tests/host/test.sh
begin tumble
one_isoc
optimised -O1

# tumbling OPTION...: the program of models/rigid_body.scene.
tumbling()
{
    scene rigid_body "$@" && EXTRA="-I$out/rigid_body" program tumble tests/isoc/mechanism/tumble/tumble.c "$out/rigid_body/plant.c"
}

# Each product of the quaternion with its scale, near 1, rounds by half an ulp of a part below 1, and the scale itself,
# 1.5 less half the square of the length, by half an ulp of 1.5: together less than 4 ulp of 1.
real float
tumbling && "$out/tumble" 10000000 >"$out/float"
awk '{ exit !($1 < 4) }' "$out/float"
result $? "float, 1e7 steps of 1 ms: the quaternion is at most $(cut -d ' ' -f 1 "$out/float") ulp long or short, below 4"
echo "# energy and momentum within $(cut -d ' ' -f 2- "$out/float") after 10,000 s"

# A step of a method of order p with error constant C misses C (w h / 2)^(p + 1) of the quaternion, which turns at half
# of w = 5 rad/s, and twice that of the angle. Were all steps off to the same side, energy and momentum would be by 2 T
# C (w / 2)^(p + 1) h^p after T = 20 s. C is that of y' = ly (Hairer, Norsett and Wanner 1993, ch. III.2; Hairer and
# Wanner 1996, ch. IV.7): of rk4 1/5!, of bdf4 1/5, of rosenbrock 1/4! - g/2 + 3 g^2/2 - g^3 with g = 0.43587.
real double
while read -r method order constant; do
    tumbling --method "$method" --step 2ms && "$out/tumble" 10000 >"$out/coarse" &&
        tumbling --method "$method" --step 1ms && "$out/tumble" 20000 >"$out/fine"
    result $? "$method: $(cut -d ' ' -f 2- "$out/fine") of energy and momentum in 20 s at 1 ms"
    bound=$(awk -v p="$order" -v c="$constant" 'BEGIN { printf "%.1e", 2 * 20 * c * 2.5 ^ (p + 1) * 0.001 ^ p }')
    awk -v bound="$bound" '{ exit !($2 <= bound && $3 <= bound) }' "$out/fine"
    result $? "$method: at most $bound"
    paste -d ' ' "$out/coarse" "$out/fine" |
        awk -v p="$order" '{ exit !($2 >= 0.7 * 2 ^ p * $5 && $3 >= 0.7 * 2 ^ p * $6) }'
    result $? "$method: half the step keeps both better, by 0.7 * 2^$order and more"
    awk -v bound="$bound" '{ exit !($2 > bound / 100 || $3 > bound / 100) }' "$out/fine"
    result $? "$method: which is less than 100 times as much"
done <<METHODS
euler 1 0.5
heun 2 0.166667
rk4 4 0.00833333
ab4 4 0.348611
semi_implicit 1 0.5
abm4 4 0.0263889
abm4_pec 4 0.0263889
abm4_pecece 4 0.0263889
bdf4 4 0.2
rosenbrock 3 0.0259
METHODS

# Control: without the last step of Newton's method the length drifts.
real float
tumbling && sed 's/^    settle(memory->x);$//; s/^static void settle/static inline void settle/' "$out/rigid_body/plant.c" \
    >"$out/rigid_body/loose.c" &&
    EXTRA="-I$out/rigid_body" program loose tests/isoc/mechanism/tumble/tumble.c "$out/rigid_body/loose.c" && "$out/loose" 10000000 >"$out/drift"
awk '{ exit !($1 > 4) }' "$out/drift"
result $? "control: a quaternion that nothing holds is found, $(cut -d ' ' -f 1 "$out/drift") ulp off"

# Lagrange's top keeps its energy and the momenta about the vertical and about its stem; the spin about the stem, a
# quotient of constants, to the last bits.
real double
scene top && EXTRA="-I$out/top" program top.run tests/isoc/mechanism/tumble/top.c "$out/top/plant.c" tests/host/report.c
result $? "top builds"
joined top "$out/top.run"

# The gyroscope precesses at weight * lever / (inertia * spin), 0.1962 rad/s, but for the second order of precession
# over spin, 0.1962 / 500, and for what nutates.
scene gyroscope && EXTRA="-I$out/gyroscope" program gyroscope.run tests/isoc/mechanism/tumble/gyroscope.c "$out/gyroscope/plant.c" tests/host/report.c
result $? "gyroscope builds"
joined gyroscope "$out/gyroscope.run"
finish
