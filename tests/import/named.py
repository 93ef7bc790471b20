#!/usr/bin/env python3
"""Small files of MJCF: what is said of each, and what its scene has; isoc takes all scenes. TAP."""
import os
import subprocess
import sys

from write_robots import ROOT, load_import

FOLDER = sys.argv[1]
LONG = "a_link_whose_name_takes_almost_forty_letters"
HINGE = '<body name="arm"><joint name="hinge"{}/><geom type="box" size="0.1 0.1 0.1" pos="0.1 0 0" mass="1"/></body>'
BARE = '<body name="cart"><joint name="rail" type="slide"/><geom size="0.1" mass="1"/><body><joint name="wheel"/></body></body>'
MESH = '<asset><mesh name="m" file="m.stl"/></asset>'
PAD = '<body name="pad"><joint name="flap"/><geom type="mesh" mesh="m"/></body>'
HUNG = (
    '<site name="top" pos="0 0 2"/><body name="ball" pos="0 0 1"><freejoint/><site name="hook" pos="0 0 0.3"/>'
    '<geom size="0.1" mass="1"/></body>'
)
TWO = (
    '<body name="a"><joint name="j"/><geom size="0.1" pos="0.3 0 0"{0}/></body>'
    '<body name="b" pos="1 0 0"><joint name="k"/><geom size="0.1" pos="0.3 0 0"{0}/></body>'
)
GEAR = '<equality><joint joint1="j" joint2="k"/></equality>'


def world(bodies, more="", before=""):
    return f"<mujoco>\n{before}\n<worldbody>{bodies}</worldbody>\n{more}\n</mujoco>"


def cord(sites, of="", more=""):
    ends = "".join(f'<site site="{site}"/>' for site in sites)
    return f'<tendon><spatial name="rope"{of}>{ends}</spatial></tendon>{more}'


PULL = '<actuator><motor name="pull" tendon="rope"/></actuator>'
FIXED = '<tendon><fixed name="sum"><joint joint="wheel" coef="2"/></fixed></tendon>'
# What is tried, the file, options, what is said of it, and what is not.
TAKEN = [
    (
        "the mass of a mesh is lost",
        world(HINGE.format("") + PAD, before=MESH),
        [],
        [
            "<geom>, line 3: the body 'pad' loses the mass of this mesh, which is not read, and the file gives no inertia "
            "for it: write an <inertial> into it",
            "the joint flap moves no inertia, and is held where it starts: the masses of meshes behind it are not read",
        ],
        ["MuJoCo refuses it"],
    ),
    (
        "a joint without inertia is MuJoCo's to refuse",
        world(BARE),
        [],
        ["the joint wheel moves no inertia, and is held where it starts: MuJoCo refuses it"],
        [],
    ),
    *(
        (f"the integrator {word}", world(HINGE.format(""), before=f'<option integrator="{word}"/>'), [], said, left)
        for word, said, left in (
            ("implicit", ["method rosenbrock", "implicit is method rosenbrock"], ["integrator of <option>"]),
            ("implicitfast", ["method rosenbrock", "implicitfast is method rosenbrock"], ["integrator of <option>"]),
            ("RK4", ["method rk4"], ["integrator of <option>"]),
            ("Euler", ["method rk4", "integrator of <option>, line 2: method rk4 takes its place"], []),
        )
    ),
    *(
        (
            f"a tendon from {sites[0]} to {sites[1]}: {what}",
            world(HUNG, cord(sites, of, more)),
            [],
            ["one (0, 0, 2) m", "other ball at (0, 0, 0.3) m"],
            ["one ground"],
        )
        for sites in (("top", "hook"), ("hook", "top"))
        for what, of, more in (
            ("a motor", "", PULL),
            ("two lengths of a spring", ' springlength="0 0.5" stiffness="100"', ""),
        )
    ),
    *(
        (
            f"no joint of a tendon moves{what}",
            world(BARE, FIXED + f'<actuator><motor tendon="sum"{of}/></actuator>'),
            [],
            ["<fixed>, line 4: none of its joints moves", "<motor>, line 4: its tendon is not taken"],
            ["effect servo", "input "],
        )
        for what, of in (("", ""), (", limited", ' forcerange="-2 2"'))
    ),
    (
        "long names",
        world(
            "".join(HINGE.replace('"arm"', f'"{LONG}{k}"').replace('"hinge"', f'"{LONG}{k}"').format("") for k in "abc"),
            "<equality>" + "".join(f'<joint joint1="{LONG}a" joint2="{LONG}{k}"/>' for k in "bc") + "</equality>",
        ),
        [],
        ["_closure gear"],
        [],
    ),
    (
        "defaults that closures use",
        world(TWO.format(""), GEAR, '<default><equality solref="0.005 1"/></default>'),
        [],
        ["solref of <equality>, line 2: a closure is hard"],
        ["nothing uses this default"],
    ),
    (
        "defaults that only a weightless geom uses",
        world(
            HINGE.format("") + '<geom class="own"/>',
            before='<default><default class="own"><geom pos="1 2 3"/></default></default>',
        ),
        [],
        ["pos of <geom>, line 2: it weighs nothing, and contact is of points and balls with the ground"],
        ["nothing uses this default"],
    ),
    (
        "newer attributes of a servo",
        world(
            HINGE.format(' range="-90 90"'),
            '<actuator><position joint="hinge" kp="9" dampratio="1" inheritrange="1"/></actuator>',
        ),
        [],
        [
            "inheritrange of <position>, line 4: newer than what is taken: the control has the limits of a ctrlrange, or none",
            "dampratio of <position>, line 4: newer than what is taken: the damping is that of kv, or none",
        ],
        [],
    ),
]
# What is refused: the file, options, and lines of the errors.
REFUSED = [
    (
        "all masses are those of meshes",
        world(PAD, before=MESH),
        [],
        ["1:1: error: nothing moves in this file: the masses are those of meshes, which are not read"],
    ),
    (
        "a replicate, and what is missed because of it",
        world(f'<replicate count="3" offset="0.1 0 0">{HUNG}</replicate>', cord(("top", "hook"))),
        [],
        ["3:12: error: a replicate is 3 copies of what stands in it, which are not made here: write the copies out"],
    ),
    (
        "what an element that is not taken would have had",
        world(HINGE.format("") + '<composite type="cable"/>', '<actuator><motor joint="cable"/></actuator>'),
        [],
        ["- <composite>, line 3: made of many, or by a plugin", "4:18: error: there is no joint 'cable'"],
    ),
]


def main():
    program = load_import()
    path = os.path.join(FOLDER, "small.xml")
    scenes, wrong = [], []

    def read(text, options):
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        scene, said = program.imported(path, program.parser().parse_args([path, *options]))
        return scene, "\n".join(said)

    for what, text, options, right, not_said in TAKEN:
        scene, said = read(text, options)
        whole = f"{said}\n{scene}"
        missed = [part for part in right if part not in whole] + [part for part in not_said if part in whole]
        if scene is None or missed:
            wrong.append(f"{what}: {missed}: {said}")
            continue
        scenes.append(os.path.join(FOLDER, f"small{len(scenes)}.scene"))
        with open(scenes[-1], "w", encoding="utf-8") as file:
            file.write(scene)
        run = subprocess.run([os.path.join(ROOT, "build", "isoc"), scenes[-1], "-o", f"{FOLDER}/small"], capture_output=True)
        if run.returncode:
            wrong.append(f"{what}: {run.stderr.decode()}")
    for what, text, options, right in REFUSED:
        scene, said = read(text, options)
        if scene is not None or any(part not in said for part in right) or said.count("error:") != 1:
            wrong.append(f"{what}: {said}")
    print("".join(f"# {line}\n" for text in wrong for line in text.split("\n")), end="")
    print(f"{'not ' if wrong else ''}ok 1 - of {len(TAKEN) + len(REFUSED)} small files what is not taken has its reason")
    print("1..1")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
