"""Places: a point and a turn, as a body has them in its parent. Quarter turns are exact."""
import math

X, Y, Z = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)
UNTURNED = (X, Y, Z)
QUARTER = math.pi / 2


def add(a, b):
    return tuple(x + y for x, y in zip(a, b))


def minus(a, b):
    return tuple(x - y for x, y in zip(a, b))


def scale(s, a):
    return tuple(s * x for x in a)


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def norm(a):
    return math.sqrt(dot(a, a))


def apply(m, v):
    return tuple(dot(row, v) for row in m)


def transpose(m):
    return tuple(zip(*m))


def product(a, b):
    columns = transpose(b)
    return tuple(tuple(dot(row, column) for column in columns) for row in a)


def sincos(angle):
    """Exact for whole quarter turns."""
    quarters = round(angle / QUARTER)
    if abs(angle - quarters * QUARTER) < 1e-15 * max(1, abs(quarters)):
        return ((0.0, 1.0), (1.0, 0.0), (0.0, -1.0), (-1.0, 0.0))[quarters % 4]
    return math.sin(angle), math.cos(angle)


def about(axis, angle):
    """The matrix of a turn about an axis."""
    s, c = sincos(angle)
    size = norm(axis)
    x, y, z = (component / size for component in axis)
    v = 1 - c
    return (
        (x * x * v + c, x * y * v - z * s, x * z * v + y * s),
        (x * y * v + z * s, y * y * v + c, y * z * v - x * s),
        (x * z * v - y * s, y * z * v + x * s, z * z * v + c),
    )


def tidy(m):
    """A matrix without rounding errors beside 0, 1 and -1."""
    return tuple(tuple(float(round(x)) if abs(x - round(x)) < 1e-14 else x for x in row) for row in m)


def of_quaternion(q):
    """The matrix of a quaternion (w, x, y, z) of any length."""
    n = dot(q, q)
    w, x, y, z = q
    return tidy(
        (
            ((w * w + x * x - y * y - z * z) / n, 2 * (x * y - w * z) / n, 2 * (x * z + w * y) / n),
            (2 * (x * y + w * z) / n, (w * w - x * x + y * y - z * z) / n, 2 * (y * z - w * x) / n),
            (2 * (x * z - w * y) / n, 2 * (y * z + w * x) / n, (w * w - x * x - y * y + z * z) / n),
        )
    )


def quaternion(m):
    """The quaternion of a turn; its largest component is computed first, and positive."""
    squares = (
        1 + m[0][0] + m[1][1] + m[2][2],
        1 + m[0][0] - m[1][1] - m[2][2],
        1 - m[0][0] + m[1][1] - m[2][2],
        1 - m[0][0] - m[1][1] + m[2][2],
    )
    a, b, c = m[2][1] - m[1][2], m[0][2] - m[2][0], m[1][0] - m[0][1]
    d, e, f = m[1][0] + m[0][1], m[0][2] + m[2][0], m[2][1] + m[1][2]
    rows = ((squares[0], a, b, c), (a, squares[1], d, e), (b, d, squares[2], f), (c, e, f, squares[3]))
    row = rows[squares.index(max(squares))]
    return scale(1 / norm(row), row)


class Place:
    """A point and a turn. `turns` has the turn as turns about one axis after the other, where these are known."""

    def __init__(self, at=(0.0, 0.0, 0.0), turn=UNTURNED, turns=None):
        self.at = tuple(at)
        self.turn = tidy(turn)
        self.turns = turns if turns is not None else ([] if self.turn == UNTURNED else None)

    def __mul__(self, other):
        """The other one, which stands in this."""
        turns = None
        if self.turns is not None and other.turns is not None and len(self.turns) + len(other.turns) <= 3:
            turns = self.turns + other.turns
        return Place(self.point(other.at), product(self.turn, other.turn), turns)

    def point(self, p):
        return add(self.at, apply(self.turn, p))

    def inverse(self):
        turn = transpose(self.turn)
        return Place(scale(-1.0, apply(turn, self.at)), turn)

    def steps(self):
        """Turns about axes, one after the other, each in the axes of the last one: (angle, axis)."""
        if self.turn == UNTURNED:
            return []
        w, *v = quaternion(self.turn)
        if w < 0:
            w, v = -w, [-x for x in v]
        if sum(abs(x) > 1e-14 for x in v) == 1:
            k = max(range(3), key=lambda i: abs(v[i]))
            return [(2 * math.atan2(v[k], w), UNTURNED[k])]
        if self.turns is not None:
            return self.turns
        return [(2 * math.atan2(norm(v), w), tuple(v))]


def turned(steps, at=(0.0, 0.0, 0.0)):
    """The place at a point, turned by (angle, axis) one after the other."""
    steps = [(angle, axis) for angle, axis in steps if angle != 0.0]
    turn = UNTURNED
    for angle, axis in steps:
        turn = product(turn, about(axis, angle))
    return Place(at, turn, steps)


def to_axis(axis):
    """The least turn that takes z to an axis."""
    to = scale(1 / norm(axis), axis)
    across = cross(Z, to)
    if norm(across) < 1e-15:
        return UNTURNED if to[2] > 0 else turned([(math.pi, X)]).turn
    return of_quaternion((1 + dot(Z, to), *across))


def quarter_of(text):
    """The number of an angle in rad, and whether it is a quarter turn as far as it is written: 1.5708, 3.14159."""
    value = float(text)
    quarters = round(value / QUARTER)
    mantissa, _, exponent = text.lower().partition("e")
    decimals = len(mantissa.partition(".")[2]) - int(exponent or 0)
    if quarters != 0 and decimals >= 4 and abs(value - quarters * QUARTER) <= 0.51 * 10.0**-decimals:
        return quarters * QUARTER, value != quarters * QUARTER
    return value, False
