"""A four-bar of three rods, as a scene and as one equation of its crank q: J q'' = -V' - J' q'^2 / 2."""
import functools
import math

CRANK, COUPLER, ROCKER, GROUND = 0.3, 0.9, 0.7, 1.0


def scene(start):
    return f'''gravity (0, -9.81, 0) m/s^2
body crank {{ rod {CRANK} m of 1 kg at ({CRANK / 2}, 0, 0) m rotate 90 deg about y }}
body coupler {{ rod {COUPLER} m of 2 kg at ({COUPLER / 2}, 0, 0) m rotate 90 deg about y }}
body rocker {{ rod {ROCKER} m of 1 kg at ({ROCKER / 2}, 0, 0) m rotate 90 deg about y }}
joint a revolute {{ parent ground; child crank; axis z; {start} }}
joint b revolute {{ parent crank at ({CRANK}, 0, 0) m; child coupler; axis z; start about -40 deg }}
joint c revolute {{ parent ground at ({GROUND}, 0, 0) m; child rocker; axis z; start about 110 deg }}
close d revolute {{ parent coupler at ({COUPLER}, 0, 0) m; child rocker at ({ROCKER}, 0, 0) m; axis z }}'''


def places(q):
    """Angles of the coupler and the rocker, by the two circles that meet; and the end of the crank."""
    x, y = CRANK * math.cos(q), CRANK * math.sin(q)
    far = math.hypot(GROUND - x, y)
    along = (COUPLER ** 2 - ROCKER ** 2 + far ** 2) / (2 * far)
    up, line = math.sqrt(COUPLER ** 2 - along ** 2), math.atan2(-y, GROUND - x)
    px = x + along * math.cos(line) - up * math.sin(line)
    py = y + along * math.sin(line) + up * math.cos(line)
    return math.atan2(py - y, px - x), math.atan2(py, px - GROUND), x, y


def rates(q):
    """Of the coupler and the rocker, by the angle of the crank: along the coupler, and along the rocker, the speeds of
    both ends are equal."""
    b, c, _, _ = places(q)
    return [CRANK * math.sin(c - q) / (COUPLER * math.sin(b - c)), CRANK * math.sin(q - b) / (ROCKER * math.sin(c - b))]


@functools.lru_cache(100)
def inertia_and_potential(q):
    rate = rates(q)
    b, c, x, y = places(q)
    vx = -CRANK * math.sin(q) - COUPLER / 2 * math.sin(b) * rate[0]
    vy = CRANK * math.cos(q) + COUPLER / 2 * math.cos(b) * rate[0]
    inertia = CRANK ** 2 / 3 + 2 * (vx ** 2 + vy ** 2 + COUPLER ** 2 / 12 * rate[0] ** 2) + ROCKER ** 2 / 3 * rate[1] ** 2
    height = CRANK / 2 * math.sin(q) + 2 * (y + COUPLER / 2 * math.sin(b)) + ROCKER / 2 * math.sin(c)
    return inertia, 9.81 * height


def inertia(q):
    return inertia_and_potential(q)[0]


def effort(q, v, d=1e-3):
    """Of gravity and inertia, on the crank."""
    at = [inertia_and_potential(q + k * d) for k in (-2, -1, 1, 2)]
    slopes = [(at[0][i] - 8 * at[1][i] + 8 * at[2][i] - at[3][i]) / (12 * d) for i in (0, 1)]
    return -(slopes[1] + 0.5 * slopes[0] * v ** 2)
