#!/usr/bin/env python3
"""A random scene that moves smoothly: write_scene.py SEED.

One to three links in series or side by side, on joints with springs and dampers; a force that is a function of time;
outputs of a place, an angle or a stroke, and the energy. The same seed gives the same scene.
"""
import random
import sys

r = random.Random(int(sys.argv[1]))


def number(low, high):
    return f"{r.uniform(low, high):.4g}"


print(f"# write_scene.py {sys.argv[1]}")
print(f"gravity (0, -9.81, 0) m/s^2\nstep {r.choice(['500 us', '1 ms', '2 ms'])}\nmethod rk4")
print(f"input push = {number(0.5, 3)} N*m * sin({number(0.3, 2)} Hz)")
links = r.randint(1, 3)
for i in range(links):
    parent = "ground" if i == 0 else r.choice(["ground", f"b{i - 1} at (0, -{number(0.3, 0.6)}, 0) m"])
    kind = "revolute" if i == 0 or r.random() < 0.7 else "prismatic"
    print(f"body b{i} {{ mass {number(0.3, 2)} kg; com (0, -{number(0.1, 0.4)}, 0) m; "
          f"inertia ({number(.01, .03)}, {number(.01, .03)}, {number(.01, .03)}) kg*m^2 }}")
    if kind == "revolute":
        rest = f"axis z; start {number(-1.2, 1.2)} rad; damping {number(0.05, 0.3)} N*m*s/rad; " \
               f"spring {number(1, 20)} N*m/rad"
    else:
        rest = f"axis x; start {number(-0.1, 0.1)} m; damping {number(1, 5)} N*s/m; spring {number(100, 1000)} N/m"
    print(f"joint j{i} {kind} {{ parent {parent}; child b{i}; {rest}{'; drive push' if i == 0 else ''} }}")
print(f"output tip = position of b{links - 1} at (0, -0.4, 0) m")
print("output angle = position of j0")
print("output energy = energy")
