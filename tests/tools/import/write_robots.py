#!/usr/bin/env python3
"""Random robots, imported: write_robots.py FOLDER FAMILY FIRST COUNT [PLANTED]. FAMILY: usual (generate.py) or odd (odd.py).

Writes each robot, its scene, its plant, and robots.h: the plants, with states, controls and the accelerations that are right.
With PLANTED, a pattern and what takes its place in the scenes, as `s/damping/spring/` does, the import errs.
"""
import os
import random
import re
import subprocess
import sys
import types

ROOT = os.path.abspath(os.path.join(os.path.dirname(__file__), "..", "..", ".."))
sys.path.insert(0, os.path.join(ROOT, "tools", "import"))
import generate  # noqa: E402
import odd  # noqa: E402

STATES = 4


def load_import():
    """The program of tools/import, as a module."""
    found = types.ModuleType("robot_import")
    path = os.path.join(ROOT, "tools", "import", "__main__.py")
    with open(path, encoding="utf-8") as file:
        exec(compile(file.read(), path, "exec"), found.__dict__)
    return found


def rename(folder, name):
    """The plant, in a program with others: the functions and tables of the file have its name before their own."""
    path = os.path.join(folder, name, f"{name}.c")
    with open(path, encoding="utf-8") as file:
        text = file.read()
    own = sorted(set(re.findall(r"^(?:ISO_FLAT )?static [^=;(]*?\b(\w+)(?:\[[^=]*\])?(?: =|\(|;)", text, re.M)))
    words = re.compile(rf"(?<![.>\w])({'|'.join(own)})\b")
    lines = [line if line.startswith("#") else words.sub(rf"{name}_own_\1", line) for line in text.splitlines()]
    with open(path, "w", encoding="utf-8") as file:
        file.write("\n".join(lines) + "\n")


def made_of(family, seed, folder):
    if family == "usual":
        return (generate.urdf if seed % 3 == 0 else generate.mjcf)(seed)
    return odd.urdf(seed) if seed % 4 == 0 else odd.mjcf(seed, folder)


def limits_differ(text, robot):
    """The inputs of a scene whose limits are not those of the robot, or that do not begin with what is nearest to zero
    within them."""
    wrong = []
    for name, (low, high) in robot.input_limits.items():
        found = re.search(rf"^input {name} = (\S+) in (\S+) to (\S+)$", text, re.M)
        wanted = (min(max(0.0, low), high), low, high)
        if found is None or max(abs(float(text) - limit) for text, limit in zip(found.groups(), wanted)) > 1e-12:
            wrong.append(f"{name} from {low} to {high}")
    return wrong


def sprung(joint):
    return (joint.spring, joint.damping) if getattr(joint, "timing", None) else (0.0, 0.0)


def numbers(values):
    return "{" + ", ".join(repr(float(v)) for v in values) + "}"


def table(name, robot, tree, path, seed):
    """Lines of C: the robot, and its states."""
    r = random.Random(seed + 1)
    lines, joints = [], list(tree.joints.values())
    kinds = {"hinge": "HINGE", "slide": "SLIDE", "ball": "BALL", "free": "FREE"}
    lines.append(
        f"static const robot_joint {name}_joints[] = {{"
        + ", ".join(f'{{"{joint.name}", {kinds[joint.kind]}, {joint.zero!r}, {", ".join(map(repr, sprung(joint)))}}}' for joint in joints)
        + "};"
    )
    drives = [
        f'{{"{drive[0]}", {int(drive[1] == "control")}, "{drive[2][0][0] if drive[2] else ""}"}}'
        for drive in robot.drives
    ]
    lines.append(f"static const robot_drive {name}_drives[] = {{" + ", ".join([*drives, "{0}"]) + "};")
    inertials = ", ".join(
        f'{{"{body}", {m!r}, {numbers(c)}, {{{", ".join(numbers(row) for row in i)}}}, {dict(robot.lifts).get(body, 0.0)!r}, {int(body in robot.of_meshes)}}}'
        for body, m, c, i in robot.inertials(robot.suffix == "urdf")
    )
    lines.append(f"static const robot_body {name}_bodies[] = {{{inertials}, {{0}}}};")
    for k in range(STATES):
        position, speed = robot.state(tree)
        controls = [r.uniform(-3, 3) for _ in robot.drives]
        effort = odd.efforts(robot, tree, position, speed, controls)
        right = tree.accelerations(position, speed, effort, generate.gear_rows(robot, tree))
        for what, values in (
            ("q", [x for joint in joints for x in position[joint.name]]),
            ("v", [x for joint in joints for x in speed[joint.name]]),
            ("u", controls or [0.0]),
            ("a", right),
        ):
            lines.append(f"static const double {name}_{what}{k}[] = {numbers(values)};")
    limits = [
        f'{{"{joint}", {low!r}, {high!r}, {int(counts)}}}' for joint, (low, high, counts) in robot.effort_limits.items()
    ]
    lines.append(f"static const robot_limit {name}_limits[] = {{" + ", ".join([*limits, "{0}"]) + "};")
    ratios = [f'{{"{drive}", {ratio!r}}}' for drive, ratio in robot.ratios]
    lines.append(f"static const robot_ratio {name}_ratios[] = {{" + ", ".join([*ratios, "{0}"]) + "};")
    states = ", ".join(f"{{{name}_q{k}, {name}_v{k}, {name}_u{k}, {name}_a{k}}}" for k in range(STATES))
    lines.append(
        f'#define ROBOT_{name.upper()} {{"{path}", {{&{name}_model, &{name}_derivative}}, {name}_joints, {len(joints)}, {name}_bodies, {name}_drives, '
        f"{len(robot.drives)}, {int(robot.against_mujoco)}, {len(robot.gears)}, {{{states}}}, {{0}}, {name}_limits, {name}_ratios, {int(robot.is_odd)}}}"
    )
    return lines


def main():
    folder, family, first, count = sys.argv[1], sys.argv[2], int(sys.argv[3]), int(sys.argv[4])
    planted = sys.argv[5].split("/")[1:3] if len(sys.argv) > 5 else None
    os.makedirs(folder, exist_ok=True)
    program = load_import()
    lines, rows, failed = [], [], 0
    for seed in range(first, first + count):
        robot = made_of(family, seed, folder)
        name, path = f"r{seed}", os.path.join(folder, f"r{seed}.{robot.suffix}")
        plain = os.path.join(folder, f"r{seed}_plain.{robot.suffix}")
        for place, text in ((path, robot.text()), (plain, robot.plain())):
            with open(place, "w", encoding="utf-8") as file:
                file.write(text)
        text, said = program.imported(path, program.parser().parse_args([path, *["--floating"] * robot.floating]))
        if text is None or limits_differ(text, robot):
            print("\n".join([*said, *(limits_differ(text, robot) if text is not None else [])]))
            failed += 1
            continue
        if planted:
            text = re.sub(planted[0], planted[1], text)
        scene = os.path.join(folder, f"{name}.scene")
        with open(scene, "w", encoding="utf-8") as file:
            file.write(text)
        formulation = ["--formulation", ("composite", "articulated")[seed // 3 % 2]] if "\nclose " not in text else []
        made = subprocess.run(
            [
                os.path.join(ROOT, "build", "isoc"),
                scene,
                "-o",
                os.path.join(folder, name),
                "--name",
                name,
                "--real",
                "double",
                *formulation,
            ],
            capture_output=True,
            text=True,
        )
        if made.returncode:
            print(made.stderr)
            failed += 1
            continue
        rows.append(f"ROBOT_{name.upper()}")
        rename(folder, name)
        lines += [f'#include "{name}/{name}.c"', *table(name, robot, robot.tree(), plain, seed)]
    with open(os.path.join(folder, "robots.h"), "w", encoding="utf-8") as file:
        file.write("\n".join([*lines, "static const robot robots[] = {" + ", ".join(rows) + "};"]) + "\n")
    return failed > 0


if __name__ == "__main__":
    sys.exit(main())
