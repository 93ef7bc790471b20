"""URDF: a tree of links. Links on fixed joints are parts of the link that carries them.

http://wiki.ros.org/urdf/XML: the root link stands on the ground unless it is asked to float; the frame of a link is that of
the joint whose child it is.
"""
import effects
import reader
from markup import Element
from model import Input, Solid
from place import Place, norm, turned

KINDS = {
    "revolute": "revolute",
    "continuous": "revolute",
    "prismatic": "prismatic",
    "fixed": None,
    "floating": "free",
    "planar": "planar",
}
UNLIMITED = 1e30  # from here on a limit of efforts or speeds is none, as files write it: inf, or the largest number


def most(limit, name):
    """A limit of efforts or speeds; 0 where there is none."""
    if limit.get(name, "").strip() in ("inf", "+inf"):
        return 0.0
    found = abs(limit.number(name, 0.0))
    return found if found < UNLIMITED else 0.0


def leftovers(element):
    """What is to be expanded by xacro: (element, text, attribute or None)."""
    if element.tag.startswith("xacro:"):
        yield element, f"<{element.tag}>", None
    for name, text in element.attributes.items():
        if "${" in text or "$(" in text:
            yield element, f"'{text}'", name
    for child in element.children:
        yield from leftovers(child)


class Reader(reader.Reader):
    def __init__(self, document, model, options):
        super().__init__(document, model, options)
        self.links = {}  # by name: its element
        self.joints = {}
        self.of_child = {}  # by the name of a link: the joint whose child it is
        self.carrier = {}  # by the name of a link: the body or the ground, and the place on it
        self.weightless = []  # links that have a shape, and no inertial
        self.made = {}  # by the name of a joint: the joint of the scene

    def place(self, element):
        """Of an origin: roll, pitch and yaw about the fixed axes x, y and z."""
        if element is None:
            return Place()
        at = element.numbers("xyz", 3, [0.0, 0.0, 0.0])
        before = len(self.document.problems)
        rpy = element.numbers("rpy", 3, [0.0, 0.0, 0.0])
        if element.attributes.get("rpy") is not None and len(self.document.problems) == before:
            rpy = [self.angle(word) for word in element.attributes["rpy"].split()]
        return turned([(rpy[2], (0.0, 0.0, 1.0)), (rpy[1], (0.0, 1.0, 0.0)), (rpy[0], (1.0, 0.0, 0.0))], at)

    # --- the tree ---

    def read(self):
        self.root.take("name", "version", *(name for name in self.root.attributes if name.startswith("xmlns")))
        left = next(leftovers(self.root), None)
        if left is not None:
            left[0].problem(f"{left[1]} is of xacro: expand the file first, xacro ROBOT.xacro >ROBOT.urdf", left[2])
            return
        for link in self.root.all("link"):
            self.add(self.links, link.take())
        for joint in self.root.all("joint"):
            self.add(self.joints, joint.take())
            self.ends(joint)
        roots = [name for name in self.links if name not in self.of_child]
        if not self.links:
            self.root.problem("the robot has no link: <link name=\"base\"/>")
        elif not roots:
            self.root.problem("the links are a circle: one of them is the child of no joint")
        for name in roots[1:]:
            self.links[name].problem(
                f"'{name}' is the child of no joint, as '{roots[0]}' is: only one link is the root"
            )
        if self.document.problems:
            return
        self.plant(roots[0])
        self.tree(roots[0])
        self.mimics()
        self.drives()
        self.rest()

    def add(self, to, element):
        name = element.name()
        if name in to:
            element.problem(f"a second {element.tag} '{name}': names differ", "name")
        to[name] = element

    def ends(self, joint):
        """The parent and the child of a joint, which exist."""
        ends = []
        for tag in ("parent", "child"):
            end = joint.one(tag)
            name = end.name("link") if end is not None else ""
            if end is None:
                joint.problem(f"the joint '{joint.get('name')}' has no <{tag}>: <{tag} link=\"...\"/>")
            elif name not in self.links and (tag, name) == ("parent", "world"):  # a file need not write it
                self.links[name] = Element(self.document, self.root, "link", {"name": name}, end.offset)
            elif name not in self.links:
                end.problem(f"there is no link '{name}'", "link")
            ends.append(name)
        if ends[1] in self.of_child:
            joint.problem(
                f"'{ends[1]}' is the child of '{self.of_child[ends[1]].get('name')}' already: " "a link has one parent"
            )
        self.of_child[ends[1]] = joint

    def plant(self, root):
        """The root link, on the ground or floating."""
        if not self.options.floating:
            self.carrier[root] = ("ground", Place())
            inertial = self.links[root].one("inertial")
            if inertial is not None:
                inertial.leave("the root link stands on the ground; --floating lets it move")
            return
        base = self.model.joint("floating_base", "free", "ground", Place(), "", is_own=True)
        base.child = self.model.body(root).name
        self.carrier[root] = (base.child, Place())
        self.solids(root)
        self.model.notes.append(f"the root link {root} floats, as it was asked for")

    def tree(self, root):
        children = {}
        for joint in self.joints.values():
            children.setdefault(joint.one("parent").get("link"), []).append(joint)
        left = [root]
        reached = set()
        while left:
            link = left.pop()
            reached.add(link)
            self.links[link].one("inertial")
            for joint in children.get(link, ()):
                self.connect(link, joint)
            left.extend(joint.one("child").get("link") for joint in reversed(children.get(link, ())))
        for name in self.links:
            if name not in reached:
                self.links[name].problem(f"'{name}' hangs in a circle of joints, not on the root '{root}'")

    def connect(self, link, joint):
        """A joint with its child."""
        carrier, place = self.carrier[link]
        place = place * self.place(joint.one("origin"))
        kind = joint.get("type")
        child = joint.one("child").get("link")
        if kind not in KINDS:
            joint.problem(f"the type '{kind}' of '{joint.get('name')}' is not known: {', '.join(KINDS)}", "type")
            kind = "fixed"
        if KINDS[kind] is None:
            self.weld(joint, child, carrier, place)
            return
        body = self.model.body(child)
        self.carrier[child] = (body.name, Place())
        self.solids(child)
        made = self.model.joint(joint.get("name"), KINDS[kind], carrier, place, body.name)
        self.made[joint.get("name")] = made
        made.continuous = kind == "continuous"
        if kind == "floating" and carrier == "ground":
            made.start_place, made.parent_place = place, Place()  # its place is in the axes of the ground
        self.properties(joint, made)

    def weld(self, joint, child, carrier, place):
        """A fixed joint: the child becomes a part of its carrier, and its frame keeps its name."""
        self.carrier[child] = (carrier, place)
        self.solids(child)
        why = "has nothing to do at a fixed joint"
        joint.leave_all(why, "axis", "limit", "dynamics", "mimic", "calibration", "safety_controller")
        self.model.frames.append((self.model.name(child, "frame"), carrier, place))

    # --- links ---

    def solids(self, name):
        """The inertia of a link, as a part of the body that carries it."""
        carrier, place = self.carrier[name]
        inertial = self.links[name].one("inertial")
        if inertial is None:
            if carrier != "ground" and self.links[name].all("visual", "collision"):
                self.weightless.append(name)
            return
        if carrier == "ground":
            inertial.leave("what stands on the ground moves nothing")
            return
        mass_element, inertia_element = inertial.one("mass"), inertial.one("inertia")
        mass = 0.0
        if mass_element is None:
            inertial.problem("an inertial without a mass: <mass value=\"1\"/>")
        else:
            mass = mass_element.number("value", 0.0)
            if mass < 0:
                mass_element.problem(f"the mass of '{name}' is below zero", "value")
        values = [0.0] * 6
        if inertia_element is not None:
            values = [inertia_element.number(key, 0.0) for key in ("ixx", "iyy", "izz", "ixy", "ixz", "iyz")]
        where = place * self.place(inertial.one("origin"))
        if mass == 0 and any(values):
            inertial.leave("without a mass, the inertia alone is not taken")
            return
        solid = Solid(mass, where, tuple(values), of=name)
        self.model.admit(solid, name, (inertia_element or inertial).problem)
        self.model.bodies[carrier].solids.append(solid)

    # --- joints ---

    def properties(self, joint, made):
        axis = joint.one("axis")
        if made.kind != "free":
            made.axis = tuple(axis.numbers("xyz", 3, [1.0, 0.0, 0.0])) if axis is not None else (1.0, 0.0, 0.0)
            if norm(made.axis) == 0:
                axis.problem("the axis has no length: xyz=\"0 0 1\"", "xyz")
                made.axis = (0.0, 0.0, 1.0)
        elif axis is not None:
            axis.leave("a floating joint has no axis")
        dynamics = joint.one("dynamics")
        if dynamics is not None:
            made.damping = dynamics.number("damping", 0.0)
            friction = dynamics.number("friction", 0.0)
            if made.damping < 0 or friction < 0:
                dynamics.problem("a damping or a friction is not below zero")
            if friction > 0 and made.has_one_coordinate():
                effects.friction(self.model, made, friction)
            elif friction > 0:
                dynamics.leave("friction is of joints of one coordinate", "friction")
        self.limits(joint, made)
        joint.leave_all("where a switch is, for a driver", "calibration")
        joint.leave_all("what a controller does about limits", "safety_controller")

    def limits(self, joint, made):
        limit = joint.one("limit")
        if limit is None:
            if joint.get("type") in ("revolute", "prismatic"):
                joint.problem(
                    f"the joint '{joint.get('name')}' has no limit, which a {joint.get('type')} one has: "
                    "<limit lower=\"-1\" upper=\"1\" effort=\"10\" velocity=\"1\"/>"
                )
            return
        made.most_effort, velocity = most(limit, "effort"), most(limit, "velocity")
        lower, upper = limit.number("lower", 0.0), limit.number("upper", 0.0)
        if joint.get("type") in ("revolute", "prismatic"):
            if lower < upper:
                effects.stop(self.model, made, lower, upper, velocity)
                if velocity:
                    self.model.unique_note(
                        "the velocity of a limit is the speed of impact of its stop; nothing limits speeds"
                    )
            else:
                limit.leave("lower is not below upper: there is no stop", "lower", "upper")
            return
        limit.leave(f"a {joint.get('type')} joint has no stop", "lower", "upper", "velocity")

    def mimics(self):
        """first = multiplier * second + offset: a gear, whose offset is that of the start."""
        for joint in self.joints.values():
            mimic = joint.one("mimic")
            if mimic is None or joint.get("name") not in self.made:
                continue
            other = mimic.name("joint")
            first, second = self.made[joint.get("name")], self.made.get(other)
            if other not in self.joints:
                mimic.problem(f"there is no joint '{other}'", "joint")
                continue
            if second is None or not (first.has_one_coordinate() and second.has_one_coordinate()) or first is second:
                mimic.leave("it is of joints of one coordinate that move")
                continue
            ratio, offset = mimic.number("multiplier", 1.0), mimic.number("offset", 0.0)
            first.continuous = second.continuous = False
            first.start = offset
            first.mimics = first.is_given = second.is_given = True
            effects.gear(self.model, self.model.name(f"{first.name}_mimic", "closure", True), first, second, ratio)
        self.chained_starts()

    def chained_starts(self):
        """A joint that follows one that follows: all stand where the first of them is at zero."""
        for _ in self.made:
            for joint in self.joints.values():
                mimic = joint.one("mimic")
                first = self.made.get(joint.get("name"))
                second = self.made.get(mimic.get("joint")) if mimic is not None else None
                if second is not None and first is not None and first.mimics:
                    first.start = mimic.number("multiplier", 1.0) * second.start + mimic.number("offset", 0.0)

    # --- drives ---

    def drive(self, joint, of, reduction=1.0):
        name = self.model.name(f"{joint.name}_effort", "input", True)
        most = joint.most_effort / abs(reduction)
        limits = (-most, most) if most > 0 else None
        self.model.inputs.append(Input(name, joint.effort(), limits, of))
        if reduction == 1.0 and not joint.drive:
            joint.drive = name
        else:
            effects.geared(self.model, joint, name, reduction)

    def drives(self):
        found = self.transmissions() + self.controls()
        if self.options.drives == "none":
            return
        for joint, of, reduction in found:
            self.drive(joint, of, reduction)
        if not found:
            moving = [self.made[name] for name in self.joints if name in self.made]
            movers = [joint for joint in moving if joint.has_one_coordinate() and not joint.mimics]
            for joint in movers:
                self.drive(joint, "")
            if movers:
                self.model.notes.append("no transmission is in the file: each joint that follows no other has a drive")

    def driven(self, element, name):
        """The joint of this name, if it can be driven."""
        if name not in self.joints:
            element.problem(f"there is no joint '{name}'", "name")
            return None
        joint = self.made.get(name)
        return joint if joint is not None and joint.has_one_coordinate() else None

    def transmissions(self):
        found = []
        for element in self.root.all("transmission"):
            joints = element.all("joint")
            if len(joints) != 1 or len(element.all("actuator")) > 1:
                element.leave("of several joints or actuators")
                continue
            joint = self.driven(joints[0].take(), joints[0].name())
            if joint is None or self.options.drives == "none":
                element.leave("its joint does not move" if joint is None else "--drives none")
                continue
            element.take("type")
            reduction = 1.0
            inner = [child for other in element.all("joint", "actuator") for child in other.children]
            for part in [*element.children, *inner]:
                if part.tag == "mechanicalReduction":
                    reduction = self.reduction(part.take())
                elif part.tag in ("type", "hardwareInterface", "actuator", "joint"):
                    part.take("name")
            found.append((joint, element.get("name", ""), reduction))
        return found

    def reduction(self, part):
        try:
            value = float(part.text)
        except ValueError:
            value = 0.0
        if value == 0.0:
            part.problem(f"'{part.text.strip()}' is no reduction: <mechanicalReduction>1</mechanicalReduction>")
            return 1.0
        return value

    def controls(self):
        """The joints of <ros2_control> that take commands."""
        found = []
        for system in self.root.all("ros2_control"):
            system.take("name", "type")
            for element in system.children:
                if element.tag != "joint":
                    element.leave("of a driver")
                    continue
                commands = element.all("command_interface")
                joint = self.driven(element, element.name()) if commands else None
                if joint is None or self.options.drives == "none":
                    element.leave("it takes no command")
                    continue
                element.take()
                for part in element.children:
                    if part.tag == "command_interface":
                        part.take("name").leave_all("of a driver")
                    else:
                        part.leave("of a driver")
                found.append((joint, system.get("name", ""), 1.0))
        return found

    # --- the rest ---

    def rest(self):
        for link in self.links.values():
            link.leave_all("a picture", "visual")
            link.leave_all("contact is of points and balls with the ground", "collision")
        self.root.leave_all("a picture", "material")
        self.root.leave_all("of a simulator", "gazebo")
        for joint in self.made.values():
            self.hold_idle(joint)
        if self.weightless:
            self.model.notes.append(
                f"without an <inertial> these links weigh nothing, since a shape or a mesh of URDF has no density: "
                f"{', '.join(self.weightless)}"
            )
        self.note_rounded()


def outputs(model):
    for joint in model.joints.values():
        if joint.has_one_coordinate():
            model.outputs.append((joint.name, f"position of {joint.name}"))
        elif joint.kind != "fixed":
            model.outputs.append((f"{joint.child}_place", f"position of {joint.child}"))
            model.outputs.append((f"{joint.child}_orientation", f"orientation of {joint.child}"))
    model.outputs.append(("energy", "energy"))
