"""Effects that switch so and so often, of random frequencies, and what isoc has to say of them.

A jump within a step is misplaced by up to half of it. With n steps between two jumps of J, of a quantity whose mean size is A,
that is a share of J / (2 A n). Of a voltage or an effort that is reversed it is 1 / n; of pulses over a part d of the time, with
two jumps in a period of 2 n steps, 1 / (2 d n). A current's rate is larger than the half jump, behind a jump up to twice.
usage: switching.py SEED STEP_US METHOD SCENE    writes the scene
       switching.py SEED STEP_US METHOD SCENE TOLD    compares what was told
"""
import math
import random
import re
import sys

seed, step_us, method, scene = sys.argv[1:5]
random.seed(seed + step_us + method)
step, speed = 1e-6 * float(step_us), 100.0

DEFINITIONS = """
effect winding { joint shaft; value pairs; state i A = 0 A
    rate i = (12 V * (2 * (sin(pairs * position of shaft) > 0) - 1) - 2 Ohm * i) / 2 mH }
effect cogging { joint shaft; value pairs; let n = pairs * position of shaft / pi
    effort on shaft = 1 mN*m * (1 - 2 * (floor(n) - 2 * floor(n / 2))) }
effect relay { joint shaft; value pairs; effort on shaft = 1 mN*m * sign(sin(pairs * position of shaft)) }
effect pulses { joint shaft; value level; signal wave; effort on shaft = 1 mN*m * (wave > level) }
effect chopped { state i A = 0 A; signal volts V; rate i = (volts - 2 Ohm * i) / 2 mH }
effect wall { joint shaft; value pairs
    let depth = sin(pairs * position of shaft)
    effort on shaft = if(depth > 0, 1 mN*m * depth, 0 N*m) }
"""


def draw(kind, i):
    """A use of the kind, its steps between two jumps, the share; 0: it is silent whatever its frequency."""
    n = 10 ** random.uniform(1, 2.7)
    pairs, hertz = math.pi / (n * step * speed), 1 / (2 * n * step)
    if kind == "pulses":
        level = random.uniform(-0.8, 0.8)
        part = 0.5 - math.asin(level) / math.pi
        line = "input w%d = sin(%.9g Hz)\neffect e%d pulses { shaft shaft; level %.6f; wave w%d }" % (i, hertz, i, level, i)
        return line, n, 1 / (2 * part * n)
    if kind == "chopped":
        return "input w%d V = 12 V * square(%.9g Hz)\neffect e%d chopped { volts w%d }" % (i, hertz, i, i), n, 1 / n
    if kind == "on ticks":
        period = 2 * random.randint(5, 100) * step
        return "input w%d V = 12 V * square(1 / %.9g s)\neffect e%d chopped { volts w%d }" % (i, period, i, i), n, 0
    return "effect e%d %s { shaft shaft; pairs %.9g }" % (i, kind, pairs), n, 0 if kind == "wall" else 1 / n


uses = []
while len(uses) < 24:
    kind = ["winding", "cogging", "relay", "pulses", "chopped", "on ticks", "wall"][len(uses) % 7]
    line, n, share = draw(kind, len(uses))
    if not 0.008 < share < 0.02 and n < 400:
        uses.append((kind, line, n, share))

if len(sys.argv) == 5:
    with open(scene, "w") as out:
        out.write("step %s us\nmethod %s\n%sbody b { mass 1 kg; inertia (1e15, 1e15, 1e15) kg*m^2 }\n" % (step_us, method, DEFINITIONS))
        out.write("joint shaft revolute { parent ground; child b; axis z; continuous; speed %g rad/s }\n" % speed)
        out.write("\n".join(use[1] for use in uses) + "\noutput speed = speed of shaft\n")
    sys.exit(0)

lines = open(scene).read().split("\n")
told = {}
for found in re.finditer(r"scene:(\d+):8: warning: the effect 'e(\d+)' jumps every (\S+) steps .* here (\S+) %.*a step of (\S+) ms",
                         open(sys.argv[5]).read()):
    told[int(found[2])] = [float(found[k]) for k in (1, 3, 4, 5)]
    if not lines[int(found[1]) - 1].startswith("effect e%s " % found[2]):
        sys.exit("e%s is told of at line %s" % (found[2], found[1]))
for i, (kind, line, n, share) in enumerate(uses):
    if (i in told) != (share > 0.01):
        sys.exit("%s, %.4g steps, %.3g %%: %s" % (line, n, 100 * share, told.get(i)))
    if i in told:
        # A window of 2000 steps has one jump more or less; a part is told to two digits.
        _, steps, part, longest = told[i]
        jump = n / 2000
        least = 0.45 if kind in ("winding", "chopped") else 0.94 - jump
        if not (abs(steps / n - 1) < jump + 0.01 and least * share < part / 100 < (1.06 + 2 * jump) * share and
                abs(longest * part / step / 1000 - 1) < 0.08):
            sys.exit("%s, %.4g steps, %.3g %%: told %s" % (line, n, 100 * share, told[i]))
if not 4 < len(told) < 20:
    sys.exit("%d are told of" % len(told))
