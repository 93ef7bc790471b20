#!/usr/bin/env python3
"""Scenes as MJCF and back: write_exports.py FOLDER FIRST COUNT SCENE...

Writes for each scene, and for random ones (write_scene.py), what isoc --mjcf makes of it, the scene that the import makes of
that, both plants, and robots.h, as write_robots.py does. Right are the accelerations of the plant of the scene itself.
"""
import os
import re
import subprocess
import sys
import xml.etree.ElementTree as xml

from write_robots import ROOT, load_import, rename
from write_scene import Scene

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


def table(folder, name, path):
    root = xml.parse(path).getroot()
    joints = [(joint.get("name"), joint.get("type"), float(joint.get("ref", 0))) for joint in root.iter("joint") if joint.get("type")]
    inputs = inputs_of(folder, name)
    drives = []
    for motor in root.findall("actuator/*"):
        label = motor.get("name")
        own = [k for k, input_name in enumerate(inputs) if re.fullmatch(rf"{input_name}_(on_\w+|force\d+)", label)]
        drives.append((label, own[0] if own else -1))
    return [
        f"static const robot_joint {name}_joints[] = {{"
        + ", ".join(f'{{"{label}", {KINDS[kind]}, {zero!r}}}' for label, kind, zero in joints)
        + "};",
        f"static const robot_drive {name}_drives[] = {{"
        + ", ".join([*(f'{{"{label}", 1, "", {own}}}' for label, own in drives), "{0}"])
        + "};",
        f"static const robot_body {name}_bodies[] = {{{{0}}}};",
        f'#define ROBOT_{name.upper()} {{"{path}", {{&{name}_model, &{name}_derivative}}, {name}_joints, {len(joints)}, {name}_bodies, '
        f"{name}_drives, {len(drives)}, 1, {len(root.findall('equality/*'))}, {{{{0}}}}, {{&{name}_again_model, &{name}_again_derivative}}}}",
    ]


def main():
    folder, first, count, scenes = sys.argv[1], int(sys.argv[2]), int(sys.argv[3]), sys.argv[4:]
    os.makedirs(folder, exist_ok=True)
    for seed in range(first, first + count):
        scenes.append(os.path.join(folder, f"seed{seed}.scene"))
        with open(scenes[-1], "w", encoding="utf-8") as file:
            file.write(Scene(seed).text())
    program = load_import()
    lines, rows = [], []
    for seed, scene in enumerate(scenes):
        name = f"e{seed}"
        path = os.path.join(folder, f"{name}.xml")
        made = subprocess.run([ISOC, scene, "--mjcf"], capture_output=True, text=True)
        with open(path, "w", encoding="utf-8") as file:
            file.write(made.stdout)
        text, said = program.imported(path, program.parser().parse_args([path]))
        if made.returncode or text is None:
            print(scene, made.stderr, said)
            return 1
        again = os.path.join(folder, f"{name}_again.scene")
        with open(again, "w", encoding="utf-8") as file:
            file.write(text)
        if not plant(folder, scene, name) or not plant(folder, again, f"{name}_again"):
            return 1
        lines += [f'#include "{name}/{name}.c"', f'#include "{name}_again/{name}_again.c"', *table(folder, name, path)]
        rows.append(f"ROBOT_{name.upper()}")
    with open(os.path.join(folder, "robots.h"), "w", encoding="utf-8") as file:
        file.write("\n".join([*lines, "static const robot robots[] = {" + ", ".join(rows) + "};"]) + "\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())
