#!/usr/bin/env python3
"""Files that are wrong: each is refused with its place, what is wrong and what is right; and nothing is written. TAP."""
import os
import subprocess
import sys

from write_robots import ROOT, load_import

FOLDER = sys.argv[1]
URDF = (
    '<robot name="r">\n<link name="a"/>\n<link name="b"><inertial><mass value="1"/>'
    '<inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>\n'
    '<joint name="j" type="continuous"><parent link="a"/><child link="b"/></joint>\n</robot>'
)
MJCF = (
    '<mujoco>\n<compiler angle="radian"/>\n<worldbody>\n<body name="b">\n<joint name="j"/>\n'
    '<geom type="sphere" size="0.1" pos="0 0 1"/>\n</body>\n</worldbody>\n</mujoco>'
)
# The file, what is changed in it, the place and a part of the message.
CASES = [
    (URDF, '"continuous"', '"hinge"', "4:17", "the type 'hinge' of 'j' is not known: revolute"),
    (URDF, '<child link="b"/>', '<child link="c"/>', "4:60", "there is no link 'c'"),
    (URDF, '<child link="b"/>', "", "4:1", "has no <child>"),
    (URDF, 'value="1"', 'value="one"', "3:32", "'one' is no number"),
    (URDF, 'value="1"', 'value="-1"', "3:32", "the mass of 'b' is below zero"),
    (URDF, '"continuous"', '"revolute"', "4:1", "has no limit"),
    (URDF, "</robot>", '<link name="a"/></robot>', "5:7", "a second link 'a'"),
    (URDF, "</robot>", '<link name="c"/></robot>', "5:1", "only one link is the root"),
    (URDF, "</robot>", "</robo>", "5:3", "it is no XML: mismatched tag"),
    (URDF, '<parent link="a"/>', '<parent link="a"/><axis xyz="0 0"/>', "4:59", "2 numbers in xyz: 3 are right"),
    (URDF, '<parent link="a"/>', '<parent link="a"/><axis xyz="0 0 0"/>', "4:59", "the axis has no length"),
    (URDF, '<parent link="a"/>', '<parent link="a"/><mimic joint="k"/>', "4:60", "there is no joint 'k'"),
    (URDF, '"continuous"', '"fixed"', "1:1", "nothing moves in this file: a scene has a joint; --floating"),
    (URDF, "inertial>", "visual>", "1:1", "nothing moves in this file: no link has an <inertial>"),
    (URDF, 'ixx="1"', 'ixx="-1"', "3:43", "the inertia of 'b' is impossible: a principal moment is negative"),
    (URDF, "<link", '<xacro:property name="m" value="2"/><link', "2:1", "<xacro:property> is of xacro: expand the file first"),
    (URDF, 'value="1"', 'value="${2*m}"', "3:32", "'${2*m}' is of xacro: expand the file first"),
    (URDF, "<robot", '<?xml version="1.0" encoding="none"?><robot', "1:1", "it is no XML: unknown encoding: none; UTF-8"),
    (URDF, "robot", "model", "1:1", "neither <robot> of URDF nor <mujoco> of MJCF"),
    (MJCF, 'angle="radian"', 'angle="grad"', "2:11", "the angle is 'grad': degree or radian"),
    (MJCF, "<worldbody>", '<option><flag gravity="off"/></option><worldbody>', "3:15", "gravity is 'off': enable or disable"),
    (MJCF, 'angle="radian"', 'coordinate="global"', "2:11", "global coordinates"),
    (MJCF, '<joint name="j"/>', '<joint name="j" type="screw"/>', "5:17", "the type 'screw' is not known"),
    (MJCF, '<joint name="j"/>', '<joint name="j" class="k"/>', "5:17", "there is no class 'k'"),
    (MJCF, '<joint name="j"/>', '<joint name="j" damping="-1"/>', "5:1", "are not below zero"),
    (MJCF, 'size="0.1"', 'size="-1"', "6:21", "a sphere has 1 sizes above zero"),
    (MJCF, 'pos="0 0 1"', 'pos="0 0 1" euler="0 0 1" quat="1 0 0 0"', "6:44", "one way to write an orientation"),
    (
        MJCF,
        "<worldbody>",
        '<default><default class="a"><default class="a"/></default></default><worldbody>',
        "3:38",
        "a second default of the class 'a'",
    ),
    (MJCF, "<worldbody>", '<default><default class=""/></default><worldbody>', "3:10", "a default inside of another has a class"),
    (MJCF, '<joint name="j"/>', '<frame euler="0 a 0"><joint name="j"/></frame>', "5:8", "'a' is no number"),
    (MJCF, '<joint name="j"/>', '<frame euler="0 0"><joint name="j"/></frame>', "5:8", "2 numbers in euler: 3 are right"),
    (MJCF, "</mujoco>", '<include file="none.xml"/></mujoco>', "9:10", "there is no file"),
    (MJCF, "</mujoco>", '<actuator><motor joint="k"/></actuator></mujoco>', "9:18", "there is no joint 'k'"),
    (MJCF, "</mujoco>", '<actuator><motor/></actuator></mujoco>', "9:11", "drives one joint, tendon or site"),
    (MJCF, "</mujoco>", '<equality><connect body1="b"/></equality></mujoco>', "9:11", "a connect has an anchor"),
    (
        MJCF.replace("</body>", '<site name="s" pos="0 0 1"/></body><site name="t" pos="0 0 3"/>'),
        "</mujoco>",
        '<equality><connect site1="s" site2="t"/></equality></mujoco>',
        "1:1",
        "no start near that of the file is found where all closures hold",
    ),
    (MJCF, "<worldbody>", '<worldbody><body name="b"/>', "4:7", "a second body 'b'"),
]


def main():
    program = load_import()
    path = os.path.join(FOLDER, "bad.xml")
    wrong = []

    def said_of(text):
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        return program.imported(path, program.parser().parse_args([path]))

    for text in (URDF, MJCF):
        if said_of(text)[0] is None:
            wrong.append(f"refused, and right: {text}")
    for text, what, by, place, message in CASES:
        scene, said = said_of(text.replace(what, by) if what != "<link" else text.replace(what, by, 1))
        found = [line for line in said if line.startswith(f"{path}:{place}: error: ") and message in line]
        if scene is not None or len(found) != 1:
            wrong.append(f"{place} {message}: {said if scene is None else 'taken'}")
    print("\n".join(f"# {line}" for line in wrong), end="\n" if wrong else "")
    print(f"{'not ' if wrong else ''}ok 1 - {len(CASES)} files that are wrong are refused with their place")
    out = os.path.join(FOLDER, "kept.scene")
    with open(out, "w", encoding="utf-8") as file:
        file.write("as it was\n")
    run = subprocess.run(["python3", "-B", os.path.join(ROOT, "tools", "import"), path, "-o", out], capture_output=True, text=True)
    with open(out, encoding="utf-8") as file:
        is_kept = file.read() == "as it was\n" and run.returncode == 1 and run.stdout == ""
    print(f"{'' if is_kept else 'not '}ok 2 - what is refused ends with 1, and leaves the scene as it was")
    print("1..2")
    return 1 if wrong or not is_kept else 0


if __name__ == "__main__":
    sys.exit(main())
