"""Random planar loops that come near a singular position, as scenes without losses.

Kinds by turns: a four-bar that is nearly a parallelogram, a slider-crank whose rod is nearly as long as its crank, a four-bar
whose parts are nearly in one line at a dead centre, and a five-bar with two freedoms, which comes as near as chance will have.
`how_near`, in m, is how much the first three lack to a singular position; by itself from 1e-5 to 0.3, at random.
"""
import math
import random


def drawn(seed, how_near=None):
    draw = random.Random(seed)
    near = 10 ** draw.uniform(-5, -0.5)
    near = near if how_near is None else how_near
    kind = seed % 4

    def rod(name, length):
        half, mass = length / 2, draw.uniform(0.5, 2)
        return f"body {name} {{ rod {length!r} m of {mass!r} kg at ({half!r}, 0, 0) m rotate 90 deg about y }}"

    crank, coupler = draw.uniform(0.2, 0.5), draw.uniform(0.6, 1)
    speed, start = draw.choice((-1, 1)) * draw.uniform(3, 12), draw.uniform(0.6, 2.2)
    if kind == 1:
        length = crank + near
        bodies = [rod("crank", crank), rod("coupler", length), "body slider { mass 1 kg }"]
        turned = -start - math.asin(crank * math.sin(start) / length)
        last = [f"joint C prismatic {{ parent ground; child slider; axis x; start about "
                f"{crank * math.cos(start) + length * math.cos(start + turned)!r} m }}"]
        close = f"close loop line {{ parent slider; child coupler at ({length!r}, 0, 0) m; axis z }}"
        last.append(close)
    elif kind == 3:
        lengths = [crank, coupler, draw.uniform(0.6, 1), draw.uniform(0.2, 0.5)]
        angles = [start, start - draw.uniform(0.5, 2), 0, 0]
        angles[2] = angles[1] - draw.uniform(0.5, 1.5)
        angles[3] = angles[2] - draw.uniform(0.5, 1.5)
        end = [sum(length * f(angle) for length, angle in zip(lengths, angles)) for f in (math.cos, math.sin)]
        bodies = [rod(name, length) for name, length in zip(("crank", "coupler", "second", "rocker"), lengths)]
        last = [f"joint C revolute {{ parent coupler at ({lengths[1]!r}, 0, 0) m; child second; axis z; "
                f"start {angles[2] - angles[1]!r} rad; speed {draw.uniform(-3, 3)!r} rad/s }}",
                f"joint D revolute {{ parent second at ({lengths[2]!r}, 0, 0) m; child rocker; axis z; "
                f"start about {angles[3] - angles[2]!r} rad }}",
                f"close loop line {{ parent ground at ({end[0]!r}, {end[1]!r}, 0) m; "
                f"child rocker at ({lengths[3]!r}, 0, 0) m; axis z }}"]
        turned = angles[1] - angles[0]
    else:
        rocker, ground = (crank + near, coupler) if kind == 0 else (coupler, crank + near)
        bodies = [rod("crank", crank), rod("coupler", coupler), rod("rocker", rocker)]
        turned = -start
        last = [f"joint C revolute {{ parent ground at ({ground!r}, 0, 0) m; child rocker; axis z; start about {start!r} rad }}",
                f"close loop line {{ parent coupler at ({coupler!r}, 0, 0) m; child rocker at ({rocker!r}, 0, 0) m; axis z }}"]
    return "\n".join([
        "step 1 ms", "method rk4", *bodies,
        f"joint A revolute {{ parent ground; child crank; axis z; start {start!r} rad; speed {speed!r} rad/s; continuous }}",
        f"joint B revolute {{ parent crank at ({crank!r}, 0, 0) m; child coupler; axis z; start about {turned!r} rad }}",
        *last, "output energy = energy", "output violation = violation", ""])
