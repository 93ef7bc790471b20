"""A scene of dry frictions of random values, and its table for hold.c.
usage: hold.py SEED HALF SCENE TABLE; HALF is 0 or 1, of 24 of them
"""
import random
import sys

random.seed(int(sys.argv[1]))
scene, table, outputs = ["step 1 ms"], [], []
for i in range(24):
    static = 10 ** random.uniform(-3, 4)
    sliding = static * random.choice([0, 0.5, 0.99, 1, random.random()])
    creep, fall = 10 ** random.uniform(-5, 0), 10 ** random.uniform(-6, 1)
    fall = creep if i % 4 == 0 else fall
    if i // 12 != int(sys.argv[2]):
        continue
    scene += ["body b%d { mass 1 kg }" % i, "joint j%d prismatic { parent ground; child b%d; axis x }" % (i, i),
              "effect e%d friction { along j%d; static %.9g N; sliding %.9g N; creep %.9g m/s; fall %.9g m/s }"
              % (i, i, static, sliding, creep, fall), "output effort%d = e%d.effort" % (i, i)]
    table.append("    {%.9g, %.9g, PLANT_X_J%d_SPEED, PLANT_Y_EFFORT%d},\n" % (static, creep, i, i))
open(sys.argv[3], "w").write("\n".join(scene) + "\n")
open(sys.argv[4], "w").write("static const rubbing all[] = {\n%s};\n" % "".join(table))
