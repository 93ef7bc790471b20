"""What the laws of the library share: their registry, classical RK4, the damping of an impact, vectors, and noise.

A law is a function of rows, dictionaries of what the scene shows by name. It gives for each row what its outputs are, by name:
a number, or a number and its tolerance.
"""
import math

STEP = 1e-3  # of the scene, in s
GRAVITY = 9.81  # its gravity, in m/s^2, down
ROUNDING = 1e4 * 2.0**-53  # relative to 1 + the number: some thousand roundings of terms that are not greater than this
LAWS = {}  # by kind: statements, outputs (name, text, columns), function


def law(kind, statements, outputs):
    """Enters the function that follows as the law of a kind. Outputs are lines: `name = text`, `name:3 = text` of 3 columns."""

    def enter(function):
        shown = []
        for line in filter(None, map(str.strip, outputs.splitlines())):
            name, text = line.split(" = ", 1)
            name, _, columns = name.partition(":")
            shown.append((name, text, int(columns or 1)))
        LAWS[kind] = (statements, shown, function)
        return function

    return enter


def rows_of(function):
    """A law without memory: of one row alone, and its number."""
    return lambda rows: [function(row, k) for k, row in enumerate(rows)]


def rk4(f, x, h=STEP):
    """One step of the classical method of Kutta (1901) of x' = f(x), for a list x."""
    a = f(x)
    b = f([u + h / 2 * v for u, v in zip(x, a)])
    c = f([u + h / 2 * v for u, v in zip(x, b)])
    d = f([u + h * v for u, v in zip(x, c)])
    return [u + h / 6 * (p + 2 * q + 2 * r + s) for u, p, q, r, s in zip(x, a, b, c, d)]


def run(f, x, rows):
    """The states in all rows: f(x, row) with the inputs of the row, which are held in a step."""
    states = [x]
    for row in rows[:-1]:
        states.append(rk4(lambda y, row=row: f(y, row), states[-1]))
    return states


def impact_damping(rest):
    """d of d (1 + rest) = ln((1 + d) / (1 - rest d)), by bisection: it is below 1 / rest, and above 0."""
    low, high = 1e-9, 1 / rest
    for _ in range(200):
        d = (low + high) / 2
        if rest * d < 1 and math.log((1 + d) / (1 - rest * d)) < d * (1 + rest):
            low = d
        else:
            high = d
    return low


def hunt_crossley(stiffness, moved, depth, approach, impact, rest):
    """The force of an end stop against a mass: that of the depth a lead later, damped in proportion to it up to a depth that
    no impact of the speed `impact` reaches; never a pull."""
    d = impact_damping(rest)
    later = max(depth + IMPACT_LEAD * approach, 0.0)
    damped = min(later, impact * math.sqrt(2 * moved / (stiffness * (1 + d))))
    return max(stiffness * (later + d * approach / impact * damped), 0.0)


def half_of_stable(direction):
    """Half of the way in this direction of the plane on which rk4 is stable: 1 + z + z^2 / 2 + z^3 / 6 + z^4 / 24 is within 1;
    the way to four decimals, as tools/isoc/README.md has it."""
    low, high = 1.0, 4.0
    for _ in range(60):
        size = (low + high) / 2
        z = size * direction
        low, high = (size, high) if abs(1 + z * (1 + z / 2 * (1 + z / 3 * (1 + z / 4)))) <= 1 else (low, size)
    return round(low, 4) / 2


STABLE_RATE = half_of_stable(-1) / STEP  # of what decays
# Of an impact on rk4, as tools/isoc/README.md has it.
IMPACT_FREQUENCY, IMPACT_LEAD = math.pi / 16 / STEP, 0.0091 * STEP


def clamp(x, low, high):
    return low if x < low else high if x > high else x


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def dot(a, b):
    return sum(u * v for u, v in zip(a, b))


def sum_of(a, b, factor=1.0):
    return [u + factor * v for u, v in zip(a, b)]


def scaled(factor, a):
    return [factor * u for u in a]


def turned(q, v):
    """A vector in the axes of a body, with its orientation q = (w, x, y, z), in those of the ground."""
    twice = scaled(2.0, cross(q[1:], v))
    return sum_of(sum_of(v, twice, q[0]), cross(q[1:], twice))


def turned_back(q, v):
    return turned([q[0], -q[1], -q[2], -q[3]], v)


def noise(tick, seed):
    """Noise as core/numbers/noise.h says: two keys, three rounds, 16 pairs of bits with partial sums, and the fill."""
    bits32 = 2**32

    def rounds(x, key):
        for shift, factor, added in ((17, 0xED5AD4BB, key), (11, 0xAC4C1B51, 0), (15, 0x31848BAB, 0)):
            x = ((x ^ x >> shift) * factor + added) % bits32
        return x ^ x >> 14

    low = rounds((tick + rounds(seed, 0x9E3779B9)) % bits32, seed * 0x7FEB352D + tick // bits32)
    total, of_pairs = 0, 0
    for byte in range(4):
        total += sum(low >> (8 * byte + 2 * pair) & 3 for pair in range(4))
        of_pairs += total << 8 * byte
    # A byte has the mean 6 and the variance 5; the fill is uniform up to 2^24. The mean is a whole number: 0 within
    # 1e-8.
    weights = [sum(2.0**-shift for shift in range(0, 8 * n, 8)) for n in (1, 2, 3, 4)]
    whole = round(6 * sum(weights) * 2.0**24 + 2.0**23)
    variance = 5 * sum(w * w for w in weights) * 2.0**48 + 2.0**48 / 12
    return (of_pairs % bits32 + (low * 0x31848BAB % bits32 >> 8) - whole) / math.sqrt(variance)
