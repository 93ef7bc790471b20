"""Random robots of what files have beside the usual: inertias that no body has, armatures on free and ball joints, springs of
balls, springdamper, dampratio, inheritrange, gravcomp, actuatorfrcrange, meshes, and roots of URDF that float.

`plain` is the file for libmujoco 2, which knows no gravcomp, actuatorfrcrange and dampratio, and refuses such an inertia:
tests/tools/import/compare.c gives it these by its own mass matrix and forces."""
import math
import os
import random
import re
import struct

import generate
from dynamics import Body, Joint, by, dot, less, of_quaternion, on, plus, rotation, solve, times, transposed, turned
from generate import IDENTITY, Robot, words

NEWER = re.compile(r' (gravcomp|actuatorfrcrange|actuatorgravcomp|dampratio|inheritrange)="[^"]*"')


class OddRobot(Robot):
    def __init__(self, seed):
        super().__init__(seed)
        self.chance = random.Random(seed + 7)
        self.is_odd = self.chance.random() < 0.5  # else springdamper, of whose inertias libmujoco has to be right
        self.swaps = []  # (text, what is plain)
        self.number = seed

    def inertia(self, mass):
        moments, full = super().inertia(mass)
        if not self.is_odd or self.chance.random() < 0.4:
            return moments, full
        self.odd = True
        moments[2] = (moments[0] + moments[1]) * (1 + self.chance.uniform(1e-3, 0.15))
        diagonal = [[moments[i] * (i == j) for j in range(3)] for i in range(3)]
        return moments, turned(diagonal, rotation(self.axis(), self.chance.uniform(-3, 3)))

    def swap(self, text, plain):
        self.swaps.append((text, plain))
        return text

    def plain(self):
        text = self.text()
        for odd, possible in self.swaps:
            assert text.count(odd) == 1
            text = text.replace(odd, possible)
        return NEWER.sub("", text)


# --- URDF ---


def urdf(seed):
    """A robot of URDF whose inertias no body has; its root floats, by a joint of the file or by --floating."""
    robot = OddRobot(seed)
    generate.urdf(seed, robot)
    for k, line in enumerate(robot.lines):
        if line.lstrip().startswith("<inertia ") and robot.is_odd:
            robot.lines[k] = robot.swap(line, '<inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/>')
    base, = (k for k, line in enumerate(robot.lines) if '<link name="base"/>' in line)
    if any(body.joints and body.joints[0].kind == "free" for body in robot.bodies):
        return robot
    robot.floating = True
    inertial = "\n".join(generate.urdf_inertial(robot, "base"))
    if robot.is_odd:
        line = next(line for line in inertial.split("\n") if "<inertia " in line)
        robot.swap(line, '<inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/>')
    robot.lines[base] = robot.lines[base].replace('<link name="base"/>', inertial)
    robot.swap(
        "</robot>",
        '<link name="world"/><joint name="floating_base" type="floating"><parent link="world"/><child link="base"/></joint></robot>',
    )
    root = Body("base", "world", [0.0] * 3, IDENTITY, [Joint("floating_base", "free")])
    root.solids.append(robot.last)
    for body in robot.bodies:
        body.parent = "base" if body.parent == "world" else body.parent
    robot.bodies.insert(0, root)
    return robot


# --- MJCF ---


def mjcf(seed, folder):
    robot = OddRobot(seed)
    r = robot.r
    robot.suffix = "xml"
    robot.folder = folder
    robot.gravity = robot.vector(10)
    robot.assets = []
    tree = []
    count = r.randrange(3, 7)
    for k in range(count):
        body(robot, k, r.choice(tree[-2:]) if tree and r.random() < 0.8 else "world")
        tree.append(f"body{k}")
    servos = actuators(robot)
    resolve(robot, servos)
    servo, (kp, kv) = "", robot.servo
    if robot.servo != (1.0, 0.0):
        servo = robot.swap(
            f'<position kp="{kp}" kv="{kv}"/>', f'<general gainprm="{kp}" biastype="affine" biasprm="0 {-kp} {-kv}"/>'
        )
    robot.lines = [
        '<mujoco model="odd">',
        f'  <compiler angle="radian" exactmeshinertia="true" meshdir="meshes"/>',
        f'  <option timestep="0.001" gravity="{words(robot.gravity)}"/>',
        f'  <default><joint armature="0.03" damping="0.1"/><geom density="700"/>{servo}</default>',
        f'  <asset>{"".join(robot.assets)}</asset>',
        "  <worldbody>",
        *nested(robot, "world", 2),
        "  </worldbody>",
        "  <actuator>",
        *robot.actuators,
        "  </actuator>",
        "</mujoco>",
    ]
    return robot


def nested(robot, parent, depth):
    for one in robot.bodies:
        if one.parent == parent:
            yield from ("  " * depth + line for line in one.lines)
            yield from nested(robot, one.name, depth + 1)
            yield "  " * depth + "</body>"


def body(robot, k, parent):
    r = robot.r
    at, q = robot.vector(0.5), [r.gauss(0, 1) for _ in range(4)]
    q = [x / math.sqrt(dot(q, q)) for x in q]
    made = Body(f"body{k}", parent, at, of_quaternion(q), [])
    made.lines = [f'<body name="{made.name}" pos="{words(at)}" quat="{words(q)}"']
    robot.bodies.append(made)
    if r.random() < 0.5:
        share = round(r.uniform(-0.5, 1.5), 2)
        made.lines[0] += f' gravcomp="{share}"'
        robot.lifts.append((made.name, share))
    made.lines[0] += ">"
    kind = r.choice(["free", "ball"]) if parent == "world" and r.random() < 0.6 else r.choice(["hinge", "hinge", "slide", "ball"])
    joint(robot, made, kind)
    if r.random() < 0.6:
        inertial(robot, made)
    else:
        mesh(robot, made)


def joint(robot, made, kind):
    r = robot.r
    one = Joint(f"{made.name}_j", kind, axis=robot.axis(), damping=0.1, armature=0.03)
    one.at = [0.0] * 3 if kind == "free" else robot.vector(0.2)
    one.timing = None
    text = f'  <joint name="{one.name}" type="{kind}" pos="{words(one.at)}" axis="{words(one.axis)}"'
    if r.random() < 0.6:
        one.armature = round(r.uniform(0.005, 0.5), 3)
        text += f' armature="{one.armature}"'
    if one.dofs() == 1 and r.random() < 0.3:
        one.zero = round(r.uniform(-0.5, 0.5), 2)
        text += f' ref="{one.zero}"'
    one.rest = one.zero if one.dofs() == 1 and not r.random() < 0.3 else 0.0
    if one.dofs() == 1:
        text += f' springref="{one.rest}"'
    if not robot.is_odd and r.random() < 0.5:
        one.timing = (round(r.uniform(0.05, 1), 2), round(r.uniform(0.1, 2), 2))
        text += f' springdamper="{words(one.timing)}" stiffness="9" damping="9"'
    elif r.random() < 0.5:
        one.spring = round(r.uniform(1, 20), 2)
        text += f' stiffness="{one.spring}"'
    if one.dofs() == 1:
        one.limits = (round(one.zero - r.uniform(0.5, 2), 2), round(one.zero + r.uniform(0.5, 2), 2))
        text += f' range="{words(one.limits)}" limited="true"'
        if r.random() < 0.6:
            counts = r.random() < 0.5
            most = r.choice([2, 50])
            robot.effort_limits[one.name] = (round(-r.uniform(0.1, most), 2), round(r.uniform(0.1, most), 2), counts)
            text += f' actuatorfrcrange="{words(robot.effort_limits[one.name][:2])}"'
            text += ' actuatorgravcomp="true"' if counts else ""
    made.lines.append(text + "/>")
    made.joints.append(one)


def inertial(robot, made):
    mass = round(robot.r.uniform(0.3, 3), 3)
    robot.odd = False
    moments, full = robot.inertia(mass)
    at = robot.vector(0.2)
    said = f'fullinertia="{words([full[0][0], full[1][1], full[2][2], full[0][1], full[0][2], full[1][2]])}"'
    if robot.odd:
        robot.swap(said, 'diaginertia="1 1 1"')
    made.lines.append(f'  <inertial mass="{mass}" pos="{words(at)}" {said}/>')
    made.solids.append((mass, at, full))


def actuators(robot):
    """Drives, and of those with a damping ratio what makes their damping."""
    r, servos = robot.r, []
    robot.actuators = []
    kp0, kv0 = robot.servo = (round(r.uniform(1, 30), 1), round(r.uniform(0, 3), 2)) if r.random() < 0.5 else (1.0, 0.0)
    for one in (j for made in robot.bodies for j in made.joints if j.dofs() == 1):
        for k in range(r.choice([1, 1, 2])):
            name, gear = f"{one.name}_m{k}", round(r.uniform(0.5, 5) * r.choice([1, 1, -1]), 2)
            if r.random() < 0.4:
                robot.actuators.append(f'    <motor name="{name}" joint="{one.name}" gear="{gear}"/>')
                robot.drives.append((name, "control", [(one.name, gear)], lambda u, x, v: u))
                continue
            if r.random() < 0.3 and robot.servo != (1.0, 0.0):  # of a general one the default of a servo is the bias
                gain = round(kp0 + r.uniform(1, 5), 1)
                robot.actuators.append(f'    <general name="{name}" joint="{one.name}" gear="{gear}" gainprm="{gain}"/>')
                law = lambda u, x, v, gain=gain: gain * u - kp0 * x - kv0 * v
                robot.drives.append((name, "control", [(one.name, gear)], law))
                continue
            kp = round(r.uniform(1, 50), 1)
            text = f'    <position name="{name}" joint="{one.name}" gear="{gear}" kp="{kp}"'
            servo = {"name": name, "joint": one.name, "gear": gear, "kp": kp, "kv": kv0, "ratio": 0.0}
            if r.random() < 0.7:
                servo["ratio"] = round(r.uniform(0.1, 2), 2)
                text += f' dampratio="{servo["ratio"]}"'
            if r.random() < 0.5:
                share = round(r.uniform(0.5, 1.5), 2)
                middle, radius = sum(one.limits) / 2, (one.limits[1] - one.limits[0]) / 2 * share
                text += f' inheritrange="{share}"'
                robot.input_limits[name] = (middle - radius, middle + radius)
            robot.actuators.append(text + "/>")
            if kv0 and not servo["ratio"]:  # the damping of a default, which a servo of version 2 has not
                robot.swap(text, f'    <general name="{name}" joint="{one.name}" gear="{gear}" gainprm="{kp}" biasprm="0 {-kp} {-kv0}"')
            servos.append(servo)
            robot.drives.append((name, "control", [(one.name, gear)], lambda u, x, v, s=servo: s["kp"] * (u - x) - s["kv"] * v))
    return servos


def resolve(robot, servos):
    """springdamper and dampratio, by the masses where all is as it is drawn."""
    tree = robot.tree()
    names = tree.joints
    drawn = {name: [1.0, 0.0, 0.0, 0.0] if j.kind == "ball" else [j.zero] if j.dofs() == 1 else None for name, j in names.items()}
    mass = tree.mass(drawn)
    for name, one in names.items():
        if one.timing:
            first, count = tree.first[name], one.dofs()
            inverse = [solve(mass, [float(i == first + k) for i in range(tree.n)])[first + k] for k in range(count)]
            inertia = count / sum(inverse)
            one.spring = inertia / (one.timing[0] * one.timing[1]) ** 2
            one.damping = 2 * inertia / one.timing[0]
    for servo in servos:
        if servo["ratio"]:
            k = tree.first[servo["joint"]]
            servo["kv"] = 2 * servo["ratio"] * math.sqrt(servo["kp"] * mass[k][k] / servo["gear"] ** 2)
            robot.ratios.append((servo["name"], servo["ratio"]))


def efforts(robot, tree, position, speed, controls):
    """Of drives and of lifts: on a joint with limits those within these, of drives and, where they count, of lifts."""
    of_drives = generate.efforts(robot, tree, position, speed, controls)
    motions, of_lifts = tree.motions(position, speed), [0.0] * tree.n
    for name, share in robot.lifts:
        mass, centre, _ = generate.joined(next(b for b in robot.bodies if b.name == name).solids)
        lift = by(-share * mass, robot.gravity)
        of_lifts = plus(of_lifts, tree.pushed(motions, name, centre, lift, [0.0] * 3))
    for name, (low, high, counts) in robot.effort_limits.items():
        k = tree.first[name]
        if counts:
            of_drives[k], of_lifts[k] = of_drives[k] + of_lifts[k], 0.0
        of_drives[k] = min(max(of_drives[k], low), high)
    return plus(of_drives, of_lifts)


# --- meshes: shapes whose volume and inertia follow from symmetry, sheared and placed ---


def cube():
    """Corners from -1 to 1; volume, and mean of x x' of each axis."""
    points = [(float(x), float(y), float(z)) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]
    faces = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    return points, faces, 8.0, 1 / 3


def octahedron():
    points = [tuple(float(s * (i == k)) for i in range(3)) for k in range(3) for s in (1, -1)]
    faces = []
    for i in range(8):
        a, b, c = (2 * k + (i >> k & 1) for k in range(3))
        faces.append((a, b, c) if bin(i).count("1") % 2 == 0 else (a, c, b))
    return points, faces, 4 / 3, 1 / 10


def mesh(robot, made):
    """A shape whose corners are numbers of floats; with a scale, and a place of its own."""
    r = robot.r
    points, faces, volume, mean = r.choice([cube, octahedron])()
    shear = [[r.randrange(20, 60) / 256 * (i == j) + r.randrange(-8, 9) / 256 * (i != j) for j in range(3)] for i in range(3)]
    middle = [r.randrange(-20, 21) / 128 for _ in range(3)]
    points = [plus(middle, on(shear, p)) for p in points]
    factors = [r.choice([0.5, 1.0, 2.0]) for _ in range(3)]
    factors[0] *= r.choice([1, 1, -1])
    at, q = robot.vector(0.2), [1.0, round(r.uniform(-1, 1), 2), 0.5, round(r.uniform(-1, 1), 2)]
    turn = of_quaternion(q)
    refpos, refq = [r.randrange(-16, 17) / 128 for _ in range(3)], [1.0, round(r.uniform(-1, 1), 2), 0.25, 0.0]
    whole = [[factors[i] * x for x in row] for i, row in enumerate(transposed(of_quaternion(refq)))]
    centre = plus(at, on(turn, on(whole, less(middle, refpos))))
    matrix = times(turn, times(whole, shear))
    size = volume * abs(determinant(matrix))
    mass = 700 * size
    text = ""
    if r.random() < 0.4:
        mass = round(r.uniform(0.3, 2), 3)
        text = f' mass="{mass}"'
    second = [[mass * mean * dot(matrix[i], matrix[j]) for j in range(3)] for i in range(3)]
    trace = sum(second[i][i] for i in range(3))
    inertia = [[trace * (i == j) - second[i][j] for j in range(3)] for i in range(3)]
    ending = r.choice(["stl", "obj", "text.stl"]) if robot.chance.random() < 0.5 else "stl"
    name = f"{made.name}_{robot.number}"
    robot.of_meshes.add(made.name)
    write_mesh(os.path.join(robot.folder, "meshes", f"{name}.{ending}"), points, faces)
    robot.assets.append(
        f'<mesh name="{name}" file="{name}.{ending}" scale="{words(factors)}" refpos="{words(refpos)}" refquat="{words(refq)}"/>'
    )
    if ending == "text.stl":  # libmujoco reads binary ones
        write_mesh(os.path.join(robot.folder, "meshes", f"{name}.stl"), points, faces)
        robot.swap(f'file="{name}.{ending}"', f'file="{name}.stl"')
    made.lines.append(f'  <geom type="mesh" mesh="{name}" pos="{words(at)}" quat="{words(q)}"{text}/>')
    made.solids.append((mass, centre, inertia))


def determinant(m):
    return dot(m[0], [m[1][1] * m[2][2] - m[1][2] * m[2][1], m[1][2] * m[2][0] - m[1][0] * m[2][2], m[1][0] * m[2][1] - m[1][1] * m[2][0]])


def write_mesh(path, points, faces):
    os.makedirs(os.path.dirname(path), exist_ok=True)
    fans = [(face[0], face[k], face[k + 1]) for face in faces for k in range(1, len(face) - 1)]
    if path.endswith(".obj"):
        lines = [f"v {words(p)}" for p in points] + ["f " + " ".join(f"{k + 1}//1" for k in face) for face in faces]
        lines.insert(len(points), "vn 0 0 1")
        data = ("\n".join(lines) + "\n").encode()
    elif path.endswith(".text.stl"):
        corners = ["".join(f"vertex {words(points[k])}\n" for k in fan) for fan in fans]
        data = ("solid s\n" + "".join(f"facet normal 0 0 0\nouter loop\n{c}endloop\nendfacet\n" for c in corners) + "endsolid s\n").encode()
    else:
        rows = [struct.pack("<12fH", 0, 0, 0, *(x for k in fan for x in points[k]), 0) for fan in fans]
        data = b"solid, but binary".ljust(80) + struct.pack("<I", len(fans)) + b"".join(rows)
    with open(path, "wb") as file:
        file.write(data)
