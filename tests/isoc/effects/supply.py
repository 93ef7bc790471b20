"""Choppers in discontinuous conduction, and batteries, of random values, and their table for supply.c.

The mean current of a chopper is that of its switchings: within a period it rises as an exponential of L / R, falls as one to
zero, and stays there. Its integral follows from the voltages, whose mean at the inductance is zero.
usage: supply.py SEED STEP_US SCENE TABLE
"""
import math
import random
import sys

random.seed(int(sys.argv[1]))
step = float(sys.argv[2]) * 1e-6
scene = ["step %s us" % sys.argv[2], "body b { mass 1 kg; inertia (1e15, 1e15, 1e15) kg*m^2 }",
         "joint j revolute { parent ground; child b; axis z; continuous; speed 100 rad/s }"]
choppers, batteries = [], []


def mean_of(on, supply, back, drop, resistance, inductance, period):
    """The mean current, and the part of the period in which there is any."""
    lag = inductance / resistance
    top = (supply - back) / resistance * -math.expm1(-on * period / lag)
    falls = lag * math.log1p(top * resistance / (back + drop))
    mean = ((supply - back) * on * period - (back + drop) * falls) / (resistance * period)
    return mean, on + falls / period


while len(choppers) < 12:
    resistance, inductance = 10 ** random.uniform(-1, 1.5), 10 ** random.uniform(-3.5, -1)
    period = inductance / resistance * 10 ** random.uniform(-3, -2)
    supply, drop, on = random.uniform(5, 50), random.choice([0, 0.7]), random.uniform(0.02, 0.9)
    back = supply * random.uniform(0.1, 0.98)
    mean, part = mean_of(on, supply, back, drop, resistance, inductance, period)
    if part > 0.9 or not 0.004 < inductance / resistance < 0.02:
        continue
    i = len(choppers)
    scene += ["effect c%d chopper { duty %.9g; supply %.9g V; current m%d.current; back m%d.back; drop %.9g V; "
              "resistance %.9g Ohm; inductance %.9g H; period %.9g s }" % (i, on, supply, i, i, drop, resistance, inductance, period),
              "effect m%d dc_motor { shaft j; supply c%d.voltage; resistance %.9g Ohm; inductance %.9g H; constant %.9g N*m/A }"
              % (i, i, resistance, inductance, back / 100), "output current%d = m%d.current" % (i, i)]
    choppers.append("    {PLANT_Y_CURRENT%d, %.17g, %.17g, %.9g},\n"
                    % (i, mean, resistance * period / inductance, supply * step / inductance))
for start, current in [(1, 0), (0.5, 1), (0.02, 0.01), (0.005, 0), (0.3, 20), (0.01, 5), (0.9, -20), (1, -3)]:
    i, cells, resistance = len(batteries), random.randint(1, 8), random.uniform(0, 0.2)
    scene += ["effect b%d battery { current %g A; capacity 10 A*s; resistance %.9g Ohm; cells %d; start %g }"
              % (i, current, resistance, cells, start), "output charge%d = b%d.charge" % (i, i),
              "output voltage%d = b%d.voltage" % (i, i), "output heat%d = b%d.heat" % (i, i)]
    batteries.append("    {PLANT_Y_CHARGE%d, PLANT_Y_VOLTAGE%d, PLANT_Y_HEAT%d, %g, %g, %d, %.9g},\n"
                     % (i, i, i, start, current, cells, resistance))
open(sys.argv[3], "w").write("\n".join(scene) + "\n")
open(sys.argv[4], "w").write("#define STEP %.9g\nstatic const chopper choppers[] = {\n%s};\nstatic const battery batteries[] = {\n%s};\n"
                             % (step, "".join(choppers), "".join(batteries)))
