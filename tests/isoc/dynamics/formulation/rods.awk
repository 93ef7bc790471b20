# awk -v seed=N: a scene of 3 to 8 random rods in a plane, each on one before it or on the ground: of any length, hung
# at an end along x, along -y or aslant, some with the centre of mass beside their line, some with an armature. Of a rod
# along an axis articulated bodies have simpler equations.
function between(low, high) { return low + (high - low) * rand() }

BEGIN {
    srand(seed)
    rods = 3 + int(6 * rand())
    print "# Random rods: seed " seed ".\ngravity (0, -9.81, 0) m/s^2\nstep 1 ms\nmethod rk4\n"
    for (i = 1; i <= rods; i++) {
        kind = int(4 * rand())
        size = between(0.2, 2)
        end_x[i] = kind == 0 ? size : kind == 1 ? 0.6 * size : 0
        end_y[i] = kind == 0 ? 0 : kind == 1 ? -0.8 * size : -size
        part = between(0.2, 0.8)
        beside = rand() < 0.3 ? 0.1 * size : 0
        mass = between(0.1, 10)
        parent = i == 1 || rand() < 0.1 ? 0 : rand() < 0.2 ? 1 + int((i - 1) * rand()) : i - 1
        place = parent == 0 ? "ground" : sprintf("rod%d at (%.17g, %.17g, 0) m", parent, end_x[parent], end_y[parent])
        inertia = mass * size * size * between(0.05, 0.2)
        printf "body rod%d { mass %.17g kg; com (%.17g, %.17g, 0) m; inertia (%.17g, %.17g, %.17g) kg*m^2 }\n", i, mass,
            part * end_x[i] + beside, part * end_y[i], 0.6 * inertia, 0.6 * inertia, inertia
        printf "joint j%d revolute { parent %s; child rod%d; axis z; start %.17g deg; speed %.17g rad/s%s }\n", i, place, i,
            between(-180, 180), between(-3, 3), (rand() < 0.2 ? sprintf("; armature %.17g kg*m^2", between(0.01, 0.1)) : "")
    }
    print "output energy = energy"
}
