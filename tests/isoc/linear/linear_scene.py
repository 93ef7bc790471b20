#!/usr/bin/env python3
"""Random scenes for test_linear.py: linear_scene.py FOLDER SEED...

Of each seed FOLDER/SEED.scene: three to five joints, ball joints and free bodies among them, every fourth one a four-bar
linkage; own effects with states, and effects of the library; springs, dampers, inputs and outputs. All start away from rest.
FOLDER/SEED.geometry says what a closed loop is: `bar` and four lengths, or `open`. The same seed gives the same scene.
"""
import math
import random
import sys


def number(r, low, high):
    return "%.4g" % r.uniform(low, high)


def vector(r, size):
    return "(%s)" % ", ".join(number(r, -size, size) for _ in range(3))


def body(r, name):
    return "body %s { mass %s kg; com %s m; inertia (%s, %s, %s) kg*m^2 }" % (
        name, number(r, 0.3, 3), vector(r, 0.2), number(r, 0.05, 0.06), number(r, 0.05, 0.06), number(r, 0.05, 0.06))


def tree(r):
    """Statements, and the joints of one coordinate with their kinds."""
    lines, joints = [], []
    for i in range(r.randint(3, 4)):
        parent = "ground" if i == 0 else r.choice(["ground"] + ["b%d" % k for k in range(i)])
        kind = r.choice(["revolute", "prismatic", "spherical", "free"]) if i > 0 else "revolute"
        lines.append(body(r, "b%d" % i))
        text = "joint j%d %s { parent %s at %s m rotate %s deg about x; child b%d" % (
            i, kind, parent, vector(r, 0.4), number(r, -90, 90), i)
        if kind in ("spherical", "free"):
            place = "at %s m " % vector(r, 1) if kind == "free" else ""
            text += "; start %srotate %s deg about y rotate %s deg about x; spin %s rad/s; spin_damping 0.3 N*m*s/rad }" % (
                place, number(r, -90, 90), number(r, -90, 90), vector(r, 2))
        else:
            unit, force = ("m", "N") if kind == "prismatic" else ("rad", "N*m")
            text += "; axis %s; start %s %s; speed %s %s/s; damping %s %s*s/%s; spring %s %s/%s }" % (
                vector(r, 1), number(r, -1, 1), unit, number(r, -2, 2), unit, number(r, 0.1, 1), force, unit,
                number(r, 1, 9), force, unit)
            joints.append(("j%d" % i, kind))
        lines.append(text)
    lines.append("spring band { between ground at (1, 2, 1) m and b1 at %s m; stiffness 30 N/m; damping 2 N*s/m; length 0.5 m }"
                 % vector(r, 0.1))
    return lines, joints


def four_bar(r):
    """The same of a linkage in the plane, and its lengths: crank, coupler, rocker, ground."""
    crank, rocker, ground = r.uniform(0.1, 0.2), r.uniform(0.3, 0.4), r.uniform(0.4, 0.5)
    first, third = r.uniform(0.5, 2.5), r.uniform(1.2, 1.9)
    across = (ground + rocker * math.cos(third) - crank * math.cos(first), rocker * math.sin(third) - crank * math.sin(first))
    coupler, second = math.hypot(*across), math.atan2(across[1], across[0])
    # Speeds that keep the loop closed.
    speed = r.uniform(-3, 3)
    a = [[-coupler * math.sin(second), rocker * math.sin(third)], [coupler * math.cos(second), -rocker * math.cos(third)]]
    b = [crank * math.sin(first) * speed, -crank * math.cos(first) * speed]
    det = a[0][0] * a[1][1] - a[0][1] * a[1][0]
    speeds = [speed, (b[0] * a[1][1] - b[1] * a[0][1]) / det - speed, (a[0][0] * b[1] - a[1][0] * b[0]) / det]
    lines = [body(r, "b%d" % i) for i in range(3)]
    for i, (parent, start) in enumerate([("ground", first), ("b0 at (%.17g, 0, 0) m" % crank, second - first),
                                         ("ground at (%.17g, 0, 0) m" % ground, third)]):
        lines.append("joint j%d revolute { parent %s; child b%d; axis z; start %.17g rad; speed %.17g rad/s; damping %s N*m*s/rad }"
                     % (i, parent, i, start, speeds[i], number(r, 0.1, 1)))
    lines.append("close pin line { parent b2 at (%.17g, 0, 0) m; child b1 at (%.17g, 0, 0) m; axis z }" % (rocker, coupler))
    return lines, [("j0", "revolute"), ("j2", "revolute")], (crank, coupler, rocker, ground)


def own_effect(r, i, joint, kind):
    unit, force = ("1 m", "N") if kind == "prismatic" else ("1 rad", "N*m")
    return [
        "effect kind%d {" % i,
        "    joint along",
        "    signal s",
        "    state z = %s" % number(r, -1, 1),
        "    state w = %s" % number(r, -1, 1),
        "    let p = position of along / %s" % unit,
        "    let v = speed of along * 1 s / %s" % unit,
        "    rate z = (tanh(%s * v + s) - z) / %s ms" % (number(r, 0.2, 2), number(r, 20, 200)),
        "    rate w = (z * p / (1 + v^2) - w) / %s s" % number(r, 0.1, 1),
        "    effort on along = %s %s * (z - sin(1 rad * p) * exp(-w^2) + %s * sqrt(1 + v^2))"
        % (number(r, 0.5, 5), force, number(r, -1, 1)),
        "    output shown = z * w + p * v",
        "}",
        "effect e%d kind%d { along %s; s push / %s N + hiss / 1 A }" % (i, i, joint, number(r, 1, 9)),
    ]


def library_effect(r, joint, kind):
    unit = "N" if kind == "prismatic" else "N*m"
    rate = "m/s" if kind == "prismatic" else "rad/s"
    if kind == "revolute" and r.random() < 0.6:
        return ["input volts V", "effect motor dc_motor { shaft %s; supply volts; resistance 2 Ohm; inductance %s mH; constant %s N*m/A }"
                % (joint, number(r, 1, 9), number(r, 0.05, 0.5))]
    return ["effect rub friction { along %s; sliding %s %s; static %s %s; creep %s %s }"
            % (joint, number(r, 0.2, 0.5), unit, number(r, 0.6, 0.9), unit, number(r, 0.1, 0.5), rate)]


def scene(seed):
    r = random.Random(seed)
    lines = ["# linear_scene.py %d" % seed, "step 0.1 ms", "method rk4", "gravity %s m/s^2" % vector(r, 9.8),
             "tunable load = %s N" % number(r, 1, 3), "input push N", "input hiss A"]
    geometry = ()
    if seed % 4 == 0:
        parts, joints, geometry = four_bar(r)
    else:
        parts, joints = tree(r)
    lines += parts
    for i in range(r.randint(1, 2)):
        lines += own_effect(r, i, *r.choice(joints))
    lines += library_effect(r, *r.choice(joints))
    lines.append("force shove { body b1 at %s m; axis z; drive push }" % vector(r, 0.3))
    lines += ["output shown = e0.shown * load", "output place = position of b1 at %s m" % vector(r, 0.3),
              "output q = position of j0", "output a = acceleration of j0", "output turn = spin of b1", "output energy = energy"]
    return "\n".join(lines) + "\n", "bar " + " ".join("%.17g" % x for x in geometry) if geometry else "open"


def main(folder, *seeds):
    for seed in seeds:
        text, geometry = scene(int(seed))
        open("%s/%s.scene" % (folder, seed), "w").write(text)
        open("%s/%s.geometry" % (folder, seed), "w").write(geometry + "\n")


if __name__ == "__main__":
    main(*sys.argv[1:])
