"""The content of a scene, between a file and its text: bodies, joints, closures, inputs, effects."""
import re
from dataclasses import dataclass, field

from inertia import excess, is_negative, nearest_possible, principal, rotated
from place import Place, apply, dot, minus, norm, scale, turned

RESERVED = """ground pi time at about rotate quaternion substeps x y z in of on and like step energy power balance violation
inertia mass com parent child axis start speed position repeat include output input body joint effect frame close spring force
signal constant tunable gravity method to from every""".split()
UNITS = "m g s N J W Pa Hz rad A V Ohm H F Wb T K bar L Ah deg rev rpm min h t degC".split()
LONGEST = 64  # characters of a name
POINT = 1e-15  # m^2, of an inertia over the mass: what is smaller is a rounding error
PREFIXES = ["", *"numcdkMG"]


@dataclass
class Solid:
    """A part of a body: where its centre of mass and its axes are, and its inertia there."""

    mass: float
    place: Place
    inertia: tuple  # xx, yy, zz, xy, xz, yz
    text: str = ""  # a solid of the language with its size: box (1, 2, 3) m
    of: str = ""  # its name in the file
    is_as_given: bool = False  # no body has this inertia


@dataclass
class Body:
    name: str
    solids: list = field(default_factory=list)

    def mass(self):
        return sum(solid.mass for solid in self.solids)


@dataclass
class Joint:
    name: str
    of: str
    kind: str
    parent: str
    parent_place: Place
    child: str
    child_place: Place = field(default_factory=Place)
    axis: tuple = (0.0, 0.0, 1.0)
    start: float = 0.0
    start_place: Place = None  # of a free joint, as the file draws it
    key_place: Place = None  # of a free or spherical joint, where it starts instead
    speeds: list = field(default_factory=list)  # at the start; of a free joint three along axes, then three about them
    damping: float = 0.0
    spring: float = 0.0
    rest: float = 0.0
    armature: float = 0.0
    drive: str = ""
    continuous: bool = False
    is_given: bool = False  # its start is said, also where that is zero
    mimics: bool = False  # it follows another joint
    most_effort: float = 0.0

    def turns(self):
        return self.kind == "revolute"

    def unit(self):
        return "rad" if self.turns() else "m"

    def effort(self):
        return "N*m" if self.turns() else "N"

    def has_one_coordinate(self):
        return self.kind in ("revolute", "prismatic")

    def place_at_start(self):
        """How far it has moved where it starts."""
        if not self.has_one_coordinate():
            return self.key_place or self.start_place or Place()
        if self.turns():
            return turned([(self.start, self.axis)])
        return Place(scale(self.start / norm(self.axis), self.axis))


@dataclass
class Use:
    """A statement with braces: an effect, a closure, a spring, a force."""

    head: str
    lines: list


@dataclass
class Input:
    name: str
    unit: str  # "" for a plain number
    limits: tuple = None
    of: str = ""


class Model:
    def __init__(self, repairs_inertia=False):
        self.repairs_inertia = repairs_inertia
        self.gravity = (0.0, 0.0, -9.81)
        self.step = 1e-3
        self.method = "rk4"
        self.stabilisation = ""  # another than that of the language
        self.bodies = {}  # by name, in their order
        self.joints = {}
        self.frames = []  # (name, body, Place)
        self.closures = []
        self.inputs = []
        self.kinds = {}  # definitions of effects: name, text
        self.effects = []
        self.outputs = []  # (name, formula)
        self.mesh_bodies = set()  # bodies whose mass is that of meshes that are not taken
        self.notes = []  # changes of the import that the file does not state
        self.used = {}  # names, in lower case: their kinds
        self.renamed = []
        for word in [*RESERVED, *(prefix + unit for unit in UNITS for prefix in PREFIXES)]:
            self.used[word.lower()] = None

    def name(self, text, kind, is_own=False):
        """A name of the language for one of the file, that nothing else has; or for one of the import's own."""
        plain = re.sub(r"\W+", "_", text, flags=re.ASCII).strip("_") or kind
        plain = plain if not plain[0].isdigit() else f"{kind}_{plain}"
        chosen, count = plain[:LONGEST], 1
        while self.is_used(chosen, kind):
            count += 1
            end = f"_{kind}" if count == 2 else f"_{kind}{count - 1}"
            chosen = f"{plain[: LONGEST - len(end)]}{end}"
        self.used[chosen.lower()] = kind
        if kind == "joint":
            self.used[f"{chosen.lower()}_speed"] = kind
        if chosen != text and not is_own:
            self.renamed.append(f"{text} is {chosen}")
        return chosen

    def is_used(self, name, kind):
        low = name.lower()
        return low in self.used or (kind == "joint" and f"{low}_speed" in self.used)

    def has_mesh_behind(self, joint):
        """Whether the mass that a joint moves is that of a mesh, also in part."""
        return not self.mesh_bodies.isdisjoint(outboard(self, joint.child))

    def unique_note(self, text):
        if text not in self.notes:
            self.notes.append(text)

    def body(self, text):
        body = Body(self.name(text, "body"))
        self.bodies[body.name] = body
        return body

    def joint(self, label, *values, is_own=False, **more):
        joint = Joint(self.name(label, "joint", is_own), label, *values, **more)
        self.joints[joint.name] = joint
        return joint

    def effect(self, label, kind, *lines):
        """An effect of a kind, under a name of the import's own, which it returns."""
        name = self.name(label, "effect", True)
        self.effects.append(Use(f"effect {name} {kind}", lines))
        return name

    def close(self, name, kind, *lines):
        self.closures.append(Use(f"close {name} {kind}", lines))

    def admit(self, solid, name, refuse):
        """Takes the inertia of a solid as it is written, if a mass matrix can have it; with --repair-inertia the nearest one
        of a body. `refuse` notes an error."""
        beyond, is_below = excess(solid.inertia), is_negative(solid.inertia)
        fault = f"its largest principal moment is {100 * beyond:.3g} % larger than the sum of the others"
        fault = "a principal moment is negative" if is_below else fault
        if not is_below and beyond == 0:
            return
        if max(map(abs, solid.inertia)) < POINT * solid.mass:
            solid.inertia = (0.0,) * 6
            self.unique_note(f"the inertia of {name} is zero but for rounding: it is a point")
            return
        if self.repairs_inertia:
            moments = [", ".join(f"{x:.6g}" for x in sorted(principal(x)[0])) for x in (solid.inertia, nearest_possible(solid.inertia))]
            solid.inertia = nearest_possible(solid.inertia)
            self.unique_note(
                f"no body has the inertia of {name}: {fault}; it is the nearest possible one: the principal moments "
                f"{moments[0]} kg*m^2 are {moments[1]}"
            )
        elif is_below:
            refuse(
                f"the inertia of '{name}' is impossible: {fault}, and a mass matrix could be so too; "
                "--repair-inertia takes the nearest possible one"
            )
        else:
            solid.is_as_given = True
            self.unique_note(
                f"warning: no body has the inertia of {name}: {fault}; it is taken as written (as_given); --repair-inertia "
                "takes the nearest possible one"
            )


# --- joints that move no inertia ---


def outboard(model, name):
    """The bodies behind a body, and it."""
    found, left = [], [name]
    children = {}
    for joint in model.joints.values():
        children.setdefault(joint.parent, []).append(joint.child)
    while left:
        name = left.pop()
        found.append(name)
        left.extend(children.get(name, ()))
    return found


def moves_nothing(model, joint):
    """Whether a joint of the tree moves no inertia: nothing heavy behind it, or only points on its axis."""
    if joint.armature > 0:
        return False
    bodies = [model.bodies[name] for name in outboard(model, joint.child)]
    heavy = [body for body in bodies if any(solid.mass > 0 for solid in body.solids)]
    if not heavy:
        return True
    if not joint.turns() or heavy != [model.bodies[joint.child]]:
        return False
    place, largest = joint.child_place, 0.0
    axis = apply(place.turn, joint.axis)
    axis = scale(1 / norm(axis), axis)
    for solid in heavy[0].solids:
        away = minus(solid.place.at, place.at)
        largest += solid.mass * max(dot(away, away) - dot(away, axis) ** 2, 0.0)
        largest += dot(axis, apply(rotated(solid.place.turn, solid.inertia), axis))
    return largest < 1e-30
