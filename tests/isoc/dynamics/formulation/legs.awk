# awk -v seed=N: a scene of a random platform on 2 to 6 legs, in a plane (odd seeds) or in space. A leg in the plane has
# two rods; one in space is a universal joint with a slide or, unless 4 divides the seed, three turns. Springs keep the
# knees bent. A closure has the platform as its parent or as its child. The platform may carry a pendulum, and stand on
# a carrier that moves.
function between(low, high) { return low + (high - low) * rand() }

function vector(x, y, z) { return sprintf("(%.17g, %.17g, %.17g)", x, y, z) }

function body(name, mass, size, along,    i) {
    i = mass * size * size * between(0.05, 0.2)
    printf "body %s { mass %.17g kg; com %s m; inertia %s kg*m^2 }\n", name, mass,
        (along == "x" ? vector(size * between(0.3, 0.7), 0, 0) : vector(0, 0, size * between(0.3, 0.7))),
        (along == "x" ? vector(0.1 * i, i, i) : vector(i, i, 0.1 * i))
}

function closes(kind, n, on_platform, on_leg, axis) {
    if (rand() < 0.5) {
        printf "close end%d %s { parent platform at %s m; child shin%d at %s m%s }\n", n, kind, on_platform, n, on_leg, axis
    } else {
        printf "close end%d %s { parent shin%d at %s m; child platform at %s m%s }\n", n, kind, n, on_leg, on_platform, axis
    }
}

# How far a knee of two rods of this size is bent, the ends of which are d apart.
function bend(d, size) { return 2 * atan2(sqrt(size ^ 2 - d ^ 2 / 4), d / 2) }

function knee(n, size, axis, angle) {
    printf "joint knee%d revolute { parent thigh%d at %s m; child shin%d; axis %s; start about %.17g rad; " \
        "spring 1 kN*m/rad rest %.17g rad }\n", n, n, vector(size, 0, 0), n, axis, angle, angle
}

# From a foot at x, y to a place on the platform at u, v.
function plane_leg(n, x, y, u, v,    d, size) {
    d = sqrt((u - x) ^ 2 + (v - y) ^ 2)
    size = d * between(0.55, 0.9)
    body("thigh" n, between(0.1, 1), size, "x")
    body("shin" n, between(0.1, 1), size, "x")
    printf "joint hip%d revolute { parent ground at %s m; child thigh%d; axis z; start about %.17g rad }\n", n, vector(x, y, 0), n,
        atan2(v - y, u - x) + bend(d, size) / 2
    knee(n, size, "z", -bend(d, size))
    closes("line", n, vector(u, v, 0), vector(size, 0, 0), "; axis z")
}

# From a foot at x, y, 0 to a place at u, v, w of the platform, which stands at 0, 0, high.
function slide_leg(n, x, y, u, v, w, high,    a, d, length_of) {
    a = u - x
    d = w + high
    length_of = sqrt(a ^ 2 + (v - y) ^ 2 + d ^ 2)
    body("thigh" n, between(0.1, 1), 0.5 * length_of, "z")
    body("shin" n, between(0.1, 1), -0.5 * length_of, "z")
    printf "joint hip%d universal { parent ground at %s m; child thigh%d; axis x; second y; " \
        "start rotate %.17g rad rotate %.17g rad }\n", n, vector(x, y, 0), n, atan2(y - v, d),
        atan2(a / length_of, sqrt(1 - (a / length_of) ^ 2))
    printf "joint slide%d prismatic { parent thigh%d; child shin%d; axis z; start %.17g m; spring 2 kN/m rest %.17g m; " \
        "damping 5 N*s/m }\n", n, n, n, length_of, length_of
    closes("spherical", n, vector(u, v, w), vector(0, 0, 0), "")
}

function turn_leg(n, x, y, u, v, w, high,    d, size) {
    d = sqrt((u - x) ^ 2 + (v - y) ^ 2 + (w + high) ^ 2)
    size = d * between(0.55, 0.9)
    body("hub" n, between(0.1, 1), 0.1, "x")
    body("thigh" n, between(0.1, 1), size, "x")
    body("shin" n, between(0.1, 1), size, "x")
    printf "joint yaw%d revolute { parent ground at %s m; child hub%d; axis z; start about %.17g rad }\n", n, vector(x, y, 0), n,
        atan2(v - y, u - x)
    printf "joint hip%d revolute { parent hub%d; child thigh%d; axis y; start about %.17g rad }\n", n, n, n,
        -atan2(w + high, sqrt((u - x) ^ 2 + (v - y) ^ 2)) - bend(d, size) / 2
    knee(n, size, "y", bend(d, size))
    closes("spherical", n, vector(u, v, w), vector(size, 0, 0), "")
}

BEGIN {
    srand(seed)
    in_plane = seed % 2
    rand()
    legs = 2 + int((in_plane ? 3 : 5) * rand())
    high = between(0.5, 1)
    printf "# A random platform on %d legs: seed %d.\ngravity %s m/s^2\nstep 1 ms\nmethod rk4\n\n", legs, seed,
        in_plane ? vector(0, -9.81, 0) : vector(0, 0, -9.81)
    place = "ground"
    if (rand() < 0.3) {
        body("carrier", 3, 0.3, "z")
        print "joint rail prismatic { parent ground; child carrier; axis x; spring 500 N/m rest 0 m; start 0 m; speed 0.2 m/s }"
        place = "carrier"
    }
    body("platform", between(2, 10), 0.4, in_plane ? "x" : "z")
    if (in_plane) {
        print "body nothing_x { mass 0 kg }\nbody nothing_y { mass 0 kg }"
        print "joint x prismatic { parent " place "; child nothing_x; axis x; start 0 m }"
        print "joint y prismatic { parent nothing_x; child nothing_y; axis y; start 0 m }"
        printf "joint turn revolute { parent nothing_y; child platform; axis z; start 0 rad }\n"
    } else {
        printf "joint afloat free { parent %s; child platform; start at %s m quaternion (1, 0, 0, 0) }\n", place, vector(0, 0, high)
    }
    for (n = 1; n <= legs; n++) {
        angle = 6.2832 * (n + between(-0.2, 0.2)) / legs
        far = between(0.8, 1.2)
        near = between(0.2, 0.4)
        beside = angle + between(-0.3, 0.3)
        if (in_plane) {
            plane_leg(n, far * cos(angle), far * sin(angle), near * cos(beside), near * sin(beside))
        } else if (seed % 4 == 0 || rand() < 0.6) {
            slide_leg(n, far * cos(angle), far * sin(angle), near * cos(beside), near * sin(beside), between(-0.1, 0.1), high)
        } else {
            turn_leg(n, far * cos(angle), far * sin(angle), near * cos(beside), near * sin(beside), between(-0.1, 0.1), high)
        }
    }
    if (rand() < 0.4) {
        body("bob", between(0.2, 1), 0.3, "x")
        print "joint swing revolute { parent platform; child bob; axis z; start -1 rad; speed 2 rad/s }"
    }
    print "output energy = energy"
    print "output violation = violation"
}
