"""The mass matrix where the file draws the robot, in the coordinates of its joints: MuJoCo's compiler makes stiffness and
damping of it. With the armatures, and without closures."""
from equality import eliminate, globals_of, solution
from inertia import rotated
from place import UNTURNED, add, apply, cross, dot, minus, norm, scale, transpose

STILL = (0.0, 0.0, 0.0)


class MassMatrix:
    def __init__(self, model):
        self.places = globals_of(model)
        self.ways = []  # of each degree of freedom: angular velocity, and the velocity of the ground's origin
        self.first = {}  # by the name of a joint: its first degree of freedom, and how many it has
        self.moved = {"ground": []}  # by the name of a body: the degrees of freedom that move it
        armatures = []
        for made in model.joints.values():
            own = ways_of(made, self.places)
            self.first[made.name] = (len(self.ways), len(own))
            self.moved[made.child] = self.moved[made.parent] + list(range(len(self.ways), len(self.ways) + len(own)))
            self.ways += own
            armatures += [made.armature] * len(own)
        n = len(self.ways)
        self.entries = [[armatures[i] * (i == j) for j in range(n)] for i in range(n)]
        for body in model.bodies.values():
            for solid in body.solids:
                self.add(body.name, solid)

    def add(self, body, solid):
        """m v.v + w.I w of a solid, for each two ways to move it."""
        place = self.places[body] * solid.place
        tensor = rotated(place.turn, solid.inertia)
        velocities = {i: self.velocity(i, place.at) for i in self.moved[body]}
        for i, v in velocities.items():
            heavy = apply(tensor, self.ways[i][0])
            for j, other in velocities.items():
                self.entries[i][j] += solid.mass * dot(v, other) + dot(heavy, self.ways[j][0])

    def velocity(self, i, point):
        """Of a point of the ground's axes, by a unit speed."""
        turn, slide = self.ways[i]
        return add(slide, cross(turn, point))

    def is_positive(self):
        """Whether all pivots of Gauss are above zero, beyond rounding."""
        rows = [list(row) for row in self.entries]
        for k in range(len(rows)):
            if rows[k][k] <= 1e-12 * self.entries[k][k]:
                return False
            eliminate(rows[k:], k)
        return True

    def inertia_of(self, made):
        """What efforts on a joint move, with all others free: the inverse of the mean inverse inertia of its coordinates."""
        first, count = self.first[made.name]
        n = len(self.ways)
        unit = [[float(i == j) for j in range(n)] for i in range(first, first + count)]
        inverse = [solution(self.entries, row)[first + k] for k, row in enumerate(unit)]
        return count / sum(inverse)

    def moments_of(self, length):
        """The change of an actuator's length by each degree of freedom."""
        found = [0.0] * len(self.ways)
        for made, ratio in length.joints:
            found[self.first[made.name][0]] += ratio
        if length.points is not None:
            (one, at_one), (other, at_other) = ((body, self.places[body].point(place.at)) for body, place in length.points)
            away = minus(at_other, at_one)
            away = scale(length.scale / norm(away), away)
            for body, at, sign in ((one, at_one, -1), (other, at_other, 1)):
                for i in self.moved[body]:
                    found[i] += sign * dot(away, self.velocity(i, at))
        return found


def ways_of(made, places):
    """How a joint moves its child, by a unit speed of each coordinate."""
    if made.kind == "fixed":
        return []
    place = places[made.child] * made.child_place
    axes = transpose(place.turn)
    if made.kind == "prismatic":
        return [(STILL, scale(1 / norm(made.axis), apply(place.turn, made.axis)))]
    if made.kind == "revolute":
        axes = [scale(1 / norm(made.axis), apply(place.turn, made.axis))]
    slides = [(STILL, axis) for axis in UNTURNED] if made.kind == "free" else []
    return slides + [(axis, cross(place.at, axis)) for axis in axes]
