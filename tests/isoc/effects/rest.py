"""A scene of impacts, and its table for rest.c: each effect with each rest, of random mass, speed and stiffness.

The speed of an impact is the one for which the rest is meant. The stiffness is that with which 1 + d times as much, as at the
begin of an impact, oscillates by ANGLE in a step.
usage: rest.py SEED SCENE TABLE
"""
import math
import random
import sys

STEP, ANGLE = 1e-5, 1e-2
RESTS = [1, 0.999, 0.8, 0.6, 0.4, 0.2, 0.05]


def damping(rest):
    """d (1 + rest) = ln((1 + d) / (1 - rest d)), by bisection: the left side is the larger one below d."""
    low, high = 0.0, 1.0 / rest
    for _ in range(200 if rest < 1 else 0):
        d = 0.5 * (low + high)
        if 1 - rest * d > 0 and d * (1 + rest) > math.log1p(d) - math.log1p(-rest * d):
            low = d
        else:
            high = d
    return low


def main():
    random.seed(int(sys.argv[1]))
    scene = ["step %g us" % (STEP * 1e6)]
    table = []
    for effect in ("stop", "bumper", "backlash", "contact"):
        for rest in RESTS + [None]:  # None: it leaves faster than the effect follows
            i = len(table)
            fast, part = rest is None, rest or 0.5
            mass, speed = 10 ** random.uniform(-2, 2), 10 ** random.uniform(-1, 1)
            ratio = random.choice([-1, 1]) * 10 ** random.uniform(-0.5, 0.5) if effect == "backlash" else 0
            other = 10 ** random.uniform(-2, 2)
            both = mass / (1 + ratio ** 2 * mass / other)
            stiffness = both * (ANGLE / STEP) ** 2 / (1 + damping(part))
            side = random.choice([-1, 1]) if effect in ("stop", "bumper") else 1
            if effect == "contact":
                side = -1
            # At a speed of 1 it takes a few steps to the impact.
            start = -side * speed * STEP * random.uniform(1, 3)
            now = side * speed
            gap = (1600000 if fast else 16000) * speed * STEP  # to its other side it does not come
            if effect == "backlash":
                start += gap / 2
            if fast:
                start, now = start + side * speed * STEP * 1000, -side * speed * 100
            axis = "z" if effect == "contact" else "x"
            scene.append("body b%d { mass %.17g kg }" % (i, mass))
            scene.append("joint j%d prismatic { parent ground; child b%d; axis %s; start %.17g m; speed %.17g m/s }"
                         % (i, i, axis, start, now))
            common = "impact %.17g m/s; rest %.17g; stiffness %.17g N/m }" % (speed, part, stiffness)
            shown = "speed of j%d" % i
            if effect == "stop":
                ends = "lower -1 km; upper 0 m" if side > 0 else "lower 0 m; upper 1 km"
                scene.append("effect e%d stop { along j%d; %s; %s" % (i, i, ends, common))
            elif effect == "bumper":
                scene.append("effect e%d bumper { along j%d; place 0 m; side %d; %s" % (i, i, side, common))
            elif effect == "contact":
                scene.append("effect e%d contact { ball b%d; %s" % (i, i, common))
            else:
                scene.append("body o%d { mass %.17g kg }" % (i, other))
                scene.append("joint k%d prismatic { parent ground; child o%d; axis x }" % (i, i))
                scene.append("effect e%d backlash { motor j%d; load k%d; gap %.17g m; ratio %.17g; %s"
                             % (i, i, i, gap, ratio, common))
                shown = "speed of j%d - %.17g * speed of k%d" % (i, ratio, i)
            scene.append("output speed%d = %s" % (i, shown))
            scene.append("output push%d = e%d.%s" % (i, i, "normal" if effect == "contact" else "effort"))
            scene.append("output loss%d = loss of e%d" % (i, i))
            # A stop and a bumper push against the side; the efforts of backlash and contact are told as pushes.
            sign = -side if effect in ("stop", "bumper") else 1
            table.append('    {"%s", %.17g, %.17g, %d, %.17g},\n' % (effect, 0 if fast else rest, now, sign, damping(part)))
    scene.append("output balance = balance")
    open(sys.argv[2], "w").write("\n".join(scene) + "\n")
    with open(sys.argv[3], "w") as out:
        out.write("#define ANGLE %g\nstatic const impact impacts[] = {\n%s};\n" % (ANGLE, "".join(table)))
        places = ["    {PLANT_Y_SPEED%d, PLANT_Y_PUSH%d, PLANT_Y_LOSS%d},\n" % (i, i, i) for i in range(len(table))]
        out.write("static const places outputs[] = {\n%s};\n" % "".join(places))


if __name__ == "__main__":
    main()
