"""Random robots: each a tree (dynamics.py) and its text, in URDF or MJCF."""
import math
import random
import re

from dynamics import (
    Body,
    Joint,
    Tree,
    by,
    cross,
    dot,
    less,
    of_quaternion,
    on,
    plus,
    rotation,
    times,
    transposed,
    turned,
)

IDENTITY = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
UNITS = {"x": (1, 0, 0), "y": (0, 1, 0), "z": (0, 0, 1)}


def words(values):
    return " ".join(repr(float(v)) for v in values)


class Robot:
    def __init__(self, seed):
        self.r = random.Random(seed)
        self.lines = []
        self.bodies = []
        self.drives = []  # (name, how, list of (joint, factor of effort by control), bias function or None)
        self.gears = []  # (joint, joint, ratio, offset): constraints
        self.thrusts = {}  # by the name of a drive: body, point, axes, force and moment of a control of 1
        self.cords = []  # (two of (body, point), stiffness, damping, length)
        self.against_mujoco = True
        self.suffix = "urdf"
        self.floating = False  # its root, as it is asked for
        self.lifts = []  # (body, share of its weight that a force carries)
        self.effort_limits = {}  # by the name of a joint: of all its drives, and whether lifts count
        self.ratios = []  # (drive, damping ratio)
        self.input_limits = {}  # by the name of a drive: limits of the scene's input
        self.of_meshes = set()  # bodies
        self.is_odd = False  # libmujoco refuses its inertias
        self.gravity = [0.0, 0.0, -9.81]

    def vector(self, size=1.0):
        return [round(self.r.uniform(-size, size), 4) for _ in range(3)]

    def axis(self):
        r = self.r
        if r.random() < 0.4:
            v = [0.0, 0.0, 0.0]
            v[r.randrange(3)] = r.choice([1.0, -1.0])
            return v
        v = self.vector()
        return v if sum(abs(x) for x in v) > 0.3 else [0.0, 1.0, 0.0]

    def inertia(self, mass):
        """Possible, and full: of three pairs of points and turned axes."""
        second = [mass * self.r.uniform(0.001, 0.05) for _ in range(3)]
        moments = [second[1] + second[2], second[0] + second[2], second[0] + second[1]]
        diagonal = [[moments[i] * (i == j) for j in range(3)] for i in range(3)]
        return moments, turned(diagonal, rotation(self.axis(), self.r.uniform(-3, 3)))

    def state(self, tree):
        """A random state within the limits; of joints that gears couple a fitting one."""
        r, position, speed = self.r, {}, {}
        for name, joint in tree.joints.items():
            if joint.dofs() == 1:
                low, high = joint.limits or (joint.zero - 1.5, joint.zero + 1.5)
                position[name] = [r.uniform(low + 0.02 * (high - low), high - 0.02 * (high - low))]
            else:
                q = [r.gauss(0, 1) for _ in range(4)]
                size = math.sqrt(sum(x * x for x in q))
                position[name] = [x / size for x in q]
                if joint.kind == "free":
                    position[name] = [r.uniform(-1, 1) for _ in range(3)] + position[name]
            speed[name] = [r.uniform(-2, 2) for _ in range(joint.dofs())]
        for first, second, ratio, offset in self.gears:
            one, other = tree.joints[first], tree.joints[second]
            position[first] = [one.zero + offset + ratio * (position[second][0] - other.zero)]
            speed[first] = [ratio * speed[second][0]]
        return position, speed

    def inertials(self, is_fused):
        """What MuJoCo makes of the solids: (body, mass, centre, inertia). Of URDF it fuses what is fixed."""
        parts, place = {}, {}
        for body in self.bodies:
            own = (body.name, [0.0] * 3, IDENTITY)
            if is_fused and not body.joints:
                on_body, at, turn = place.get(body.parent, (body.parent, [0.0] * 3, IDENTITY))
                own = (on_body, plus(at, on(turn, body.at)), times(turn, body.turn))
            place[body.name] = own
            parts.setdefault(own[0], []).extend(
                (m, plus(own[1], on(own[2], c)), turned(i, own[2])) for m, c, i in body.solids
            )
        return [(name, *joined(solids)) for name, solids in parts.items() if name != "world"]

    def tree(self):
        return Tree(self.bodies, self.gravity)

    def text(self):
        return "\n".join(self.lines) + "\n"

    def plain(self):
        """The file for libmujoco."""
        return self.text()


def joined(solids):
    """Solids as one: mass, centre, and the inertia about it."""
    mass = sum(m for m, _, _ in solids)
    centre = [sum(m * c[k] for m, c, _ in solids) / mass for k in range(3)]
    total = [[0.0] * 3 for _ in range(3)]
    for m, c, inertia in solids:
        r = [x - y for x, y in zip(c, centre)]
        for i in range(3):
            for j in range(3):
                total[i][j] += inertia[i][j] + m * ((i == j) * sum(x * x for x in r) - r[i] * r[j])
    return mass, centre, total


def urdf(seed, robot=None):
    """Links on joints of all kinds, fixed ones among them, with drives by transmissions, and at times a mimic."""
    robot = robot or Robot(seed)
    r, lines = robot.r, robot.lines
    lines.append('<?xml version="1.0"?>\n<robot name="made">\n  <link name="base"/>')
    names = ["base"]
    floats = r.random() < 0.3
    for k in range(r.randrange(2, 7)):
        parent = r.choice(names[-2:])
        kind = (
            "floating" if floats and k == 0 else r.choice(["revolute", "revolute", "continuous", "prismatic", "fixed"])
        )
        if kind == "fixed" and (parent == "base" or k == 0):
            kind = "revolute"
        urdf_link(robot, f"link{k}", "base" if kind == "floating" else parent, kind)
        if floats and k == 0:
            names.remove("base")
        names.append(f"link{k}")
    if r.random() < 0.25:
        urdf_mimic(robot)
    lines.append("</robot>")
    return robot


def urdf_link(robot, name, parent, kind):
    r = robot.r
    at, rpy = robot.vector(0.5), [round(r.uniform(-3, 3), 3) if r.random() < 0.6 else 0.0 for _ in range(3)]
    turn = times(times(rotation((0, 0, 1), rpy[2]), rotation((0, 1, 0), rpy[1])), rotation((1, 0, 0), rpy[0]))
    joint = Joint(f"{name}_joint", {"prismatic": "slide", "floating": "free"}.get(kind, "hinge"), axis=robot.axis())
    text = [
        f'    <origin xyz="{words(at)}" rpy="{words(rpy)}"/>',
        f'    <parent link="{parent}"/><child link="{name}"/>',
    ]
    if kind not in ("fixed", "floating"):
        text.append(f'    <axis xyz="{words(joint.axis)}"/>')
        if r.random() < 0.6:
            joint.damping = round(r.uniform(0.01, 2), 3)
            text.append(f'    <dynamics damping="{joint.damping}"/>')
        if kind != "continuous":
            joint.limits = (round(-r.uniform(0.5, 2), 3), round(r.uniform(0.5, 2), 3))
            text.append(f'    <limit lower="{joint.limits[0]}" upper="{joint.limits[1]}" effort="50" velocity="3"/>')
        robot.drives.append((f"{name}_joint_effort", "effort", [(joint.name, 1.0)], None))
    robot.lines += [f'  <joint name="{name}_joint" type="{kind}">', *text, "  </joint>", *urdf_inertial(robot, name)]
    body = Body(name, "world" if parent == "base" else parent, at, turn, [] if kind == "fixed" else [joint])
    body.solids.append(robot.last)
    robot.bodies.append(body)


def urdf_inertial(robot, name):
    r = robot.r
    mass = round(r.uniform(0.1, 5), 3)
    _, inertia = robot.inertia(mass)
    at, rpy = robot.vector(0.2), [round(r.uniform(-3, 3), 3) if r.random() < 0.5 else 0.0 for _ in range(3)]
    turn = times(times(rotation((0, 0, 1), rpy[2]), rotation((0, 1, 0), rpy[1])), rotation((1, 0, 0), rpy[0]))
    robot.last = (mass, at, turned(inertia, turn))
    i = inertia
    return [
        f'  <link name="{name}">',
        "    <inertial>",
        f'      <origin xyz="{words(at)}" rpy="{words(rpy)}"/>',
        f'      <mass value="{mass}"/>',
        f'      <inertia ixx="{i[0][0]!r}" iyy="{i[1][1]!r}" izz="{i[2][2]!r}" ixy="{i[0][1]!r}" ixz="{i[0][2]!r}" '
        f'iyz="{i[1][2]!r}"/>',
        "    </inertial>",
        '    <visual><geometry><sphere radius="0.1"/></geometry></visual>' if r.random() < 0.1 else "",
        "  </link>",
    ]


def urdf_mimic(robot):
    """MuJoCo 2 reads no mimic: only this project's own dynamics know what is right."""
    single = [j for body in robot.bodies for j in body.joints if j.dofs() == 1]
    if len(single) < 2:
        return
    first, second = single[-1], single[0]
    ratio, offset = round(robot.r.uniform(-1, 1), 2), round(robot.r.uniform(-0.3, 0.3), 2)
    robot.gears.append((first.name, second.name, ratio, offset))
    robot.drives = [drive for drive in robot.drives if drive[0] != f"{first.name}_effort"]
    first.limits, second.limits = None, (-0.5, 0.5)
    at = robot.lines.index(f'  <joint name="{first.name}" type="{kind_of(robot, first.name)}">')
    robot.lines.insert(at + 1, f'    <mimic joint="{second.name}" multiplier="{ratio}" offset="{offset}"/>')
    robot.against_mujoco = False
    for k, line in enumerate(robot.lines):
        if "<limit" in line:
            robot.lines[k] = '    <limit lower="-9" upper="9" effort="50" velocity="3"/>'


def kind_of(robot, name):
    line = next(line for line in robot.lines if line.startswith(f'  <joint name="{name}"'))
    return line.split('type="')[1].split('"')[0]


# --- MJCF ---


class Compiler:
    def __init__(self, r):
        self.degrees = r.random() < 0.5
        self.eulerseq = "".join(r.choice("xyzXYZ") for _ in range(3)) if r.random() < 0.5 else "xyz"
        if len({c.islower() for c in self.eulerseq}) > 1:
            self.eulerseq = self.eulerseq.lower()

    def angle(self, x):
        """A number of the file for an angle, and the angle that it says."""
        text = round(math.degrees(x), 2) if self.degrees else round(x, 4)
        return text, math.radians(text) if self.degrees else text


def orientation(robot, compiler):
    """An attribute, and the matrix that it says."""
    r = robot.r
    kind = r.choice(["", "quat", "euler", "axisangle", "xyaxes"])
    if kind == "quat":
        q = [round(r.uniform(-1, 1), 3) for _ in range(3)] + [0.5]
        return f' quat="{words(q)}"', of_quaternion(q)
    if kind == "euler":
        turn, text = IDENTITY, []
        for letter in compiler.eulerseq:
            said, angle = compiler.angle(r.uniform(-3, 3))
            text.append(said)
            step = rotation(UNITS[letter.lower()], angle)
            turn = times(turn, step) if letter.islower() else times(step, turn)
        return f' euler="{words(text)}"', turn
    if kind == "axisangle":
        axis = robot.axis()
        said, angle = compiler.angle(r.uniform(-3, 3))
        return f' axisangle="{words([*axis, said])}"', rotation(axis, angle)
    if kind == "xyaxes":
        columns = transposed(rotation(robot.axis(), r.uniform(-3, 3)))
        y = plus(columns[1], [0.3 * x for x in columns[0]])
        return f' xyaxes="{words([*[2 * x for x in columns[0]], *y])}"', transposed(columns)
    return "", IDENTITY


def mjcf(seed):
    """Nested bodies with several joints each, geoms or inertials, classes, actuators of all kinds, a tendon, gears."""
    robot = Robot(seed)
    r = robot.r
    robot.suffix = "xml"
    compiler = Compiler(r)
    robot.gravity = [0.0, 0.0, -9.81] if r.random() < 0.5 else robot.vector(10)
    chance = random.Random(seed)
    off = [name for name in ("gravity", "passive") if chance.random() < 0.2]
    flags = " ".join(f'{name}="disable"' for name in off)
    robot.classes = {
        "main": {"damping": 0.0, "armature": 0.0, "density": 1000.0},
        "joints": {"damping": round(r.uniform(0.1, 1), 2), "armature": 0.0, "density": 500.0},
        "inner": {"damping": round(r.uniform(0.1, 1), 2), "armature": round(r.uniform(0.01, 0.5), 3), "density": 500.0},
    }
    outer, inner = robot.classes["joints"], robot.classes["inner"]
    robot.lines += [
        '<mujoco model="made">',
        f'  <compiler angle="{"degree" if compiler.degrees else "radian"}" eulerseq="{compiler.eulerseq}"/>',
        f'  <option timestep="0.001" gravity="{words(robot.gravity)}"><flag {flags}/></option>',
        "  <default>",
        f'    <default class="joints"><joint damping="{outer["damping"]}"/><geom density="500"/>',
        f'      <default class="inner"><joint damping="{inner["damping"]}" armature="{inner["armature"]}"/></default>',
        "    </default>",
        "  </default>",
        "  <worldbody>",
    ]
    count = [0]
    for _ in range(r.choice([1, 1, 2])):
        mjcf_body(robot, compiler, "world", 0, count, "main")
    robot.lines.append("  </worldbody>")
    mjcf_cord(robot)
    mjcf_actuators(robot)
    robot.lines.append("</mujoco>")
    switch_off(robot, off)
    return robot


def switch_off(robot, what):
    """What <flag> disables."""
    if "gravity" in what:
        robot.gravity = [0.0] * 3
    if "passive" in what:
        robot.cords = []
        for body in robot.bodies:
            for joint in body.joints:
                joint.damping = joint.spring = 0.0


def mjcf_body(robot, compiler, parent, depth, count, childclass):
    r, pad = robot.r, "  " * (depth + 2)
    name = f"body{count[0]}"
    count[0] += 1
    at = robot.vector(0.5)
    text, turn = orientation(robot, compiler)
    given = r.choice(["joints", "inner"]) if r.random() < 0.4 else ""
    childclass = given or childclass
    robot.lines.append(
        f'{pad}<body name="{name}" pos="{words(at)}"{text}{f" childclass={chr(34)}{given}{chr(34)}" if given else ""}>'
    )
    body = Body(name, parent, at, turn, [])
    if depth == 0 and r.random() < 0.3:
        robot.lines.append(f'{pad}  <freejoint name="{name}_free"/>')
        body.joints.append(Joint(f"{name}_free", "free"))
    elif depth == 0 or r.random() < 0.85:
        for k in range(r.choice([1, 1, 1, 2, 3])):
            if any(joint.kind == "ball" for joint in body.joints):
                break
            mjcf_joint(robot, compiler, body, f"{name}_j{k}", pad, childclass)
    robot.bodies.append(body)
    mjcf_solids(robot, compiler, body, pad, robot.classes[childclass]["density"])
    point = robot.vector(0.3)
    text, turn = orientation(robot, compiler)
    robot.lines.append(f'{pad}  <site name="{name}_site" pos="{words(point)}"{text}/>')
    body.site = (point, turn)
    for _ in range(r.choice([0, 1, 1, 2]) if depth < 3 and count[0] < 7 else 0):
        mjcf_body(robot, compiler, name, depth + 1, count, childclass)
    robot.lines.append(f"{pad}</body>")


def mjcf_joint(robot, compiler, body, name, pad, childclass):
    r = robot.r
    kind = (
        r.choice(["hinge", "hinge", "hinge", "slide", "ball"])
        if not body.joints
        else r.choice(["hinge", "hinge" if any(j.kind == "slide" for j in body.joints) else "slide"])
    )
    defaults = robot.classes[childclass]
    joint = Joint(
        name, kind, at=robot.vector(0.2), axis=robot.axis(), damping=defaults["damping"], armature=defaults["armature"]
    )
    text = f'{pad}  <joint name="{name}" type="{kind}" pos="{words(joint.at)}"'
    if kind == "ball":
        joint.armature = 0.0
        robot.lines.append(text + ' armature="0"/>')
        body.joints.append(joint)
        return
    text += f' axis="{words(joint.axis)}"'
    if r.random() < 0.4:
        joint.damping = round(r.uniform(0, 1), 3)
        text += f' damping="{joint.damping}"'
    angle = compiler.angle if kind == "hinge" else lambda x: (round(x, 3),) * 2
    if r.random() < 0.3:
        said, joint.zero = angle(r.uniform(-0.5, 0.5))
        text += f' ref="{said}"'
    if r.random() < 0.3:
        joint.spring = round(r.uniform(1, 20), 2)
        said, joint.rest = angle(r.uniform(-0.5, 0.5))
        text += f' stiffness="{joint.spring}" springref="{said}"'
    if r.random() < 0.4:
        low, high = angle(joint.zero - r.uniform(0.3, 1)), angle(joint.zero + r.uniform(0.3, 1))
        joint.limits = (low[1], high[1])
        text += f' range="{low[0]} {high[0]}" limited="true"'
    if r.random() < 0.1:
        text = in_frame(robot, compiler, joint, pad, text)
    else:
        text += "/>"
    robot.lines.append(text)
    body.joints.append(joint)


def in_frame(robot, compiler, joint, pad, text):
    """The joint in a frame, which turns its axis; MuJoCo 2 reads no frames."""
    place = robot.vector(0.3)
    said, turn = orientation(robot, compiler)
    joint.at, joint.axis = plus(place, on(turn, joint.at)), on(turn, joint.axis)
    robot.against_mujoco = False
    return f'{pad}  <frame pos="{words(place)}"{said}>\n  {text}/>\n{pad}  </frame>'


def mjcf_solids(robot, compiler, body, pad, density):
    r = robot.r
    if r.random() < 0.4:
        mass = round(r.uniform(0.1, 5), 3)
        moments, full = robot.inertia(mass)
        at = robot.vector(0.2)
        if len(robot.bodies) % 3 == 1:
            # In the axes of its body and not in MuJoCo's order, for which libmujoco has a short way.
            at, moments = [0.0, 0.0, 0.0], sorted(moments, reverse=True)
            said, inertia = f'diaginertia="{words(moments)}"', [[moments[i] * (i == j) for j in range(3)] for i in range(3)]
        elif r.random() < 0.5:
            text, turn = orientation(robot, compiler)
            said = f'diaginertia="{words(moments)}"{text}'
            inertia = turned([[moments[i] * (i == j) for j in range(3)] for i in range(3)], turn)
        else:
            said = f'fullinertia="{words([full[0][0], full[1][1], full[2][2], full[0][1], full[0][2], full[1][2]])}"'
            inertia = full
        robot.lines.append(f'{pad}  <inertial mass="{mass}" pos="{words(at)}" {said}/>')
        body.solids.append((mass, at, inertia))
        robot.lines.append(f'{pad}  <geom type="sphere" size="0.1"/>')
        return
    for _ in range(r.choice([1, 1, 2, 3])):
        geom(robot, compiler, body, pad, density)


def geom(robot, compiler, body, pad, density):
    r = robot.r
    kind = r.choice(["sphere", "box", "capsule", "cylinder", "ellipsoid"])
    a, b, c = (round(r.uniform(0.02, 0.2), 3) for _ in range(3))
    shape = {"sphere": [a], "box": [a, b, c], "ellipsoid": [a, b, c]}.get(kind, [a, b])
    at = robot.vector(0.2)
    if kind in ("capsule", "cylinder") and r.random() < 0.5:
        end = plus(at, [0.1, 0.2, 0.3])
        half = math.sqrt(0.14) / 2
        text = f'size="{a}" fromto="{words([*at, *end])}"'
        z = [x / (2 * half) for x in (0.1, 0.2, 0.3)]
        turn = rotation([-z[1], z[0], 0.0], math.acos(z[2]))
        at, b = plus(at, [0.05, 0.1, 0.15]), half
    else:
        said, turn = orientation(robot, compiler)
        text = f'size="{words(shape)}" pos="{words(at)}"{said}'
    volume, moments = weigh(kind, a, b, c)
    mass = density * volume
    if r.random() < 0.3:
        mass = round(r.uniform(0.1, 3), 3)
        text += f' mass="{mass}"'
    robot.lines.append(f'{pad}  <geom type="{kind}" {text}/>')
    diagonal = [[mass * moments[i] * (i == j) for j in range(3)] for i in range(3)]
    body.solids.append((mass, at, turned(diagonal, turn)))


def weigh(kind, a, b, c):
    """Volume, and moments of inertia of a kilogram: a solid of revolution by its slices, where it has no formula of its own."""
    if kind == "box":
        return 8 * a * b * c, [(b * b + c * c) / 3, (a * a + c * c) / 3, (a * a + b * b) / 3]
    if kind in ("sphere", "ellipsoid"):
        b, c = (a, a) if kind == "sphere" else (b, c)
        return 4 / 3 * math.pi * a * b * c, [(b * b + c * c) / 5, (a * a + c * c) / 5, (a * a + b * b) / 5]
    # x^2 and z^2 over the mass: of a cylinder, and of two half spheres whose centres are b away.
    rod, ball = math.pi * a * a * 2 * b, 4 / 3 * math.pi * a**3 if kind == "capsule" else 0.0
    xx = rod * a * a / 4 + ball * a * a / 5
    zz = rod * b * b / 3 + ball * (a * a / 5 + b * b + 2 * b * 3 * a / 8)
    whole = rod + ball
    return whole, [(xx + zz) / whole, (xx + zz) / whole, 2 * xx / whole]


def mjcf_cord(robot):
    """A spring between two sites."""
    r = robot.r
    if sum(bool(body.joints) for body in robot.bodies) < 2 or r.random() < 0.6:
        return
    one, other = r.sample([body for body in robot.bodies if body.joints], 2)
    stiffness, damping, length = round(r.uniform(1, 30), 2), round(r.uniform(0, 2), 2), round(r.uniform(0.1, 1), 2)
    robot.lines.append(
        f'  <tendon><spatial stiffness="{stiffness}" damping="{damping}" springlength="{length}">'
        f'<site site="{one.name}_site"/><site site="{other.name}_site"/></spatial></tendon>'
    )
    robot.cords.append(((one.name, one.site[0]), (other.name, other.site[0]), stiffness, damping, length))


def mjcf_actuators(robot):
    """Drives: (name, "control", joints with ratios, force of control, length and rate)."""
    r = robot.r
    single = [j for body in robot.bodies for j in body.joints if j.dofs() == 1]
    lines = []
    if len(single) >= 2 and r.random() < 0.5:
        one, other = r.sample(single, 2)
        ratios = [round(r.uniform(-2, 2), 2) for _ in range(2)]
        robot.lines.append(
            f'  <tendon><fixed name="cord"><joint joint="{one.name}" coef="{ratios[0]}"/>'
            f'<joint joint="{other.name}" coef="{ratios[1]}"/></fixed></tendon>'
        )
        lines.append('    <motor name="pull" tendon="cord" gear="3"/>')
        robot.drives.append(
            ("pull", "control", [(one.name, 3 * ratios[0]), (other.name, 3 * ratios[1])], lambda u, x, v: u)
        )
    if r.random() < 0.4:
        body, gear = r.choice(robot.bodies), [round(r.uniform(-3, 3), 2) for _ in range(6)]
        lines.append(f'    <motor name="thrust" site="{body.name}_site" gear="{words(gear)}"/>')
        robot.drives.append(("thrust", "control", [], lambda u, x, v: u))
        robot.thrusts["thrust"] = (body.name, *body.site, gear[:3], gear[3:])
    for joint in single:
        kind = r.choice(["none", "motor", "motor", "position", "velocity", "general", "limited"])
        if kind == "none":
            continue
        gear, k = round(r.uniform(0.5, 20), 2), round(r.uniform(1, 50), 1)
        if kind == "motor":
            lines.append(f'    <motor name="{joint.name}_m" joint="{joint.name}" gear="{gear}"/>')
            law = lambda u, x, v: u
        elif kind == "position":
            lines.append(f'    <position name="{joint.name}_m" joint="{joint.name}" gear="{gear}" kp="{k}"/>')
            law = lambda u, x, v, k=k: k * (u - x)
        elif kind == "velocity":
            lines.append(f'    <velocity name="{joint.name}_m" joint="{joint.name}" gear="{gear}" kv="{k}"/>')
            law = lambda u, x, v, k=k: k * (u - v)
        elif kind == "general":
            lines.append(
                f'    <general name="{joint.name}_m" joint="{joint.name}" gear="{gear}" gaintype="fixed" gainprm="{k}" '
                f'biastype="affine" biasprm="0.5 -{k} -0.2"/>'
            )
            law = lambda u, x, v, k=k: k * u + 0.5 - k * x - 0.2 * v
        else:
            lines.append(
                f'    <general name="{joint.name}_m" joint="{joint.name}" gear="{gear}" gainprm="{k}" forcelimited="true" '
                'forcerange="-2 3"/>'
            )
            law = lambda u, x, v, k=k: min(max(k * u, -2.0), 3.0)
        robot.drives.append((f"{joint.name}_m", "control", [(joint.name, gear)], law))
    if len(single) >= 2 and r.random() < 0.25:
        mjcf_gear(robot, single)
    if lines:
        robot.lines += ["  <actuator>", *lines, "  </actuator>"]


def mjcf_gear(robot, single):
    first, second = single[-1], single[0]
    ratio, offset = round(robot.r.uniform(-1, 1), 2), round(robot.r.uniform(-0.3, 0.3), 2)
    robot.gears.append((first.name, second.name, ratio, offset))
    second.limits = (second.zero - 0.1, second.zero + 0.1)
    first.limits = None
    if robot.r.random() < 0.5:
        robot.lines.append(
            f'  <equality><joint joint1="{first.name}" joint2="{second.name}" polycoef="{offset} {ratio} 0 0 0"/></equality>'
        )
    else:
        robot.lines.append(
            f'  <tendon><fixed name="held"><joint joint="{first.name}" coef="2"/><joint joint="{second.name}" coef="{-2 * ratio}"/>'
            f'</fixed></tendon>\n  <equality><tendon tendon1="held" polycoef="{2 * offset} 1 0 0 0"/></equality>'
        )
    robot.lines = [re.sub(r' range="[^"]*" limited="true"', "", line) for line in robot.lines]


def efforts(robot, tree, position, speed, controls):
    """On each coordinate, of all drives."""
    result = [0.0] * tree.n
    motions = tree.motions(position, speed)
    for one, other, stiffness, damping, length in robot.cords:
        ends = [(motions[body], point) for body, point in (one, other)]
        at = [plus(m.at, on(m.turn, point)) for m, point in ends]
        v = [plus(m.v, cross(m.omega, on(m.turn, point))) for m, point in ends]
        gap = less(at[1], at[0])
        size = math.sqrt(dot(gap, gap))
        away = by(1 / size, gap)
        pull = stiffness * (size - length) + damping * dot(away, less(v[1], v[0]))
        for (body, point), sign in ((one, 1), (other, -1)):
            result = plus(result, tree.pushed(motions, body, point, by(sign * pull, away), [0.0] * 3))
    for (name, _, joints, law), control in zip(robot.drives, controls):
        if name in robot.thrusts:
            body, point, turn, push, twist = robot.thrusts[name]
            turn = times(motions[body].turn, turn)
            result = plus(
                result, tree.pushed(motions, body, point, by(control, on(turn, push)), by(control, on(turn, twist)))
            )
        length = sum(ratio * position[name][0] for name, ratio in joints)
        rate = sum(ratio * speed[name][0] for name, ratio in joints)
        force = control if law is None else law(control, length, rate)
        for name, ratio in joints:
            result[tree.first[name]] += ratio * force
    return result


def gear_rows(robot, tree):
    rows = []
    for first, second, ratio, _ in robot.gears:
        row = [0.0] * tree.n
        row[tree.first[first]], row[tree.first[second]] = 1.0, -ratio
        rows.append(row)
    return rows
