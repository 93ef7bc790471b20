"""usage: effects.py write SEED SCENE | compare SEED REAL ROWS [PLANTED]

The first writes a random scene. The second compares rows of its outputs with the interpreter's, and prints what is off; the exit
status is 1 if anything is, or if less than three fourths of the numbers are decided by their bounds.
"""
import sys

import generator
from interpreter import INFINITE, Number, Plant


def main(verb, seed, third, *more):
    text, scene = generator.scene_of(int(seed))
    if verb == "write":
        open(third, "w").write(text)
        return 0
    Number.epsilon = 2.0**-24 if third == "float" else 2.0**-53
    rows = [list(map(float, line.split())) for line in open(more[0])]
    wanted = Plant(scene, more[1] if len(more) > 1 else None).run(len(rows) - 1)
    off, decided, first = 0, 0, {}
    for k, (got, want) in enumerate(zip(rows, wanted)):
        for name, g, w in zip(scene["outputs"], got, want):
            decided += w.bound < 0.1
            if not abs(g - w.value) <= w.bound:
                off += 1
                first.setdefault(name, "# %s in row %d is %.9g, wanted %.9g +- %.2g" % (name, k, g, w.value, w.bound))
    total = len(rows) * len(scene["outputs"])
    for line in list(first.values())[:8]:
        print(line)
    print("# seed %s, %s: %d of %d numbers decided, %d off" % (seed, third, decided, total, off))
    return int(off > 0 or decided * 4 < total * 3)


sys.exit(main(*sys.argv[1:]))
