"""The accelerations of a tree of bodies, by Jacobians in the axes of the ground: written apart from the import and from isoc.

M = sum of m Jv'Jv + Jw'I Jw over the bodies; the bias is what the bodies need where no coordinate accelerates.
"""
import math


def rotation(axis, angle):
    """Rodrigues' formula: 1 + sin K + (1 - cos) K K."""
    n = math.sqrt(sum(a * a for a in axis))
    x, y, z = (a / n for a in axis)
    k = [[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]]
    kk = times(k, k)
    s, c = math.sin(angle), 1.0 - math.cos(angle)
    return [[(i == j) + s * k[i][j] + c * kk[i][j] for j in range(3)] for i in range(3)]


def times(a, b):
    return [[sum(a[i][k] * b[k][j] for k in range(3)) for j in range(3)] for i in range(3)]


def on(m, v):
    return [sum(m[i][k] * v[k] for k in range(3)) for i in range(3)]


def plus(*vectors):
    return [sum(parts) for parts in zip(*vectors)]


def less(a, b):
    return [x - y for x, y in zip(a, b)]


def by(s, v):
    return [s * x for x in v]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def of_quaternion(q):
    n = math.sqrt(dot(q, q))
    w, v = q[0] / n, [x / n for x in q[1:]]
    k = [[0.0, -v[2], v[1]], [v[2], 0.0, -v[0]], [-v[1], v[0], 0.0]]
    kk = times(k, k)
    return [[(i == j) + 2 * w * k[i][j] + 2 * kk[i][j] for j in range(3)] for i in range(3)]


def transposed(m):
    return [list(row) for row in zip(*m)]


def turned(inertia, m):
    return times(times(m, inertia), transposed(m))


class Joint:
    """kind: hinge, slide, ball, free. `at` and `axis` in the axes of its body; `zero` is the file's coordinate there."""

    def __init__(self, name, kind, at=(0, 0, 0), axis=(0, 0, 1), **more):
        self.name, self.kind, self.at, self.axis = name, kind, list(at), list(axis)
        self.zero = self.damping = self.spring = self.rest = self.armature = 0.0
        self.limits = None
        self.__dict__.update(more)

    def dofs(self):
        return {"hinge": 1, "slide": 1, "ball": 3, "free": 6}[self.kind]


class Body:
    """Its frame in its parent's; its solids: (mass, centre, inertia about it), in its own axes."""

    def __init__(self, name, parent, at, turn, joints):
        self.name, self.parent, self.at, self.turn, self.joints = name, parent, list(at), turn, joints
        self.solids = []


class Motion:
    """A frame: its place and axes, angular velocity and acceleration, velocity and acceleration of its origin, with no
    coordinate accelerating; and the columns of the coordinates that move it: (number, axis, point or None)."""

    def __init__(self, turn, at, gravity):
        self.turn, self.at = turn, at
        self.omega, self.alpha, self.v = [0.0] * 3, [0.0] * 3, [0.0] * 3
        self.a = by(-1.0, gravity)
        self.columns = []

    def copy(self):
        other = Motion(self.turn, self.at, [0.0] * 3)
        other.omega, other.alpha, other.v, other.a = self.omega, self.alpha, self.v, self.a
        other.columns = list(self.columns)
        return other

    def go_to(self, point):
        """The same frame with another origin, a point of the ground's axes that moves with it."""
        r = less(point, self.at)
        self.a = plus(self.a, cross(self.alpha, r), cross(self.omega, cross(self.omega, r)))
        self.v = plus(self.v, cross(self.omega, r))
        self.at = point

    def turn_by(self, numbers, axes, speeds):
        """Turns about axes through the origin."""
        relative = plus([0.0] * 3, *(by(s, e) for s, e in zip(speeds, axes)))
        self.alpha = plus(self.alpha, cross(self.omega, relative))
        self.omega = plus(self.omega, relative)
        self.columns += [(n, e, self.at) for n, e in zip(numbers, axes)]

    def slide_by(self, number, axis, place, speed):
        """A slide: the origin becomes the point that has moved."""
        moved = plus(self.at, by(place, axis))
        self.go_to(moved)
        self.a = plus(self.a, by(2 * speed, cross(self.omega, axis)))
        self.v = plus(self.v, by(speed, axis))
        self.columns.append((number, axis, None))


class Tree:
    def __init__(self, bodies, gravity):
        self.bodies, self.gravity = bodies, gravity
        self.first, self.joints, n = {}, {}, 0
        for body in bodies:
            for joint in body.joints:
                self.first[joint.name], self.joints[joint.name] = n, joint
                n += joint.dofs()
        self.n = n

    def motions(self, position, speed):
        """Of each body; position and speed by the names of joints, as MuJoCo has them."""
        found = {"world": Motion([[1.0, 0, 0], [0, 1.0, 0], [0, 0, 1.0]], [0.0] * 3, self.gravity)}
        for body in self.bodies:
            m = found[body.parent].copy()
            m.go_to(plus(m.at, on(m.turn, body.at)))
            m.turn = times(m.turn, body.turn)
            for joint in body.joints:
                self.move(m, joint, position[joint.name], speed[joint.name])
            found[body.name] = m
        return found

    def move(self, m, joint, q, v):
        first = self.first[joint.name]
        if joint.kind == "free" and q is None:  # as it is drawn
            m.columns += [(first + k, axis, None) for k, axis in enumerate([[1.0, 0, 0], [0, 1.0, 0], [0, 0, 1.0]])]
            m.turn_by(range(first + 3, first + 6), transposed(m.turn), [0.0] * 3)
            return
        if joint.kind == "free":
            m.at, m.turn = list(q[:3]), of_quaternion(q[3:])
            m.v = list(v[:3])
            unit = [[1.0, 0, 0], [0, 1.0, 0], [0, 0, 1.0]]
            m.columns += [(first + k, unit[k], None) for k in range(3)]
            m.turn_by(range(first + 3, first + 6), transposed(m.turn), v[3:])
            return
        anchor = plus(m.at, on(m.turn, joint.at))
        axis = on(m.turn, by(1 / math.sqrt(dot(joint.axis, joint.axis)), joint.axis))
        if joint.kind == "slide":
            m.slide_by(first, axis, q[0] - joint.zero, v[0])
            return
        m.go_to(anchor)
        if joint.kind == "hinge":
            m.turn_by([first], [axis], v)
            m.turn = times(rotation(axis, q[0] - joint.zero), m.turn)
        else:
            m.turn = times(m.turn, of_quaternion(q))
            m.turn_by(range(first, first + 3), transposed(m.turn), v)
        m.go_to(less(m.at, on(m.turn, joint.at)))

    def accelerations(self, position, speed, effort, rows=()):
        """q'' for efforts on the coordinates; rows of constraints J q'' = 0."""
        n = self.n
        force = list(effort)
        mass = self.mass(position, speed, force)
        for name, joint in self.joints.items():
            for k in range(joint.dofs()):
                f = self.first[name] + k
                force[f] -= joint.damping * speed[name][k]
            if joint.dofs() == 1:
                force[f] -= joint.spring * (position[name][0] - joint.rest)
            elif joint.spring:
                for k, away in enumerate(self.stretch(name, joint, position[name])):
                    force[self.first[name] + k] -= joint.spring * away
        size = n + len(rows)
        a = [[*(mass[i] if i < n else rows[i - n]), *([row[i] if i < n else 0.0 for row in rows])] for i in range(size)]
        return solve(a, force + [0.0] * len(rows))[:n]

    def mass(self, position, speed=None, force=None):
        """The mass matrix; takes from the forces what the bodies need where no coordinate accelerates."""
        n = self.n
        mass = [[0.0] * n for _ in range(n)]
        speed = speed or {name: [0.0] * joint.dofs() for name, joint in self.joints.items()}
        motions = self.motions(position, speed)
        for body in self.bodies:
            for solid in body.solids:
                self.add(mass, [0.0] * n if force is None else force, motions[body.name], solid)
        for name, joint in self.joints.items():
            for f in range(self.first[name], self.first[name] + joint.dofs()):
                mass[f][f] += joint.armature
        return mass

    def stretch(self, name, joint, q):
        """How far a ball or a free joint is from where it is drawn: along the ground's axes, and its angle about its axis, in
        its own axes."""
        body = next(body for body in self.bodies if joint in body.joints)
        drawn = body.turn if joint.kind == "free" else [[1.0, 0, 0], [0, 1.0, 0], [0, 0, 1.0]]
        turn = times(transposed(drawn), of_quaternion(q[-4:]))
        sine = [(turn[k - 1][k - 2] - turn[k - 2][k - 1]) / 2 for k in range(3)]
        size = math.sqrt(dot(sine, sine))
        angle = math.atan2(size, (turn[0][0] + turn[1][1] + turn[2][2] - 1) / 2)
        slid = less(q[:3], body.at) if joint.kind == "free" else []
        return [*slid, *by(angle / size, sine)]

    def add(self, mass, force, motion, solid):
        m, centre, inertia = solid
        at = motion.copy()
        at.go_to(plus(at.at, on(at.turn, centre)))
        whole = turned(inertia, at.turn)
        turning = plus(on(whole, at.alpha), cross(at.omega, on(whole, at.omega)))
        columns = [
            (n, e, [0.0] * 3) if point is None else (n, cross(e, less(at.at, point)), e) for n, e, point in at.columns
        ]
        for i, vi, wi in columns:
            force[i] -= m * dot(vi, at.a) + dot(wi, turning)
            heavy = on(whole, wi)
            for j, vj, wj in columns:
                mass[i][j] += m * dot(vi, vj) + dot(heavy, wj)

    def pushed(self, motions, body, point, force, moment):
        """The efforts on all coordinates of a force at a point of a body, and of a moment on it, in the axes of the ground."""
        result = [0.0] * self.n
        m = motions[body]
        at = plus(m.at, on(m.turn, point))
        for n, e, through in m.columns:
            result[n] += dot(force, e) if through is None else dot(force, cross(e, less(at, through))) + dot(moment, e)
        return result


def solve(a, b):
    """Gauss with pivots."""
    n = len(b)
    a = [row + [x] for row, x in zip(a, b)]
    for k in range(n):
        p = max(range(k, n), key=lambda i: abs(a[i][k]))
        a[k], a[p] = a[p], a[k]
        for i in range(k + 1, n):
            f = a[i][k] / a[k][k]
            for j in range(k, n + 1):
                a[i][j] -= f * a[k][j]
    x = [0.0] * n
    for i in reversed(range(n)):
        x[i] = (a[i][n] - sum(a[i][j] * x[j] for j in range(i + 1, n))) / a[i][i]
    return x
