"""Laws of the effects on bodies, each on its own: the force is mass times what an accelerometer at the centre of mass would
measure, in the axes of the body; the moment shows in the power, force times velocity of its point and moment times spin."""
import math

from law import GRAVITY, STEP, cross, dot, hunt_crossley, law, noise, rows_of, run, scaled, sum_of, turned, turned_back


def free(name, mass, start, effect):
    """A free body with its start, whose centre of mass is its origin."""
    return """body %s { mass %g kg; inertia (3, 4, 5) g*m^2 }
    joint %s_joint free { parent ground; child %s; %s }
    """ % (name, mass, name, name, start) + effect + "\n"


def seen(name, effect, at="(0, 0, 0) m"):
    """Outputs of a free body: the place p and the velocity v of a point, the orientation o, the spin w, the specific force f
    at the centre of mass, and the power of an effect."""
    return "\n".join(
        line.replace("NAME", name)
        for line in (
            "NAME_p:3 = position of NAME at %s" % at,
            "NAME_v:3 = velocity of NAME at %s" % at,
            "NAME_o:4 = orientation of NAME",
            "NAME_w:3 = spin of NAME",
            "NAME_f:3 = specific_force of NAME",
            "NAME_power = power of %s" % effect,
        )
    )


def shown(row, name, mass, force, moment=(0, 0, 0)):
    """The specific force and the power of a force at the point and of a moment, both in the axes of the ground."""
    spin = turned(row[name + "_o"], row[name + "_w"])
    return {
        name + "_f": scaled(1 / mass, turned_back(row[name + "_o"], force)),
        name + "_power": dot(force, row[name + "_v"]) + dot(moment, spin),
    }


@law(
    "drag",
    free(
        "ball",
        0.3,
        "start at (0, 0, 0.3) m; speed (3, 1, -2) m/s; spin (0, 5, 2) rad/s",
        """effect breeze drag { on ball at (0, 0.02, 0.1) m; area 400 cm^2; density 1.3 kg/m^3
            wind_x wave * 1 m/s / 1 V; wind_z 1 m/s }""",
    ),
    seen("ball", "breeze", "(0, 0.02, 0.1) m") + "\nball_loss = breeze.loss",
)
@rows_of
def drag(row, k):
    against = sum_of(row["ball_v"], [row["wave"], 0, 1], -1)
    force = scaled(-1.3 * 0.04 / 2 * math.sqrt(dot(against, against)), against)
    given = shown(row, "ball", 0.3, force)
    given["ball_loss"] = -dot(force, against)
    return given


@law(
    "propeller",
    free(
        "craft",
        0.8,
        "start at (1, 0, 0) m rotate 30 deg about x; speed (1, 0, 2) m/s; spin (1, 2, 3) rad/s",
        """effect rotor propeller { on craft at (0.1, 0, 0.05) m; command 300 rad/s + wave * 20 rad/s / 1 V
            thrust 1e-5 N*s^2/rad^2; lever 16 mm; lag 4 ms }""",
    ),
    seen("craft", "rotor", "(0.1, 0, 0.05) m") + "\nrotor = rotor.speed\nrotor_lift = rotor.lift",
)
def propeller(rows):
    result = []
    for row, (speed,) in zip(rows, run(lambda x, row: [(300 + 20 * row["wave"] - x[0]) / 4e-3], [0.0], rows)):
        axis = turned(row["craft_o"], [0, 0, 1])
        lift = 1e-5 * speed * speed
        given = shown(row, "craft", 0.8, scaled(lift, axis), scaled(0.016 * lift, axis))
        given.update(rotor=speed, rotor_lift=lift)
        result.append(given)
    return result


@law(
    "cable",
    free(
        "kite",
        0.5,
        "start at (0.3, 0.2, 0) m; speed (-1, 2, -4) m/s; spin (3, 0, 1) rad/s",
        """frame roof { on ground at (0, 0, 1.5) m }
        effect rope cable { this kite at (0, 0.05, 0) m; other roof; length 1.5445 m - wave * 1 mm / 1 V; reel 0.2 m/s
            stiffness 2000 N/m; slow 0.3 s/m }""",
    ),
    seen("kite", "rope", "(0, 0.05, 0) m") + "\nrope = rope.tension\nrope_stretch = rope.stretch",
)
@rows_of
def cable(row, k):
    gap = sum_of([0, 0, 1.5], row["kite_p"], -1)
    long = math.sqrt(dot(gap, gap))
    along = scaled(1 / long, gap)
    stretch = max(long - (1.5445 - row["wave"] * 1e-3), 0)
    tension = 2000 * stretch * max(1 + 0.3 * (-dot(along, row["kite_v"]) - 0.2), 0)
    given = shown(row, "kite", 0.5, scaled(tension, along))
    given.update(rope=tension, rope_stretch=stretch)
    return given


@law(
    "contact",
    free(
        "bouncer",
        0.3,
        "start at (0, 0, 0.0515) m; speed (0.5, -0.2, -1) m/s; spin (3, 10, 1) rad/s",
        """effect floor contact { ball bouncer; radius 5 cm; height 1 mm; load 0.3 kg; impact 1.5 m/s; rest 0.7; friction 0.4
            stiffness 5e3 N/m; grip 20 N*s/m }""",
    )
    + free(
        "roller",
        0.3,
        "start at (0, 0, 0.049) m; speed (0.1, 0, -0.1) m/s; spin (0.1, 1.7, 1) rad/s",
        """effect carpet contact { ball roller; radius 5 cm; load 0.3 kg; impact 1.5 m/s; friction 0.9
            stiffness 5e3 N/m; grip 10 N*s/m }""",
    ),
    seen("bouncer", "floor") + "\n" + seen("roller", "carpet") + "\nfloor = floor.normal",
)
@rows_of
def contact(row, k):
    given = {}
    for name, height, rest, most, grip in (("bouncer", 1e-3, 0.7, 0.4, 20), ("roller", 0, 0.8, 0.9, 10)):
        spin, lever = turned(row[name + "_o"], row[name + "_w"]), [0, 0, -0.05]
        lowest = sum_of(row[name + "_v"], cross(spin, lever))
        slip = math.hypot(*lowest[:2])
        normal = hunt_crossley(5e3, 0.3, height + 0.05 - row[name + "_p"][2], -lowest[2], 1.5, rest)
        rub = min(most * normal, grip * slip)  # against the slip
        push = [-rub * lowest[0] / slip, -rub * lowest[1] / slip, normal]
        given.update(shown(row, name, 0.3, push, cross(lever, push)))
        if name == "bouncer":
            given["floor"] = normal
    return given


@law(
    "bushing",
    free(
        "plate",
        0.4,
        """start at (2.00001, -0.00002, 1.00001) m rotate 2e-5 rad about x; speed (0.01, 0.02, -0.03) m/s
        spin (0.01, -0.02, 0.015) rad/s""",
        """frame hook { on ground at (2, 0, 1.02) m }
        effect mount bushing { this plate at (0, 0, 0.02) m; other hook; stiff_x 200 N/m; stiff_y 300 N/m; stiff_z 400 N/m
            turn_x 5 N*m/rad; turn_y 6 N*m/rad; turn_z 7 N*m/rad; damping 0.2 ms }""",
    ),
    seen("plate", "mount", "(0, 0, 0.02) m"),
)
@rows_of
def bushing(row, k):
    # Linear in small displacements: the rotation vector is twice the vector of the quaternion. What that leaves out is
    # of second order: the angle times the whole.
    angles, spin = scaled(2, row["plate_o"][1:]), turned(row["plate_o"], row["plate_w"])
    gap = sum_of(row["plate_p"], [2, 0, 1.02], -1)
    near, twist = sum_of(gap, row["plate_v"], 2e-4), sum_of(angles, spin, 2e-4)
    force = [-stiff * x for stiff, x in zip((200, 300, 400), near)]
    moment = [-stiff * x for stiff, x in zip((5, 6, 7), twist)]
    given = shown(row, "plate", 0.4, force, moment)
    angle = math.sqrt(dot(angles, angles))
    whole = math.sqrt(dot(force, force)) / 0.4, abs(dot(force, row["plate_v"])) + abs(dot(moment, spin))
    return {name: (value, 2 * angle * size) for (name, value), size in zip(given.items(), whole)}


@law(
    "imu",
    """body bob { mass 1 kg; com (0.1, 0, -0.3) m; inertia (0.03, 0.04, 0.05) kg*m^2 }
    joint swing revolute { parent ground; child bob; axis y; start 0.6 rad; speed 20 rad/s }
    effect unit imu { on bob at (0.2, 0.1, -0.1) m; force_bias 0.1 m/s^2; spin_bias 2 mrad/s
        force_density 3 mm/s^2/sqrt(Hz); noise_2 noise_7; spin_density 1 mrad/s/sqrt(Hz); noise_4 noise_8
        walk_3 drift.value }
    effect drift walk { sigma 0.5 m/s^2/sqrt(s); noise noise_9 }""",
    """swing_q = position of swing\nswing_v = speed of swing\nswing_a = acceleration of swing\nunit_x = unit.force_x
    unit_y = unit.force_y\nunit_z = unit.force_z\nunit_wx = unit.spin_x\nunit_wy = unit.spin_y\nunit_wz = unit.spin_z""",
)
@rows_of
def imu(row, k):
    arm, spin = [0.2, 0.1, -0.1], [0, row["swing_v"], 0]
    felt = sum_of(cross([0, row["swing_a"], 0], arm), cross(spin, cross(spin, arm)))
    # Less gravity, turned back about y.
    felt = sum_of(felt, [-math.sin(row["swing_q"]) * GRAVITY, 0, math.cos(row["swing_q"]) * GRAVITY])
    band = 1 / math.sqrt(2 * STEP)
    # The walk is another memory: a sample has that of the row before.
    drift = 0.5 * math.sqrt(STEP) * sum(noise(i, 9) for i in range(1, k))
    return {
        "unit_x": felt[0] + 0.1,
        "unit_y": felt[1] + 0.1 + 3e-3 * band * noise(k, 7),
        "unit_z": felt[2] + 0.1 + drift,
        "unit_wx": 2e-3 + 1e-3 * band * noise(k, 8),
        "unit_wy": spin[1] + 2e-3,
        "unit_wz": 2e-3,
    }
