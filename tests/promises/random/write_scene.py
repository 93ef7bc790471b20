#!/usr/bin/env python3
"""A random scene: write_scene.py SEED.

A tree of one to five joints, at times with a closed loop; effects with states, memories and the past of formulas; formulas of
all that selects (comparisons, if, min, max, abs, sign, clamp, floor, round, tables) and of the smooth functions, multiplied
and added to one another; tunables, inputs and functions of time; outputs at each tick and slower ones. What acts on a joint is
bounded, and all joints are damped, so that a run of a second stays finite. The same seed gives the same scene.
"""
import random
import sys

seed = int(sys.argv[1])
r = random.Random(seed)
lines = []


def number(low, high):
    return f"{r.uniform(low, high):.4g}"


def vector(size):
    return f"({', '.join(number(-size, size) for _ in range(3))})"


def joint_leaves(name, kind):
    """Plain numbers of a joint of one coordinate."""
    unit = "1 m" if kind == "prismatic" else "1 rad"
    return [f"(position of {name} / {unit})", f"(speed of {name} * 1 s / {unit})"]


def formula(leaves, depth):
    """A plain number that is finite wherever its leaves are."""
    if depth == 0 or r.random() < 0.1:
        return r.choice(leaves) if r.random() < 0.8 else number(0.1, 2)

    def part():
        return formula(leaves, depth - 1)

    def comparison():
        return f"({part()} {r.choice(['<', '<=', '>', '>='])} {part()})"

    kind = r.randrange(20)
    if kind < 3:
        return f"({part()} {r.choice('+-*')} {part()})"
    if kind < 6:
        return f"({comparison()} * {part()} {r.choice('+-')} {part()})"
    if kind < 8:
        return f"if({part()} {r.choice(['<', '>'])} {part()}, {part()}, {part()})"
    if kind == 8:
        return f"min({part()}, {part()})"
    if kind == 9:
        return f"max({part()}, {part()})"
    if kind == 10:
        return f"clamp({part()}, -{number(0.1, 1)}, {number(0.1, 1)})"
    if kind == 11:
        return f"table({part()}, -1: {number(-1, 1)}, 0: {number(-1, 1)}, 1: {number(-1, 1)})"
    if kind == 12:
        corners = "; ".join(f"{y}: {number(-1, 1)}, {number(-1, 1)}" for y in (-1, 1))
        return f"table({part()}, {part()}; -1, 1; {corners})"
    if kind == 13:
        return f"({part()} / (1 + ({part()})^2))"
    if kind == 14:
        return f"atan2({part()}, {part()}) / 1 rad"
    if kind == 15:
        return f"sin(1 rad * tanh({part()}))"
    if kind == 16:
        return f"sqrt(1 + ({part()})^2)"
    if kind == 17:
        return f"{r.choice(['(1 + tanh(%s)^2)^-0.7', '(0.5 + abs(tanh(%s)))^1.5', 'atan(%s)', 'hypot(%s, 0.5)', 'mod(%s, 0.4)'])}" % part() \
            if r.random() < 0.5 else f"{r.choice(['exp(tanh', 'asin(0.9 * tanh', 'log(1.1 + tanh'])}({part()}))"
    return f"{r.choice(['abs', 'sign', 'floor', 'round'])}({part()})"


def bounded(leaves, depth):
    return f"tanh({formula(leaves, depth)})"


# The mechanism.
count = r.randint(1, 5)
joints = []
closed = count > 2 and r.random() < 0.5
lines.append(f"step {r.choice(['100 us', '250 us', '500 us', '1 ms'])}")
lines.append(f"method {r.choice(['rk4', 'rk4', 'rk4', 'heun', 'euler', 'ab4', 'abm4', 'bdf4', 'rosenbrock'])}")
if r.random() < 0.3:
    lines.append("checked yes")
if r.random() < 0.3:
    lines.append("compensated yes")
lines.append(f"gravity {vector(9.8)} m/s^2")
lines.append(f"tunable load = {number(0.5, 2)} kg in 0.1 kg to 3 kg")
lines.append(f"tunable share = {number(0.1, 1)}")
for i in range(count):
    mass = "load" if r.random() < 0.3 else f"{number(0.3, 3)} kg"
    lines.append(f"body b{i} {{ mass {mass}; com {vector(0.2)} m; inertia ({number(.05, .06)}, {number(.05, .06)}, "
                 f"{number(.05, .06)}) kg*m^2 }}")
    parent = "ground" if i == 0 else r.choice(["ground"] + [f"b{k}" for k in range(i)])
    kind = r.choice(["revolute", "revolute", "revolute", "prismatic", "spherical"])
    unit = "m" if kind == "prismatic" else "rad"
    text = f"joint j{i} {kind} {{ parent {parent} at {vector(0.4)} m rotate {number(-90, 90)} deg about x; child b{i}"
    if kind == "spherical":
        text += f"; start rotate {number(-90, 90)} deg about y; {'' if closed else f'spin {vector(1)} rad/s; '}spin_damping 0.3 N*m*s/rad }}"
    else:
        damping = "0.5 N*s/m" if kind == "prismatic" else "0.3 N*m*s/rad"
        speed = "" if closed else f"; speed {number(-1, 1)} {unit}/s"
        text += f"; axis {vector(1)}; start {number(-1, 1)} {unit}{speed}; damping {damping}"
        text += "; continuous }" if kind == "revolute" and not closed and r.random() < 0.3 else " }"
        joints.append((f"j{i}", kind))
    lines.append(text)
if not joints:
    lines.append("body tip { mass 1 kg; com (0, 0.2, 0) m; inertia (0.05, 0.05, 0.05) kg*m^2 }")
    lines.append("joint swing revolute { parent b0; child tip; axis z; start 0.3 rad; damping 0.3 N*m*s/rad }")
    joints.append(("swing", "revolute"))
if closed:
    lines.append(f"close loop distance {{ parent ground at (2, 1.5, 1) m; child b{count - 1} at (0.1, 0.2, 0) m }}")
lines.append("input push V = 3 V * sin(2 Hz) in -5 V to 5 V")
lines.append(f"input hiss = noise({r.randint(1, 99)})")

# Effects.
given = ["(push / 1 V)", "hiss", "share"]
seen = []
for e in range(r.randint(1, 3)):
    joint, kind = r.choice(joints)
    own = ["z", "held", "last", "s", "c", "noise(3)"] + joint_leaves("along", kind)
    effort = "N" if kind == "prismatic" else "N*m"
    lines += [
        f"effect kind{e} {{",
        "    joint along",
        "    signal s",
        "    value c",
        "    fault stuck",
        "    state z = 0.1",
        f"    rate z = ({bounded(own, 4)} - z) / {number(10, 100)} ms",
        "    memory held = 0.2",
        f"    next held = {bounded(own, 4)}",
        f"    let last = {r.choice(['previous(z)', 'delay(z, 5 ms)', 'sample(z, every 2 ms)'])}",
        f"    effort on along = {number(0.1, 2)} {effort} * (1 - stuck) * {bounded(own, 5)}",
        f"    output shown = {formula(own, 4)}",
        "}",
        f"effect e{e} kind{e} {{ along {joint}; s {formula(given, 3)}; c {r.choice(['share', number(0.1, 2)])} }}",
    ]
    seen.append(f"e{e}.shown")
if r.random() < 0.4:
    joint, kind = r.choice(joints)
    unit = "N" if kind == "prismatic" else "N*m"
    lines.append(f"effect rub friction {{ along {joint}; sliding 0.2 {unit}; static 0.3 {unit} }}")

# Outputs.
leaves = seen + given + [leaf for joint, kind in joints for leaf in joint_leaves(joint, kind)]
for i in range(r.randint(1, 4)):
    lines.append(f"output shown{i} = {formula(leaves, 4)}{r.choice(['', '', ' every 3 ticks'])}")
lines.append("output driven = hiss + push / 1 V")
lines.append("output energy = energy")
print(f"# write_scene.py {seed}")
print("\n".join(lines))
