#!/bin/sh
# Free turns: the length of a quaternion in float, energy and momentum of a tumbling body with every method, a heavy top, a
# gyroscope.
. tests/host/test.sh
begin tumble

# tumbling OPTION...: the program of models/rigid_body.scene.
tumbling()
{
    scene rigid_body "$@" && EXTRA="-I$out/rigid_body" program tumble tests/tumble/tumble.c "$out/rigid_body/plant.c"
}

# Each product of the quaternion with its scale, near 1, rounds by half an ulp of a part below 1, and the scale itself, 1.5
# less half the square of the length, by half an ulp of 1.5: together less than 4 ulp of 1.
real float
tumbling && "$out/tumble" 10000000 >"$out/float"
awk '{ exit !($1 < 4) }' "$out/float"
result $? "float, 1e7 steps of 1 ms: the quaternion is at most $(cut -d ' ' -f 1 "$out/float") ulp long or short, below 4"
echo "# energy and momentum within $(cut -d ' ' -f 2- "$out/float") after 10,000 s"

# method, order, and the most that energy and momentum may change in 20 s at 1 ms: h^order times the fifth power of the
# 5 rad/s of spin, or so; of the methods of order one and two the square or cube.
real double
while read -r method order energy momentum; do
    tumbling --method "$method" --step 2ms && "$out/tumble" 10000 >"$out/coarse" &&
        tumbling --method "$method" --step 1ms && "$out/tumble" 20000 >"$out/fine"
    result $? "$method: $(cut -d ' ' -f 2- "$out/fine") of energy and momentum in 20 s at 1 ms"
    awk -v energy="$energy" -v momentum="$momentum" '{ exit !($2 <= energy && $3 <= momentum) }' "$out/fine"
    result $? "$method: at most $energy and $momentum"
    paste -d ' ' "$out/coarse" "$out/fine" |
        awk -v p="$order" '{ exit !($2 >= 0.7 * 2 ^ p * $5 && $3 >= 0.7 * 2 ^ p * $6) }'
    result $? "$method: half the step keeps both better, by 0.7 * 2^$order and more"
done <<BOUNDS
euler 1 5e-2 3e-2
heun 2 1e-7 1e-5
rk4 4 1e-12 2e-11
ab4 4 1e-9 1e-9
semi_implicit 1 5e-2 3e-2
abm4 4 1e-10 1e-10
abm4_pec 4 1e-10 1e-10
abm4_pecece 4 1e-10 1e-10
bdf4 4 1e-9 1e-9
rosenbrock 3 5e-8 2e-8
BOUNDS

# Control: without the last step of Newton's method the length drifts.
real float
tumbling && sed 's/^    settle(memory.x);$//; s/^static void settle/static inline void settle/' "$out/rigid_body/plant.c" \
    >"$out/rigid_body/loose.c" &&
    EXTRA="-I$out/rigid_body" program loose tests/tumble/tumble.c "$out/rigid_body/loose.c" && "$out/loose" 10000000 >"$out/drift"
awk '{ exit !($1 > 4) }' "$out/drift"
result $? "control: a quaternion that nothing holds is found, $(cut -d ' ' -f 1 "$out/drift") ulp off"

# Lagrange's top keeps its energy and the momenta about the vertical and about its stem; the spin about the stem, a
# quotient of constants, to the last bits.
real double
scene top && EXTRA="-I$out/top" program top.run tests/tumble/top.c "$out/top/plant.c" tests/host/report.c
result $? "top builds"
joined top "$out/top.run"

# The gyroscope precesses at weight * lever / (inertia * spin), 0.1962 rad/s, but for the second order of precession over
# spin, 0.1962 / 500, and for what nutates.
scene gyroscope && EXTRA="-I$out/gyroscope" program gyroscope.run tests/tumble/gyroscope.c "$out/gyroscope/plant.c" tests/host/report.c
result $? "gyroscope builds"
joined gyroscope "$out/gyroscope.run"
finish
