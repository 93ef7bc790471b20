"""MJCF: nested bodies, with defaults, classes and included files.

https://mujoco.readthedocs.io/en/stable/XMLreference.html. A coordinate of the scene is that of the file less its `ref`: it is
zero where the file draws the body.
"""
import math
import os

import actuators
import effects
import equality
import geoms
import keyframes
import loads
import meshes
import reader
from geoms import SEEN
from markup import Attributes, Document, Stop
from matrix import MassMatrix
from model import Solid
from place import QUARTER, Place, apply, cross, dot, minus, norm, of_quaternion, scale, to_axis, transpose, turned
from settings import SWITCHED_OFF, Settings

AXES = {"x": (1.0, 0.0, 0.0), "y": (0.0, 1.0, 0.0), "z": (0.0, 0.0, 1.0)}


class Found(Attributes):
    """An element with the defaults of its class: an attribute is looked for in it, then in them."""

    def __init__(self, element, defaults):
        self.element = element.take()
        self.chain = [element, *defaults]

    def holder(self, name):
        for element in self.chain:
            if name in element.attributes:
                return element
        return self.element

    def get(self, name, default=None):
        for element in self.chain:
            element.read.add(name)
        return self.holder(name).attributes.get(name, default)

    def has(self, name):
        return name in self.holder(name).attributes

    def leave(self, why, *names):
        """Names attributes as not taken, or the element: then also its defaults that nothing else reads."""
        for element in self.chain if names else [self.element]:
            element.leave(why, *names)
        for element in [] if names else self.chain[1:]:
            for unread in element.attributes:
                element.reasons.setdefault(unread, why)

    def problem(self, text, name=None):
        self.holder(name).problem(text, name if name and self.has(name) else None)

    def flag(self, name, auto):
        """true, false or auto, which is `auto`."""
        text = self.get(name, "auto")
        if text not in ("true", "false", "auto"):
            self.problem(f"{name} is '{text}': true, false or auto", name)
        return auto if text == "auto" else text == "true"

    def is_limited(self, name, limits, auto=True):
        """Whether limits count: if `name` is auto, those whose lower end is below the upper one."""
        flag = self.flag(name, auto and limits is not None and limits[0] < limits[1])
        return limits is not None and flag


def names_in(element):
    for child in element.children:
        yield child.attributes.get("name")
        yield from names_in(child)


class Reader(reader.Reader):
    def __init__(self, document, model, options):
        super().__init__(document, model, options)
        self.settings = Settings()
        model.step = 2e-3
        self.classes = {}  # by name: (parent's name, elements of the defaults)
        self.carrier = {"world": ("ground", Place())}  # by the name of a body: a body of the scene, and the place on it
        self.joints = {}  # by name: the joint of the scene, and its ref
        self.coordinates = []  # in the order of qpos: the joint of the scene, its kind and its name in the file
        self.ranges = []  # of joints with stops: the joint, its name, its ref, both limits of the scene
        self.keys = []  # names of keyframes
        self.key = None  # the keyframe whose starts are taken
        self.sites = {}  # by name: (carrier, place)
        self.tendons = {}  # by name: their lengths
        self.meshes = {}  # by name
        self.integrals = {}  # by the name of a mesh, and whether it is a shell
        self.ranges_of = {}  # by the kind and the name of an actuator's target: its range, in the coordinates of the file
        self.springdampers = []  # the joint in the file and in the scene, time, ratio
        self.lifts = []  # of bodies whose weight is carried in part: name, carrier, solids, share
        self.effort_limits = {}  # by the name of a joint of the scene: it, and the limits of all its actuators
        self.compensated = set()  # joints whose actuators carry the weight
        self.efforts = []  # of actuators on joints: the name of the joint, and a formula
        self.names = set()  # of all elements
        self.matrix = None  # of the masses, when it is asked for
        self.anonymous = 0  # elements without a name

    def read(self):
        self.include(self.root, [os.path.abspath(self.document.path)])
        self.root.take("model")
        self.names = set(names_in(self.root))
        for element in self.root.all("compiler"):
            self.settings.compiler(element.take())
        for element in self.root.all("option"):
            self.settings.option(element.take(), self.model)
        self.settings.switch_off(self.model)
        if self.document.problems:
            return
        for element in self.root.all("default"):
            self.defaults(element.take(), "")
        meshes.collect(self)
        worlds = self.root.all("worldbody")
        if not worlds:
            self.root.problem("there is no <worldbody>")
        for world in worlds:
            self.children(world.take(), "ground", Place(), "", [])
        if self.document.problems:
            return
        self.settings.scale_total(self.model)
        keyframes.read(self)
        for made, _ in self.joints.values():
            is_of_mesh = self.model.has_mesh_behind(made)
            self.hold_idle(made, "the masses of meshes behind it are not taken" if is_of_mesh else "MuJoCo refuses it")
        loads.springs(self)
        loads.lifts(self)
        actuators.read_tendons(self)
        equality.read(self)
        actuators.read(self)
        loads.limits(self)
        keyframes.finish(self)
        self.rest()

    def mass_matrix(self, found):
        """Where the file draws it; once all joints and masses are known."""
        if self.matrix is None:
            self.matrix = MassMatrix(self.model)
        if not self.matrix.is_positive():
            found.problem("the mass matrix is singular where the file draws it: nothing has an inertia to be made of")
            raise Stop
        return self.matrix

    def parts_of(self, tag):
        """The children of all elements of a tag."""
        return [child for group in self.root.all(tag) for child in group.take().children]

    # --- files and classes ---

    def include(self, element, files):
        """Puts the children of an included file where <include> stands."""
        children = []
        for child in element.children:
            if child.tag != "include":
                self.include(child, files)
                children.append(child)
                continue
            child.take()
            path = os.path.join(os.path.dirname(files[0]), child.name("file"))
            if os.path.abspath(path) in files[1:] or os.path.abspath(path) == files[0]:
                child.problem(f"'{path}' includes itself", "file")
                continue
            if not os.path.isfile(path):
                child.problem(f"there is no file '{path}'", "file")
                continue
            part = Document(path, self.document.problems)
            self.include(part.root, [*files, os.path.abspath(path)])
            for other in part.root.children:
                other.parent = element
            children.extend(part.root.children)
        element.children = children

    def defaults(self, element, parent):
        name = element.get("class") or (None if parent else "main")
        if name is None:
            element.problem("a default inside of another has a class: <default class=\"arm\">")
            return
        if parent and name in self.classes:
            element.problem(f"a second default of the class '{name}': one is right", "class")
            return
        own = self.classes.setdefault(name, (parent, []))[1]
        for child in element.children:
            if child.tag == "default":
                self.defaults(child.take(), name)
            else:
                own.append(child.take())

    def chain(self, element, tags, childclass):
        """The defaults of an element, from its class to the outermost, and in a class from the last."""
        name = element.get("class", childclass) or "main"
        found = []
        if name != "main" and name not in self.classes:
            element.problem(f"there is no class '{name}'", "class" if "class" in element.attributes else None)
        while name in self.classes:
            parent, own = self.classes[name]
            found += [default for default in reversed(own) if default.tag in tags]
            name = parent
        return found

    def found(self, element, childclass="", tags=None):
        return Found(element, self.chain(element, tags or [element.tag], childclass))

    # --- places ---

    def angle(self, text):
        if self.settings.degrees:
            return math.radians(float(text)) if float(text) % 90 else float(text) / 90 * QUARTER
        return super().angle(text)

    def place(self, found):
        """Of pos and any of the ways to write an orientation."""
        return Place(found.numbers("pos", 3, [0.0, 0.0, 0.0])) * self.turn(found)

    def turn(self, found):
        ways = [name for name in ("quat", "axisangle", "euler", "xyaxes", "zaxis") if found.has(name)]
        if not ways:
            return Place()
        own = [name for name in ways if name in found.element.attributes]
        if len(own) > 1:
            found.problem(f"{' and '.join(own)}: one way to write an orientation is right", own[1])
        way = (own or ways)[0]
        before = len(self.document.problems)
        values = found.numbers(way, {"quat": 4, "axisangle": 4, "euler": 3, "xyaxes": 6, "zaxis": 3}[way])
        if len(self.document.problems) > before:
            return Place()
        words = found.get(way).split()
        axis = values[:3]
        if way == "euler":
            return self.euler(found, words)
        if norm(values if way == "quat" else axis) == 0:
            found.problem(f"{way} has no length", way)
            return Place()
        if way == "quat":
            return Place(turn=of_quaternion(values))
        if way == "axisangle":
            return turned([(self.angle(words[3]), tuple(axis))])
        if way == "zaxis":
            return Place(turn=to_axis(axis))
        x = scale(1 / norm(axis), axis)
        y = minus(values[3:], scale(dot(x, values[3:]), x))
        if norm(y) == 0:
            found.problem("the axes of xyaxes are parallel", way)
            return Place()
        y = scale(1 / norm(y), y)
        return Place(turn=transpose((x, y, cross(x, y))))

    def euler(self, found, words):
        """Small letters turn about moving axes, capital ones about fixed axes."""
        place = Place()
        for letter, word in zip(self.settings.eulerseq, words):
            step = turned([(self.angle(word), AXES[letter.lower()])])
            place = place * step if letter.islower() else step * place
        return place

    # --- bodies ---

    def name_of(self, element, kind):
        name = element.get("name")
        if name:
            return name
        self.anonymous += 1
        while f"{kind}{self.anonymous}" in self.names:
            self.anonymous += 1
        return f"{kind}{self.anonymous}"

    def inside(self, frame, place, childclass):
        """The place and the class of what stands in a frame."""
        frame.take("name")
        return place * self.place(self.found(frame, childclass)), frame.get("childclass", childclass)

    def joints_of(self, element, place, childclass):
        """The joints of a body and of the frames in it, each with the place of its frame and the class there."""
        for child in element.children:
            if child.tag in ("joint", "freejoint"):
                yield child, place, childclass
            elif child.tag == "frame":
                yield from self.joints_of(child, *self.inside(child, place, childclass))

    def children(self, element, carrier, place, childclass, solids):
        """Reads the content of a body or a frame: its geoms and sites, bodies, frames."""
        for child in element.children:
            if child.tag == "body":
                self.body(child.take(), carrier, place, childclass)
            elif child.tag == "frame":
                self.children(child, carrier, *self.inside(child, place, childclass), solids)
            elif child.tag == "geom":
                geoms.read(self, child, carrier, childclass, solids)
            elif child.tag == "site":
                found = self.found(child, childclass)
                self.sites[self.name_of(child, "site")] = (carrier, place * self.place(found))
                found.leave(SEEN, "type", "size", "rgba", "material", "group", "fromto")
            elif child.tag in ("joint", "freejoint", "inertial"):
                if not child.taken and "" not in child.left:
                    child.problem(f"a <{child.tag}> stands in a body", None)
            elif child.tag in ("camera", "light"):
                child.leave(SEEN)
            elif child.tag == "replicate":
                child.problem(
                    f"a replicate is {child.get('count', 'many')} copies of what stands in it, which are not made "
                    "here: write the copies out, as a file does that MuJoCo saves"
                )
            elif child.tag in ("composite", "flexcomp", "attach", "plugin"):
                child.leave("made of many, or by a plugin")

    def body(self, element, carrier, place, childclass):
        childclass = element.get("childclass", childclass)
        name = self.name_of(element, "body")
        if name in self.carrier:
            element.problem(f"a second body '{name}': names differ", "name")
        found = self.found(element, childclass)
        element.get("user")
        if element.get("mocap") == "true":
            element.leave("a mocap body stands where it is drawn", "mocap")
        own = place * self.place(found)
        joints = list(self.joints_of(element, Place(), childclass))
        inner = (carrier, own)
        if joints:
            inner = (self.chain_of(name, joints, carrier, own), Place())
        self.carrier[name] = inner
        solids, parts = self.inertial(element, name, childclass), []
        self.children(element, *inner, childclass, parts)
        solids = self.weigh(element, name, *inner, solids if self.settings.takes_inertial(bool(solids)) else parts)
        loads.body(self, element, name, inner[0], solids)

    def weigh(self, element, name, carrier, place, solids):
        """Puts the parts of a body onto its carrier, within the bounds of the compiler; returns them."""
        if carrier == "ground":
            return []
        solids = self.settings.bounded(solids, name, self.model, element.problem)
        for solid in solids:
            solid.place = place * solid.place
            self.model.bodies[carrier].solids.append(solid)
        return solids

    def inertial(self, element, name, childclass):
        """The <inertial> of a body, as its only part; none where there is none."""
        one = element.one("inertial")
        if one is None:
            return []
        if self.settings.inertiafromgeom == "true":
            one.leave("inertiafromgeom: the geoms count")
            return []
        found = self.found(one, childclass)
        mass = found.number("mass", 0.0)
        place = self.place(found)
        full, diagonal = found.numbers("fullinertia", 6), found.numbers("diaginertia", 3)
        if mass < 0:
            found.problem(f"the mass of '{name}' is below zero", "mass")
        if full is not None and diagonal is not None:
            found.problem("diaginertia and fullinertia: one is right", "fullinertia")
        values = tuple(full or [*(diagonal or [0.0, 0.0, 0.0]), 0.0, 0.0, 0.0])
        return [Solid(mass, place, values, of=name)]

    def chain_of(self, name, joints, carrier, place):
        """The joints of a body, one after the other, with bodies without mass between them; the last one has the body."""
        body = None
        for k, (element, frame, childclass) in enumerate(joints):
            found = self.found(element, childclass, ["joint"] if element.tag == "joint" else [])
            last = k + 1 == len(joints)
            label = element.get("name") or (f"{name}_joint" if len(joints) == 1 else f"{name}_joint{k + 1}")
            body = self.model.body(name if last else f"{name}_by_{label}")
            kind = "free" if element.tag == "freejoint" else found.get("type", "hinge")
            self.joint(found, label, kind, carrier, place, body.name, len(joints), frame)
            carrier, place = body.name, Place()
        return body.name

    def joint(self, found, label, kind, carrier, place, child, count, frame):
        """A joint between carrier and child, at a place of the carrier; `frame` is that of its own place and axis."""
        kinds = {"hinge": "revolute", "slide": "prismatic", "ball": "spherical", "free": "free"}
        if kind not in kinds:
            found.problem(f"the type '{kind}' is not known: {', '.join(kinds)}", "type")
            kind = "hinge"
        if label in self.joints:
            found.problem(f"a second joint '{label}': names differ", "name")
        at = Place(frame.point(found.numbers("pos", 3, [0.0, 0.0, 0.0])))
        if kind == "free":
            if carrier != "ground" or count > 1:
                found.problem("a free joint is the only one of a body of the world")
            made = self.model.joint(label, "free", "ground", Place(), child, start_place=place)
            made.damping = found.number("damping", 0.0)
        else:
            made = self.model.joint(label, kinds[kind], carrier, place * at, child, child_place=at)
        self.joints[label] = (made, 0.0)
        self.coordinates.append((made, kind, label))
        self.properties(found, label, made, frame)
        made.damping = 0.0 if "damper" in self.settings.off else made.damping
        made.spring = 0.0 if "spring" in self.settings.off else made.spring

    def properties(self, found, label, made, frame):
        """Axis, armature, damping, spring, limits and friction of a joint."""
        if made.kind == "free" and found.element.tag == "freejoint":
            found.leave(SEEN, "group")
            return
        axis = found.numbers("axis", 3, [0.0, 0.0, 1.0])
        if made.has_one_coordinate() and norm(axis) == 0:
            found.problem("the axis has no length: axis=\"0 0 1\"", "axis")
            axis = [0.0, 0.0, 1.0]
        made.axis = apply(frame.turn, axis)
        made.damping = found.number("damping", 0.0)
        made.armature = found.number("armature", 0.0)
        stiffness = found.number("stiffness", 0.0)
        ref = self.in_radians(found.number("ref", 0.0), made)
        rest = self.in_radians(found.number("springref", 0.0), made) - ref
        friction = found.number("frictionloss", 0.0)
        limits = found.numbers("range", 2)
        if made.damping < 0 or made.armature < 0 or stiffness < 0 or friction < 0:
            found.problem("damping, armature, stiffness and frictionloss are not below zero")
        self.joints[label] = (made, ref)
        if ref and made.has_one_coordinate():  # others have none in MuJoCo
            self.model.notes.append(f"{label} of the file is {made.name} {'-' if ref < 0 else '+'} {abs(ref):.6g} {made.unit()}: ref")
        found.leave("a stop of its own", "solreflimit", "solimplimit")
        found.leave("a friction of its own", "solreffriction", "solimpfriction")
        found.leave("a stop begins at its limit", "margin")
        found.leave(SEEN, "group")
        found.leave("of the user", "user")
        loads.joint(self, found, made)
        made.spring = stiffness
        if not made.has_one_coordinate():
            self.of_several(found, friction)
            return
        made.rest = rest
        if limits is not None:
            self.ranges_of["joint", label] = [self.in_radians(x, made) for x in limits]
        if friction > 0 and "frictionloss" not in self.settings.off:
            effects.friction(self.model, made, friction)
        if found.is_limited("limited", limits, self.settings.autolimits) and "limit" not in self.settings.off:
            before = len(self.document.problems)
            lower, upper = (self.in_radians(x, made) - ref for x in limits)
            if lower >= upper:
                found.problem("the lower end of the range is below the upper one", "range")
            if len(self.document.problems) == before:
                effects.stop(self.model, made, lower, upper)
                self.ranges.append((made, label, ref, lower, upper))
        elif limits is not None:
            found.leave(SWITCHED_OFF if "limit" in self.settings.off else "the joint is not limited", "range")

    @staticmethod
    def of_several(found, friction):
        """Names the properties that ball and free joints lack here as not taken."""
        if friction:
            found.leave("of joints of one coordinate", "frictionloss")
        if found.get("range") is not None:
            found.leave("of joints of one coordinate", "range")
        found.get("limited")

    def in_radians(self, value, made):
        return math.radians(value) if made.turns() and self.settings.degrees else value

    # --- the rest ---

    def rest(self):
        leave_all = self.root.leave_all
        meshes.finish(self)
        leave_all(SEEN, "visual", "statistic")
        leave_all("memory of MuJoCo", "size")
        leave_all("of the user", "custom")
        leave_all("contact is of points and balls with the ground", "contact")
        leave_all("outputs of the scene show what is asked for", "sensor")
        leave_all("plugins", "extension")
        leave_all("not rigid", "deformable")
        for parent, own in self.classes.values():
            for element in own:
                self.unused_default(element)
        self.note_rounded()
        for site, (carrier, place) in self.sites.items():
            if not site.startswith("site") or not site[4:].isdigit():
                self.model.frames.append((self.model.name(site, "frame"), carrier, place))

    @staticmethod
    def unused_default(element):
        why = SEEN if element.tag in ("material", "camera", "light", "mesh", "texture") else "nothing uses this default"
        for name in element.attributes:
            if name not in element.read:
                element.leave(element.reasons.get(name, why), name)
