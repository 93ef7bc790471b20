#!/usr/bin/env python3
"""Small files of MJCF: what is said of each, and what its scene has; isoc takes all scenes. TAP."""
import math
import os
import subprocess
import sys

from write_robots import ROOT, load_import

FOLDER = sys.argv[1]
LONG = "a_link_whose_name_takes_almost_forty_letters"
HINGE = '<body name="arm"><joint name="hinge"{}/><geom type="box" size="0.1 0.1 0.1" pos="0.1 0 0" mass="1"/></body>'
BARE = (
    '<body name="cart"><joint name="rail" type="slide"/><geom size="0.1" mass="1"/>'
    '<body><joint name="wheel"/></body></body>'
)
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


BEYOND = '<body name="arm"><joint name="hinge"/><inertial pos="0 0 0" mass="1" diaginertia="0.01 0.03 0.05"/></body>'


def world(bodies, more="", before=""):
    return f"<mujoco>\n{before}\n<worldbody>{bodies}</worldbody>\n{more}\n</mujoco>"


def cord(sites, of="", more=""):
    ends = "".join(f'<site site="{site}"/>' for site in sites)
    return f'<tendon><spatial name="rope"{of}>{ends}</spatial></tendon>{more}'


KEYS = '<keyframe><key name="home" qpos="{}"{}/><key name="rest" qpos="{}"/></keyframe>'
ALL = (
    '<body name="arm"><joint name="hinge" ref="90"/><geom size="0.1" pos="0.1 0 0"/><body name="slider">'
    '<joint name="slide" type="slide"/><geom size="0.1"/><body name="bob"><joint name="ball" type="ball"/>'
    '<geom size="0.1" pos="0.1 0 0"/></body></body></body><body name="drone" pos="1 0 0"><freejoint name="air"/>'
    '<geom size="0.1"/></body>'
)
QUARTER = "0.70710678118654757"
BARS = (
    '<body name="crank"><joint name="crank" axis="0 1 0"/><geom size="0.1" pos="0 0 0.2"/>'
    '<body name="rod" pos="0 0 0.4"><joint name="knee" axis="0 1 0"/><geom size="0.1" pos="0.3 0 0"/></body></body>'
    '<body name="rocker" pos="0.6 0 0"><joint name="rocker" axis="0 1 0"/><geom size="0.1" pos="0 0 0.2"/></body>'
)
PIN = '<equality><connect body1="rod" body2="rocker" anchor="0.6 0 0"/></equality>'
PULL = '<actuator><motor name="pull" tendon="rope"/></actuator>'
FIXED = '<tendon><fixed name="sum"><joint joint="wheel" coef="2"/></fixed></tendon>'
# What is tried, the file, options, what is said of it, and what is not.
TAKEN = [
    (
        "the mass of a mesh is lost",
        world(HINGE.format("") + PAD, before=MESH),
        [],
        [
            "<geom>, line 3: the body 'pad' loses the mass of this mesh, and the file gives no inertia for it: write an "
            "<inertial> into it; the file '",
            "m.stl' cannot be read: No such file or directory",
            "the joint flap moves no inertia, and is held where it starts: the masses of meshes behind it are not taken",
        ],
        ["MuJoCo refuses it"],
    ),
    (
        "an inertia and a place of rounding errors",
        world(
            '<body name="arm"><joint name="hinge"/>'
            '<inertial pos="0.1 1e-50 0" mass="1" diaginertia="-5e-20 -5e-20 0"/></body>'
        ),
        [],
        ["the inertia of arm is zero but for rounding: it is a point", "com (0.1, 0, 0) m"],
        ["e-20", "e-50", "as_given"],
    ),
    *(
        ("an inertia beyond the triangle inequality", world(BEYOND, before=before), options, right, wrong)
        for before, options, right, wrong in (
            (
                "",
                [],
                [
                    "- warning: no body has the inertia of arm: its largest principal moment is 25 % larger than the sum of "
                    "the others; it is taken as written",
                    "inertia (0.01, 0.03, 0.05) kg*m^2 as_given",
                ],
                ["nearest possible one:"],
            ),
            (
                "",
                ["--repair-inertia"],
                [
                    "it is the nearest possible one: the principal moments 0.01, 0.03, 0.05 kg*m^2 are 0.0133333, 0.0333333, "
                    "0.0466667",
                    "inertia (0.01333333333333333",
                ],
                ["as_given", "warning"],
            ),
            (
                '<compiler balanceinertia="true"/>',
                [],
                ["the inertia of arm is the same in all directions: balanceinertia", "inertia (0.03, 0.03, 0.03) kg*m^2"],
                ["as_given", "warning"],
            ),
        )
    ),
    (
        "a negative principal moment, repaired",
        world(BEYOND.replace("0.01 0.03 0.05", "-0.01 0.03 0.03")),
        ["--repair-inertia"],
        ["a principal moment is negative; it is the nearest possible one", "inertia (0, 0.03, 0.03) kg*m^2"],
        ["as_given"],
    ),
    (
        "a reference of a ball joint, which has none",
        world(
            '<body name="arm"><joint name="b" type="ball" class="c"/><geom size="0.1" mass="1"/></body>',
            before='<default><default class="c"><joint ref="20"/></default></default>',
        ),
        [],
        ["All of the file is taken."],
        ["ref"],
    ),
    (
        "what switches off, of gravity that is carried and of limits of actuators",
        world(
            '<body name="arm" gravcomp="1"><joint name="hinge" axis="0 1 0" actuatorfrcrange="-1 1" actuatorgravcomp="true"/>'
            '<geom size="0.1" pos="1 0 0" mass="1"/></body>',
            '<actuator><motor joint="hinge"/></actuator>',
            '<option><flag actuation="disable"/></option>',
        ),
        [],
        ["effect arm_lift gravcomp", "least 0 N*m", "most 0 N*m", "actuators arm_lift_on_hinge.effort"],
        [],
    ),
    (
        "a limit of actuators that counts no thrust",
        world(
            '<body name="arm"><joint name="hinge" actuatorfrcrange="-1 1"/><geom size="0.1" pos="1 0 0" mass="1"/><site name="s"/></body>',
            '<actuator><motor joint="hinge"/><motor name="push" site="s"/></actuator>',
        ),
        [],
        ["actuators hinge_control", "the limits of joints do not count push, which drives no joint by name"],
        [],
    ),
    (
        "the largest float, as it is often written, for a limit",
        world(
            HINGE.format(""),
            '<actuator><motor joint="hinge" ctrllimited="true" ctrlrange="-3.4028235e+38 3.4028235e+38"/></actuator>',
        ),
        [],
        ["in -3.4028235e+38 N*m to 3.4028235e+38 N*m"],
        [],
    ),
    *(
        (
            f"a joint of URDF whose effort and velocity are {word}",
            '<robot name="r"><link name="a"/><link name="b"><inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" '
            'ixy="0" ixz="0" iyz="0"/></inertial></link><joint name="j" type="revolute"><parent link="a"/>'
            f'<child link="b"/><limit lower="-1" upper="1" effort="{word}" velocity="{word}"/></joint></robot>',
            [],
            ["input j_joint_effort N*m\n", "effect j_joint_stop stop", "All of the file is taken"],
            ["N*m in -", "speed of impact"],
        )
        for word in ("inf", "1.7976931348623157e+308")
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
        "what flags switch off",
        world(
            TWO.format(""),
            f'{GEAR}<actuator><motor name="pull" joint="j"/></actuator>',
            '<default><joint damping="1" stiffness="2" frictionloss="3" range="-1 1"/></default><option timestep="0.004">'
            '<flag gravity="disable" passive="disable" actuation="disable" constraint="disable" warmstart="disable"/>'
            "</option><option/>",
        ),
        [],
        [
            "<flag> switches off: actuation, constraint, gravity, passive",
            "warmstart of <flag>, line 2: of the solver of MuJoCo",
            "<joint>, line 4: <flag> switches it off",
            "<motor>, line 4: <flag> switches it off",
            "range of <joint>, line 2: <flag> switches it off",
            "step 4 ms",
        ],
        ["\ngravity ", "\neffect ", "\nclose ", "\ninput ", "damping", "spring"],
    ),
    *(
        (
            f"a flag that switches off {off} alone",
            world(
                HINGE.format(' damping="1" stiffness="2"') + HINGE.replace("arm", "leg").replace("hinge", "knee").format(' springdamper="1 1"'),
                before=f'<option><flag {off}="disable"/></option>',
            ),
            [],
            right,
            wrong,
        )
        for off, right, wrong in (
            ("spring", ["damping 1 N*m*s/rad"], ["spring 2", "    spring "]),
            ("damper", ["spring 2 N*m/rad"], ["    damping "]),
        )
    ),
    (
        "a flag that switches nothing off",
        world(HINGE.format(' damping="1"'), before='<option><flag gravity="enable" energy="enable"/></option>'),
        [],
        ["gravity (0, 0, -9.81)", "damping 1 N*m*s/rad", "step 2 ms"],
        ["switches off"],
    ),
    (
        "closures of free bodies, where they are drawn",
        world(
            '<body name="a"><freejoint/><geom size="0.1"/></body><body name="b" pos="1 0 0"><freejoint/><geom size="0.1"/></body>',
            '<equality><weld body1="a" body2="b"/></equality>',
        ),
        [],
        ["start at (0, 0, 0) m rotate 0 deg about z", "start at (1, 0, 0) m rotate 0 deg about z"],
        ["closures do not hold"],
    ),
    (
        "sites that a closure holds together, and that are drawn apart",
        world(
            '<site name="hook" pos="0 0 1"/><body name="bob"><freejoint/><geom size="0.1"/><site name="eye" pos="0 0 0.8"/>'
            "</body>",
            '<equality><connect site1="hook" site2="eye"/></equality>',
        ),
        [],
        ["closures do not hold where the file draws it: it starts as near to that as they hold", "start at (0"],
        [],
    ),
    (
        "a body without a name, and another with the name that it would have",
        world('<body><joint name="j"/><geom size="0.1"/></body><body name="body1"><joint name="k"/><geom size="0.1"/></body>'),
        [],
        ["body body2 {", "body body1 {"],
        [],
    ),
    (
        "limits that are none",
        world(HINGE.format(' range="0 0"'), '<actuator><motor joint="hinge" ctrlrange="0 0" forcerange="0 0"/></actuator>'),
        [],
        [
            "range of <joint>, line 3: the joint is not limited",
            "ctrlrange of <motor>, line 4: the control is not limited",
            "forcerange of <motor>, line 4: the force is not limited",
        ],
        ["stop", " in 0"],
    ),
    (
        "a link world that the file does not write",
        '<robot name="r"><link name="b"><inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" '
        'iyz="0"/></inertial></link><joint name="j" type="continuous"><parent link="world"/><child link="b"/></joint></robot>',
        [],
        ["parent ground", "All of the file is taken"],
        [],
    ),
    (
        "a joint with no part in a tendon",
        world(
            TWO.format(""),
            '<tendon><fixed name="sum"><joint joint="j" coef="0"/><joint joint="k"/></fixed></tendon>'
            '<equality><tendon tendon1="sum"/></equality>',
        ),
        [],
        ["<tendon>, line 4: one tendon between two sites, or of two joints, is a closure"],
        ["\nclose "],
    ),
    (
        "long names",
        world(
            "".join(HINGE.replace("arm", LONG + k).replace("hinge", LONG + k).format("") for k in "abc"),
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
        "starts outside of ranges",
        world(
            HINGE.format(' range="30 60"')
            + HINGE.replace("arm", "leg").replace("hinge", "knee").format(' range="-1 1"'),
            KEYS.format("0.6 0", "", "0.7 0"),
        ),
        [],
        [
            "starts hinge at 0 rad (0.523599 to 1.0472); other starts: --key home, --key rest",
            "<key>, line 4: a start of a run: --key home takes it",
        ],
        ["knee at"],
    ),
    (
        "a keyframe, of all kinds of joints",
        world(
            ALL,
            KEYS.format(
                f"2 0.25 {QUARTER} {QUARTER} 0 0 1 2 3 {QUARTER} 0 0 {QUARTER}",
                ' ctrl="1" qvel="1 2 3 4 5 6 7 8 9 10 11"',
                "0 0 1 0 0 0 1 2 3 1 0 0 0",
            ),
        ),
        ["--key", "home"],
        [
            "it starts as the keyframe home says",
            "start 0.42920367320510",
            "speed 1 rad/s",
            "start 0.25 m",
            "speed 2 m/s",
            f"start quaternion ({QUARTER[:18]}",
            "spin (3, 4, 5) rad/s",
            "start at (1, 2, 3) m rotate 90 deg about z",
            "speed (6, 7, 8) m/s",
            "spin (9, 10, 11) rad/s",
            "ctrl of <key>, line 4: inputs and activations start at zero",
            "a start of a run: --key rest takes it",
        ],
        ["--key home takes"],
    ),
    (
        "a keyframe where closures do not hold, but near it",
        world(BARS, PIN + KEYS.format("0.3 -0.3 0.29", "", "0 0 0")),
        ["--key", "home"],
        ["it starts as the keyframe home says, but as near to that as closures hold", "start 0.29"],
        [],
    ),
    (
        "a joint that is held where a keyframe starts it",
        world(BARE, KEYS.format(f"0.5 {math.pi / 2!r}", "", "0 0")),
        ["--key", "home"],
        ["parent cart rotate 90 deg about z", "start 0.5 m"],
        [],
    ),
    (
        "a servo that follows from its joint",  # of 0.01 / 3 * 2 + 0.01 kg*m^2: 2 sqrt(9 / 60) of damping
        world(
            HINGE.format(' range="-90 90"'),
            '<actuator><position joint="hinge" kp="9" dampratio="1" inheritrange="0.5"/></actuator>',
        ),
        [],
        ["input hinge_control = 0 in -0.785398163", "bias_by_rate -0.774596669", "All of the file is taken."],
        [],
    ),
    (
        "a servo whose default has a damping of its own",
        world(
            HINGE.format(""),
            '<actuator><position joint="hinge" kv="2"/></actuator>',
            '<default><position kp="9" dampratio="1"/></default>',
        ),
        [],
        ["bias_by_rate -2", "All of the file is taken."],
        [],
    ),
    *(
        (
            f"a {kind} whose default is a servo",
            world(
                HINGE.format(""),
                f'<actuator><{kind} joint="hinge"{more}/></actuator>',
                '<default><general biasprm="7"/><position kp="9" kv="2"/></default>',
            ),
            [],
            [*right, "All of the file is taken."],
            wrong,
        )
        for kind, more, right, wrong in (
            ("general", ' gainprm="3"', ["    gain 3", "    bias 7", "bias_by_length -9", "bias_by_rate -2"], []),
            ("motor", "", ["drive hinge_control"], ["servo"]),
            ("velocity", "", ["gain 9", "bias_by_rate -9"], ["    bias 7", "bias_by_length -"]),
            ("damper", ' kv="3" ctrlrange="0 1"', ["gain_by_rate -3"], ["    bias 7", "    gain 9"]),
            ("cylinder", ' timeconst="0.1" area="3"', ["gain 3", "bias 7", "bias_by_length -9", "lag 0.1 s"], []),
            ("intvelocity", "", ["gain 9", "bias_by_length -9", "bias_by_rate -2", "servo_t_integrator"], []),
        )
    ),
    (
        "a servo of a speed whose place has limits",
        world(
            HINGE.format(' range="-90 90"'),
            '<actuator><intvelocity joint="hinge" kp="9" inheritrange="1"/></actuator>',
        ),
        [],
        ["effect servo_t_integrator_kept", "lowest -1.570796326794", "highest 1.570796326794"],
        [],
    ),
]
# What is refused: the file, options, and lines of the errors.
REFUSED = [
    (
        "all masses are those of meshes",
        world(PAD, before=MESH),
        [],
        ["1:1: error: nothing moves in this file: the masses are those of meshes that are not taken"],
    ),
    *(
        (what, world(HINGE.format(""), f"<actuator>{actuator}</actuator>"), [], [right])
        for what, actuator, right in (
            (
                "a servo with two dampings",
                '<position joint="hinge" kp="9" kv="1" dampratio="1"/>',
                "4:49: error: kv and dampratio: one is right",
            ),
            (
                "a servo with two ranges",
                '<position joint="hinge" inheritrange="1" ctrlrange="0 1"/>',
                "error: ctrlrange and inheritrange: one is right",
            ),
            (
                "a servo of a joint without a range",
                '<position joint="hinge" inheritrange="1"/>',
                "error: inheritrange needs a joint or a tendon with a range",
            ),
        )
    ),
    *(
        (what, world(HINGE.format(of)), [], [right])
        for what, of, right in (
            ("half a springdamper", ' springdamper="0.1 0"', "error: springdamper is a time and a ratio above zero"),
            ("limits that cross", ' actuatorfrcrange="1 -1" actuatorfrclimited="true"', "error: the lower end of actuatorfrcrange"),
        )
    ),
    (
        "a negative principal moment",
        world(BEYOND.replace("0.01 0.03 0.05", "-0.01 0.03 0.03")),
        [],
        ["3:12: error: the inertia of 'arm' is impossible: a principal moment is negative"],
    ),
    *(
        (what, world(HINGE.format(""), KEYS.format("0.1 0.2", "", "0")), ["--key", name], [right])
        for what, name, right in (
            ("an unknown keyframe", "hom", "1:1: error: there is no key 'hom': there are home, rest"),
            ("a keyframe of two coordinates", "home", "4:28: error: 2 numbers in qpos: 1 are right"),
        )
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
        statements = "".join(line for line in scene.splitlines(True) if not line.startswith("#"))
        if statements in scenes:  # it is compiled once
            continue
        scenes.append(statements)
        file_of_scene = os.path.join(FOLDER, "small.scene")
        with open(file_of_scene, "w", encoding="utf-8") as file:
            file.write(scene)
        command = [os.path.join(ROOT, "build", "isoc"), file_of_scene, "-o", f"{FOLDER}/small"]
        run = subprocess.run(command, capture_output=True)
        if run.returncode:
            wrong.append(f"{what}: {run.stderr.decode()}")
    for what, text, options, right in REFUSED:
        scene, said = read(text, options)
        if scene is not None or any(part not in said for part in right) or said.count("error:") != 1:
            wrong.append(f"{what}: {said}")
    print("".join(f"# {line}\n" for text in wrong for line in text.split("\n")), end="")
    count = len(TAKEN) + len(REFUSED)
    print(f"{'not ' if wrong else ''}ok 1 - of {count} small files what is not taken has its reason")
    print("1..1")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
