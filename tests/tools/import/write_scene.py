"""A random scene of what MJCF can say: write_scene.py SEED. The same seed gives the same scene.

A tree of joints of all kinds with springs, dampers and armatures; effects that are linear, limited, dry friction and stops; and a
closure, which holds at the start: its frame on the ground, or on the first body, is where the last body then is.
"""
import os
import random
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "..", "tools", "import"))
from place import Place, turned  # noqa: E402

EFFECTS = """
# A spring and a damper that twist two joints against each other.
effect bond {
    joint one; joint other
    value ratio; value stiffness N*m/rad; value damping N*m*s/rad; value rest rad
    let effort = stiffness * (position of one - ratio * position of other - rest) + damping * (speed of one - ratio * speed of other)
    effort on one = -effort; effort on other = ratio * effort
}
# A controller with a limited effort.
effect servo {
    joint along
    signal aim rad
    value ratio; value stiffness N*m/rad; value damping N*m*s/rad; value most N*m
    effort on along = ratio * clamp(stiffness * (aim - ratio * position of along) - damping * ratio * speed of along, -most, most)
}
# One motor that turns two joints.
effect shared {
    joint one; joint other
    signal motor N*m
    value ratio; value most N*m
    let effort = clamp(motor, -most, 0.5 * most)
    effort on one = effort; effort on other = -ratio * effort
}
# A motor with its losses, and a weight on a drum.
effect wound {
    joint along
    signal voltage V
    value gain N*m/V; value loss N*m*s/rad; value weight N*m
    effort on along = gain * voltage - loss * speed of along - weight
}
"""
FEWEST = {"": 2, "spherical": 4, "distance": 3, "revolute": 6, "fixed": 7, "gear": 3}


class Scene:
    def __init__(self, seed):
        self.r = random.Random(seed)
        self.closure = list(FEWEST)[seed % len(FEWEST)]
        self.lines, self.inputs, self.places, self.joints = [], [], [], []

    def number(self, low, high):
        return round(self.r.uniform(low, high), 4)

    def vector(self, size):
        return tuple(self.number(-size, size) for _ in range(3))

    def axis(self):
        v = self.vector(1)
        return v if max(map(abs, v)) > 0.3 and self.r.random() < 0.6 else self.r.choice([(1, 0, 0), (0, -1, 0), (0, 0, 1)])

    def input(self, kind):
        self.inputs.append(f"{kind}{len(self.inputs)}")
        return self.inputs[-1]

    def where(self):
        """A random place, and its text."""
        at, axis, angle = self.vector(0.4), self.axis(), self.number(-2, 2)
        return turned([(angle, axis)], at), f"at {at} m rotate {angle} rad about {axis}"

    def joint(self, k):
        r, n = self.r, f"j{k}"
        kind = r.choices(["revolute", "prismatic", "spherical"], [5, 1, self.closure not in ("gear",)])[0] if k else "revolute"
        parent = -1 if k == 0 else k - 1 if self.closure or r.random() < 0.7 else r.randrange(k)
        (place, text), (own, own_text), axis = self.where(), self.where(), self.axis()
        moments = [self.number(0.03, 0.045) for _ in range(3)]
        self.lines.append(
            f"body b{k} {{ mass {self.number(0.2, 2)} kg; com {self.vector(0.2)} m; inertia ({moments[0]}, {moments[1]}, {moments[2]}; "
            f"{self.number(-0.003, 0.003)}, {self.number(-0.003, 0.003)}, 0.002) kg*m^2 }}"
        )
        parts = [f"parent {'ground' if parent < 0 else f'b{parent}'} {text}", f"child b{k} {own_text}"]
        start = self.number(-1, 1)
        if kind == "spherical":
            q = [1.0, *self.vector(0.8)]
            size = sum(x * x for x in q) ** 0.5
            q = [x / size for x in q]
            motion = Place(turn=quaternion_matrix(q))
            parts.append(f"start quaternion ({', '.join(map(repr, q))})")
            if r.random() < 0.5:
                parts.append(f"spin_damping {self.number(0, 0.3)} N*m*s/rad")
            if k % 2:
                parts.append("spin_armature 0.05 kg*m^2")
        else:
            turns = kind == "revolute"
            unit, effort = ("rad", "N*m") if turns else ("m", "N")
            size = sum(x * x for x in axis) ** 0.5
            motion = turned([(start, axis)]) if turns else Place([start * x / size for x in axis])
            parts += [f"axis {axis}", f"start {start} {unit}"]
            if r.random() < 0.4:
                parts.append(f"damping {self.number(0, 0.5)} {effort}*s/{unit}")
            if r.random() < 0.3:
                parts.append(f"spring {self.number(0, 5)} {effort}/{unit} rest {self.number(-1, 1)} {unit}")
            if r.random() < 0.3:
                parts.append(f"armature {self.number(0, 0.1)} {'kg*m^2' if turns else 'kg'}")
            if r.random() < 0.3:
                parts.append(f"drive {self.input('push')}")
        self.places.append((Place() if parent < 0 else self.places[parent]) * place * motion * own.inverse())
        self.joints.append((n, kind, start))
        self.lines.append(f"joint {n} {kind} {{ {'; '.join(parts)} }}")

    def effects(self):
        r, lines = self.r, []
        turning = [name for name, kind, _ in self.joints if kind == "revolute"]
        if r.random() < 0.5 and len(turning) > 1:
            one, other = r.sample(turning, 2)
            lines.append(
                f"effect e_bond bond {{ one {one}; other {other}; ratio {self.number(-2, 2)}; stiffness {self.number(1, 5)} N*m/rad; "
                f"damping {self.number(0, 0.5)} N*m*s/rad; rest {self.number(-1, 1)} rad }}"
            )
        if r.random() < 0.5:
            lines.append(
                f"effect e_servo servo {{ along {r.choice(turning)}; aim {self.input('aim')} * 1 rad; ratio {self.number(0.5, 2)}; "
                f"stiffness {self.number(1, 5)} N*m/rad; damping {self.number(0, 0.5)} N*m*s/rad; most {self.number(0.5, 5)} N*m }}"
            )
        if r.random() < 0.4 and len(turning) > 1:
            one, other = r.sample(turning, 2)
            lines.append(
                f"effect e_shared shared {{ one {one}; other {other}; motor {self.input('torque')} * 2 N*m; ratio {self.number(0.5, 2)}; "
                f"most {self.number(0.5, 5)} N*m }}"
            )
        if r.random() < 0.5:
            lines.append(
                f"effect e_wound wound {{ along {r.choice(turning)}; voltage {self.input('volts')} * 1 V; gain {self.number(0.1, 2)} N*m/V; "
                f"loss {self.number(0, 0.5)} N*m*s/rad; weight {self.number(-1, 1)} N*m }}"
            )
        single = [(name, kind, start) for name, kind, start in self.joints if kind != "spherical"]
        name, kind, start = r.choice(single)
        unit, effort = ("rad", "N*m") if kind == "revolute" else ("m", "N")
        lines.append(f"effect e_rub friction {{ along {name}; sliding {self.number(0.1, 1)} {effort} }}")
        name, kind, start = r.choice(single)
        unit = "rad" if kind == "revolute" else "m"
        lines.append(
            f"effect e_ends stop {{ along {name}; lower {start - self.number(15, 20)} {unit}; upper {start + self.number(15, 20)} {unit}; "
            f"impact 1 {unit}/s }}"
        )
        return lines

    def close(self):
        if not self.closure:
            return []
        if self.closure == "gear":
            ends = [(name, kind) for name, kind, _ in self.joints if kind != "spherical"]
            (one, first), (other, second) = ends[0], ends[-1]
            units = {"revolute": "rad", "prismatic": "m"}
            unit = "" if first == second else f" {units[first]}/{units[second]}"
            return [f"close loop gear {{ first {one}; second {other}; ratio {self.number(0.5, 2)}{unit} }}"]
        at, text = self.where()
        there = self.places[-1] * at
        if self.closure == "distance":
            away = self.vector(1)
            size = sum((x - y) ** 2 for x, y in zip(away, there.at)) ** 0.5
            return [f"close loop distance {{ parent ground at {away} m; child b{len(self.joints) - 1} {text}; length {size!r} m }}"]
        steps = " ".join(f"rotate {angle!r} rad about ({', '.join(map(repr, axis))})" for angle, axis in there.steps())
        place = f"at ({', '.join(map(repr, there.at))}) m {steps}"
        axis = f"; axis {self.axis()}" if self.closure == "revolute" else ""
        return [f"close loop {self.closure} {{ parent ground {place}; child b{len(self.joints) - 1} {text}{axis} }}"]

    def text(self):
        few = FEWEST[self.closure]
        for k in range(self.r.randint(few, few + 2)):
            self.joint(k)
        rest = [*self.effects(), *self.close()]
        inputs = [f"input {name}" if name.startswith("push") else f"input {name} = 0" for name in self.inputs]
        head = ["gravity (0.3, -0.2, -9.81) m/s^2", "step 1 ms", "method rk4", EFFECTS, *inputs]
        return "\n".join([*head, *self.lines, *rest, "output energy = energy"]) + "\n"


def quaternion_matrix(q):
    w, x, y, z = q
    return (
        (w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)),
        (2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)),
        (2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z),
    )


if __name__ == "__main__":
    sys.stdout.write(Scene(int(sys.argv[1])).text())
