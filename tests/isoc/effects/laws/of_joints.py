"""Laws of the effects on joints, each on its own: the effort is inertia times acceleration, as nothing else acts."""
import math

from law import IMPACT_FREQUENCY, STABLE_RATE, STEP, hunt_crossley, impact_damping, law, rows_of, run
from of_signals import FIRST, fault


def joint(name, inertia, start, words=""):
    """A body of this inertia on an axle, with a start: `start 1 rad; speed 2 rad/s`."""
    return """body %s_body { mass 1 kg; inertia (1, 1, 1) * %g kg*m^2 }
    joint %s revolute { parent ground; child %s_body; axis z; %s; %s }
    """ % (name, inertia, name, name, start, words)


def seen(*names):
    """Outputs of joints: NAME_q, NAME_v and NAME_a."""
    kinds = (("q", "position"), ("v", "speed"), ("a", "acceleration"))
    return "\n".join("%s_%s = %s of %s" % (name, short, long, name) for name in names for short, long in kinds)


@law(
    "stop",
    joint("low", 0.1, "start -0.97 rad; speed -20 rad/s")
    + joint("high", 0.1, "start 0.49 rad; speed 9 rad/s")
    + """effect low_end stop { along low; lower -1 rad; upper 0.5 rad; impact 15 rad/s; rest 0.6; stiffness 2e4 N*m/rad }
    effect high_end stop { along high; lower -1 rad; upper 0.5 rad; impact 10 rad/s }""",
    seen("low", "high") + "\nlow_stop = low_end.effort",
)
@rows_of
def stop(row, k):
    below = hunt_crossley(2e4, 0.1, -1 - row["low_q"], -row["low_v"], 15, 0.6)
    steep = 0.1 * IMPACT_FREQUENCY**2 / (1 + impact_damping(0.8))
    above = hunt_crossley(steep, 0.1, row["high_q"] - 0.5, row["high_v"], 10, 0.8)
    return {"low_stop": below, "low_a": below / 0.1, "high_a": -above / 0.1}


@law(
    "bumper",
    joint("below", 0.2, "start -0.195 rad; speed -4 rad/s")
    + """effect pad bumper { along below; place -0.2 rad; side -1; impact 3 rad/s; rest 0.5; stiffness 3e4 N*m/rad }""",
    seen("below") + "\npad = pad.effort",
)
@rows_of
def bumper(row, k):
    push = hunt_crossley(3e4, 0.2, -0.2 - row["below_q"], -row["below_v"], 3, 0.5)
    return {"pad": push, "below_a": push / 0.2}


@law(
    "backlash",
    joint("pinion", 0.1, "start 0.29 rad; speed 8 rad/s")
    + joint("wheel", 0.3, "start 0.1 rad; speed 1 rad/s")
    + """effect play backlash { motor pinion; load wheel; gap 0.01 rad; ratio 2.8; impact 5 rad/s; rest 0.7
        stiffness 5e3 N*m/rad }""",
    seen("pinion", "wheel") + "\nplay = play.effort",
)
@rows_of
def backlash(row, k):
    apart, slip = (row["pinion_" + c] - 2.8 * row["wheel_" + c] for c in "qv")
    both = 1 / (1 / 0.1 + 2.8**2 / 0.3)
    above = hunt_crossley(5e3, both, apart - 0.005, slip, 5, 0.7)
    effort = above - hunt_crossley(5e3, both, -0.005 - apart, -slip, 5, 0.7)
    return {"play": effort, "pinion_a": -effort / 0.1, "wheel_a": 2.8 * effort / 0.3}


@law(
    "friction",
    joint("fast", 0.1, "speed 2.5 rad/s")
    + joint("slow_one", 0.1, "speed -0.0004 rad/s")
    + """effect rub friction { along fast; sliding 3 N*m; static 5 N*m; fall 2 rad/s; creep 0.1 rad/s }
    effect holding friction { along slow_one; sliding 0.03 N*m; static 0.05 N*m }""",
    seen("fast", "slow_one") + "\nrub = rub.effort\nrub_loss = rub.loss",
)
@rows_of
def friction(row, k):
    # Beyond the creep: from static to sliding, with half of it left where v^2 = creep^2 + fall^2.
    v, slow = row["fast_v"], row["slow_one_v"] / (2 * 0.05 / (0.1 * STABLE_RATE))
    rub = -math.copysign(3 + 2 / (1 + (v * v - 0.01) / 4), v)
    # Within it the odd cubic that is 1 at 1, and level there.
    hold = -0.05 * slow * (3 - slow * slow) / 2
    return {"rub": rub, "fast_a": rub / 0.1, "rub_loss": -rub * v, "slow_one_a": hold / 0.1}


@law(
    "jammed",
    joint("rod", 0.1, "start 0.2 rad; speed 3 rad/s")
    + "effect jam jammed { along rod }\n"
    + fault("jam"),
    seen("rod") + "\njam = jam.effort",
)
def jammed(rows):
    held = rows[FIRST - 1]["rod_q"]  # the last row before the fault
    rate = STABLE_RATE / 4  # J w^2 x + 2 J w v: with critical damping
    shown = []
    for k, row in enumerate(rows):
        effort = -0.1 * rate * (rate * (row["rod_q"] - held) + 2 * row["rod_v"]) if k >= FIRST else 0
        shown.append({"jam": effort, "rod_a": effort / 0.1})
    return shown


@law(
    "cogging",
    joint("shaft", 0.01, "start 0.1 rad; speed 20 rad/s")
    + "effect teeth cogging { shaft shaft; peak 0.3 N*m; periods 12; rest 0.02 rad }",
    seen("shaft") + "\nteeth = teeth.torque",
)
@rows_of
def cogging(row, k):
    torque = -0.3 * math.sin(12 * (row["shaft_q"] - 0.02))
    return {"teeth": torque, "shaft_a": torque / 0.01}


@law(
    "dc_motor",
    joint("armature", 0.001, "speed 30 rad/s")
    + """effect drive dc_motor { shaft armature; supply wave * 6; resistance 2 Ohm; inductance 5 mH; constant 0.1 N*m/A
        warmth 1.2 }
    at %g ms set drive.open = 1"""
    % (5 * STEP * 1e3),
    seen("armature")
    + "\ndrive_current = drive.current\ndrive_back = drive.back\ndrive_torque = drive.torque\ndrive_heat = drive.heat",
)
def dc_motor(rows):
    def rate(x, row):
        speed, current = x
        closed = (6 * row["wave"] - 2 * 1.2 * current - 0.1 * speed) / 5e-3
        return [0.1 * current / 0.001, -current / 1e-3 if row["row"] >= 5 else closed]

    return [
        {
            "armature_v": speed,
            "armature_a": 100 * current,
            "drive_current": current,
            "drive_back": 0.1 * speed,
            "drive_torque": 0.1 * current,
            "drive_heat": 2.4 * current * current,
        }
        for speed, current in run(rate, [30.0, 0.0], rows)
    ]


@law(
    "flexible_gear",
    joint("arm", 0.05, "speed 1 rad/s")
    + """effect gear flexible_gear { load arm; torque 0.1 N*m + wave / 50 V * 1 N*m; ratio 10; rotor 1e-4 kg*m^2
        stiffness 500 N*m/rad; damping 2 N*m*s/rad }""",
    seen("arm") + "\ngear_speed = gear.speed\ngear_twist = gear.twist\ngear = gear.effort",
)
def flexible_gear(rows):
    effort = lambda x: 500 * x[2] + 2 * (x[1] / 10 - x[0])
    rate = lambda x, row: [effort(x) / 0.05, (0.1 + row["wave"] / 50 - effort(x) / 10) / 1e-4, x[1] / 10 - x[0]]
    return [
        {"arm_v": x[0], "gear_speed": x[1], "gear_twist": x[2], "gear": effort(x), "arm_a": effort(x) / 0.05}
        for x in run(rate, [1.0, 0.0, 0.0], rows)
    ]


@law(
    "encoder",
    joint("round", 0.1, "start 3.05 rad; speed 32 rad/s", "continuous")
    + joint("zero", 0.1, "start -0.1 rad; speed 32 rad/s")
    + """effect disc encoder { shaft round; lines 50 }
    effect mark encoder { shaft zero; lines 40 }""",
    seen("round", "zero")
    + "\nround_turns = turns of round\ndisc = disc.count\ndisc_angle = disc.angle\nmark = mark.count\nmark_index = mark.index",
)
@rows_of
def encoder(row, k):
    # The angle without the wrap, in counts.
    count = math.floor((row["round_q"] / (2 * math.pi) + row["round_turns"]) * 200)
    mark = math.floor(row["zero_q"] / (2 * math.pi) * 160)
    return {"disc": count, "disc_angle": 2 * math.pi * count / 200, "mark": mark, "mark_index": int(mark % 160 == 0)}
