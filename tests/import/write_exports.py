#!/usr/bin/env python3
"""Scenes as MJCF and back: write_exports.py FOLDER SCENE...

Writes for each scene what isoc --mjcf makes of it, the scene that the import makes of that, both plants, and robots.h, as
write_robots.py does. Right are the accelerations of the plant of the scene itself.
"""
import math
import os
import random
import re
import subprocess
import sys
import types
import xml.etree.ElementTree as xml

from write_robots import ROOT, STATES, load_import, numbers, rename

ISOC = os.path.join(ROOT, "build", "isoc")
KINDS = {"hinge": "HINGE", "slide": "SLIDE", "ball": "BALL"}


def plant(folder, scene, name):
    made = subprocess.run(
        [ISOC, scene, "-o", os.path.join(folder, name), "--name", name, "--real", "double"], capture_output=True, text=True
    )
    if made.returncode:
        print(made.stderr)
        return False
    rename(folder, name)
    return True


def inputs_of(folder, name):
    """The inputs of a plant, in their order."""
    with open(os.path.join(folder, name, f"{name}.h"), encoding="utf-8") as file:
        found = re.search(rf"{name}_inputs\[\w+\] = {{(.*?)\n}};", file.read(), re.S)
    return re.findall(r'^    {"(\w+)"', found.group(1), re.M) if found else []


def floats(text):
    return [float(word) for word in text.split()]


def table(folder, name, path, seed):
    r = random.Random(seed)
    root = xml.parse(path).getroot()
    joints = [(joint.get("name"), joint.get("type")) for joint in root.iter("joint") if joint.get("type")]
    inputs = inputs_of(folder, name)
    drives = []
    for motor in root.find("actuator"):
        label = motor.get("name")
        own = next(k for k, input_name in enumerate(inputs) if re.fullmatch(rf"{input_name}_(on_\w+|force\d+)", label))
        drives.append((label, own))
    lines = [
        f"static const robot_joint {name}_joints[] = {{"
        + ", ".join(f'{{"{label}", {KINDS[kind]}, 0.0}}' for label, kind in joints)
        + "};",
        f"static const robot_drive {name}_drives[] = {{"
        + ", ".join([*(f'{{"{label}", 1, "", {own}}}' for label, own in drives), "{0}"])
        + "};",
    ]
    lines.append(f"static const robot_body {name}_bodies[] = {{{{0}}}};")
    gears = [(gear.get("joint1"), gear.get("joint2"), floats(gear.get("polycoef"))) for gear in root.find("equality")]
    for k in range(STATES):
        position, speed = state(r, joints, gears)
        values = [r.uniform(-3, 3) for _ in inputs]
        for what, row in (("q", position), ("v", speed), ("u", [values[own] for _, own in drives] or [0.0])):
            lines.append(f"static const double {name}_{what}{k}[] = {numbers(row)};")
    states = ", ".join(f"{{{name}_q{k}, {name}_v{k}, {name}_u{k}, NULL}}" for k in range(STATES))
    lines.append(
        f'#define ROBOT_{name.upper()} {{"{path}", &{name}_model, {name}_joints, {len(joints)}, {name}_bodies, '
        f"{name}_drives, {len(drives)}, 1, {len(gears)}, {{{states}}}, &{name}_again_model}}"
    )
    return lines


def state(r, joints, gears):
    """Random, with what gears hold."""
    position, speed = {}, {}
    for label, kind in joints:
        q = [r.gauss(0, 1) for _ in range(4)] if kind == "ball" else [r.uniform(-1, 1)]
        size = math.sqrt(sum(x * x for x in q)) if kind == "ball" else 1.0
        position[label], speed[label] = [x / size for x in q], [r.uniform(-2, 2) for _ in range(3 if kind == "ball" else 1)]
    for first, second, powers in gears:
        position[first] = [powers[0] + powers[1] * position[second][0]]
        speed[first] = [powers[1] * speed[second][0]]
    return [x for label, _ in joints for x in position[label]], [x for label, _ in joints for x in speed[label]]


def main():
    folder, scenes = sys.argv[1], sys.argv[2:]
    os.makedirs(folder, exist_ok=True)
    program = load_import()
    options = types.SimpleNamespace(floating=False, drives="file", exact=False)
    lines, rows = [], []
    for seed, scene in enumerate(scenes):
        name = f"e{seed}"
        path = os.path.join(folder, f"{name}.xml")
        made = subprocess.run([ISOC, scene, "--mjcf"], capture_output=True, text=True)
        with open(path, "w", encoding="utf-8") as file:
            file.write(made.stdout)
        text, said = program.imported(path, options)
        if made.returncode or text is None:
            print(made.stderr, said)
            return 1
        again = os.path.join(folder, f"{name}_again.scene")
        with open(again, "w", encoding="utf-8") as file:
            file.write(text)
        if not plant(folder, scene, name) or not plant(folder, again, f"{name}_again"):
            return 1
        lines += [f'#include "{name}/{name}.c"', f'#include "{name}_again/{name}_again.c"', *table(folder, name, path, seed)]
        rows.append(f"ROBOT_{name.upper()}")
    with open(os.path.join(folder, "robots.h"), "w", encoding="utf-8") as file:
        file.write("\n".join([*lines, "static const robot robots[] = {" + ", ".join(rows) + "};"]) + "\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())
