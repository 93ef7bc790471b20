"""<actuator> and <tendon> of MJCF: inputs, and effects that turn them into efforts.

force = gain (control or activation) + bias; gain and bias depend on the driven length and on its rate; the effort of a
joint is the force times the change of that length by its coordinate.
"""
import math
from dataclasses import dataclass, field

from equality import distance
from forces import SETTERS, Force, force_of
from model import Input, Use
from place import apply
from scene import long_block, number, point, vector
from settings import SWITCHED_OFF

KINDS = tuple(SETTERS)
GAINS = ("gain", "gain_by_length", "gain_by_rate", "bias", "bias_by_length", "bias_by_rate")
OF_JOINTS = """limited solreflimit solimplimit margin frictionloss solreffriction solimpfriction armature
actuatorfrcrange actuatorfrclimited""".split()
LEAST = 1e-15  # the square of a ratio that counts, as in MuJoCo
NOT_KINDS = {"muscle": "muscles", "adhesion": "adhesion", "plugin": "plugins", "dcmotor": "no such motor"}


@dataclass
class Length:
    """The target of an actuator: joints with ratios; or two points of bodies; or a wrench on a body."""

    joints: list = field(default_factory=list)  # (joint, ratio)
    zero: float = 0.0  # the length where all coordinates are zero
    points: list = None  # two (carrier, place)
    scale: float = 1.0
    wrench: tuple = None  # carrier, place, six numbers


def read_tendons(reader):
    for element in reader.parts_of("tendon"):
        tendon(reader, element)


def read(reader):
    for element in reader.parts_of("actuator"):
        if "actuation" in reader.settings.off:
            element.leave(SWITCHED_OFF)
        elif element.tag in NOT_KINDS:
            reader.found(element, "", [*KINDS, *NOT_KINDS]).leave(NOT_KINDS[element.tag])
        elif element.tag in KINDS:
            actuator(reader, reader.found(element, "", KINDS))


# --- tendons ---


def tendon(reader, element):
    if element.tag not in ("fixed", "spatial"):
        return
    found = reader.found(element, "", ["tendon"])
    name = found.get("name") or f"tendon{len(reader.tendons) + 1}"
    length = fixed(reader, found) if element.tag == "fixed" else spatial(reader, found)
    found.leave("only seen", "width", "material", "rgba", "group", "user")
    found.leave("limits, friction and armature are of joints", *OF_JOINTS)
    if found.has("range"):
        reader.ranges_of["tendon", name] = found.numbers("range", 2)
        found.leave("limits, friction and armature are of joints; inheritrange reads it", "range")
    reader.tendons[name] = None
    if length is None:
        found.leave("a tendon goes straight between two sites, or is a sum of joints")
        return
    if length.points is None and not length.joints:
        found.leave("none of its joints moves")
        return
    if length.points is not None and length.points[0][0] == length.points[1][0]:
        found.leave("both of its ends are on one body of the scene")
        return
    reader.tendons[name] = length
    stiffness, damping = found.number("stiffness", 0.0), found.number("damping", 0.0)
    stiffness = 0.0 if "spring" in reader.settings.off else stiffness
    damping = 0.0 if "damper" in reader.settings.off else damping
    if stiffness == 0 and damping == 0:
        return
    rest = found.numbers("springlength", (1, 2), [-1.0])
    now = length.zero if length.points is None else distance(reader, length.points)
    low, high = (now, now) if rest == [-1.0] else (rest[0], rest[-1])
    if length.points is not None and low == high:
        (one, at_one), (other, at_other) = length.points
        own = reader.model.name(name, "spring")
        lines = [
            f"between {one}{point(at_one)} and {other}{point(at_other)}",
            f"stiffness {number(stiffness)} N/m",
            *([f"damping {number(damping)} N*s/m"] if damping else []),
            f"length {number(low)} m",
        ]
        reader.model.effects.append(Use(f"spring {own}", lines))
        return
    if low != high:
        found.leave("the middle of the two counts", "springlength")
    write(reader, name, length, Force(gain=[0.0] * 3, bias=[stiffness * (low + high) / 2, -stiffness, -damping]))


def fixed(reader, found):
    length = Length()
    for child in found.element.children:
        child.take()
        joint = child.name("joint")
        if joint not in reader.joints:
            child.problem(f"there is no joint '{joint}'", "joint")
            return None
        made, ref = reader.joints[joint]
        ratio = child.number("coef", 1.0)
        if not made.has_one_coordinate():
            if made.kind != "fixed":
                return None
        elif ratio != 0:
            length.joints.append((made, ratio))
            length.zero += ratio * ref
    return length


def spatial(reader, found):
    sites = [child for child in found.element.children if child.tag == "site"]
    if len(found.element.children) != 2 or len(sites) != 2:
        return None
    points = []
    for child in sites:
        name = child.take().name("site")
        if name not in reader.sites:
            child.problem(f"there is no site '{name}'", "site")
            return None
        points.append(reader.sites[name])
    return Length(points=points)


# --- actuators ---


def actuator(reader, found):
    length = target(reader, found)
    force = force_of(found, reader.settings.autolimits)
    found.leave("of MuJoCo's own", "group", "user", "lengthrange", "actearly", "actdim", "nsample", "interp", "delay")
    if length is None or force is None:
        return
    if force.is_servo() and force.bias[2] > 0:
        damp(reader, found, length, force)
    name = found.get("name") or (f"{length.joints[0][0].name}_control" if length.joints else "control")
    limits = found.numbers("ctrlrange", 2)
    if force.is_servo() and force.share > 0:
        inherited = inherit(reader, found, force)
        if force.dynamics != "integrator":
            limits = inherited
        elif found.flag("actlimited", reader.settings.autolimits):
            force.active = inherited
    limited = found.is_limited("ctrllimited", limits, reader.settings.autolimits)
    if limits is not None and (not limited or "clampctrl" in reader.settings.off):
        found.leave("the control is not limited", "ctrlrange")
        limits = None
    if limits is not None and limits[0] >= limits[1]:
        found.problem("the lower end of ctrlrange is below the upper one", "ctrlrange")
        return
    input_name = reader.model.name(name, "input", not found.get("name"))
    plain = direct(length, force)
    unit = length.joints[0][0].effort() if plain else ""
    reader.model.inputs.append(
        Input(input_name, unit, tuple(limits) if limits is not None else None, "" if input_name == name else name)
    )
    if plain:
        length.joints[0][0].drive = input_name
        reader.efforts.append((length.joints[0][0].name, input_name))
        return
    force.control = input_name
    write(reader, name, length, force)


def direct(length, force):
    """A motor whose control is the effort of one joint that has no other drive."""
    return (
        len(length.joints) == 1
        and length.joints[0][1] * force.gain[0] == 1
        and force.is_motor()
        and not length.joints[0][0].drive
    )


def target(reader, found):
    gear = [*found.numbers("gear", (1, 6), [1.0]), 0.0, 0.0, 0.0, 0.0, 0.0][:6]
    ways = [key for key in ("joint", "jointinparent", "tendon", "site", "slidersite", "body") if found.has(key)]
    if len(ways) != 1:
        found.problem("an actuator drives one joint, tendon or site: joint=\"...\"")
        return None
    text = found.get(ways[0])
    known = {"joint": reader.joints, "jointinparent": reader.joints, "tendon": reader.tendons, "site": reader.sites}
    if ways[0] not in known:
        found.leave(f"nothing drives a {ways[0]}")
        return None
    if text not in known[ways[0]]:
        found.problem(f"there is no {ways[0]} '{text}'", ways[0])
        return None
    if ways[0] == "tendon":
        length = reader.tendons[text]
        if length is None:
            found.leave("its tendon is not taken")
            return None
        return Length(
            [(made, gear[0] * ratio) for made, ratio in length.joints], gear[0] * length.zero, length.points, gear[0]
        )
    if ways[0] == "site":
        if found.has("refsite"):
            found.leave("nothing drives one site against another")
            return None
        carrier, place = reader.sites[text]
        if carrier == "ground":
            found.leave("its site stands on the ground")
            return None
        return Length(wrench=(carrier, place, gear))
    made, ref = reader.joints[text]
    if made.kind == "fixed":
        found.leave("its joint is held")
        return None
    if not made.has_one_coordinate():
        found.leave("a drive is of a joint of one coordinate")
        return None
    return Length([(made, gear[0])], gear[0] * ref)


def damp(reader, found, length, force):
    """dampratio: the damping in units of that of a mass on the spring of the servo, of the joints' inertias where the file
    draws them, each over the square of its ratio."""
    ratio, force.bias[2] = force.bias[2], 0.0
    if length.wrench is not None:
        found.leave("a thrust has no damping", "dampratio")
        return
    if force.gain[0] < 0:
        found.problem("kp is below zero, and dampratio takes its root", "kp")
        return
    of_masses = reader.mass_matrix(found)
    moments = of_masses.moments_of(length)
    mass = sum(of_masses.entries[i][i] / x**2 for i, x in enumerate(moments) if x**2 > LEAST)
    force.bias[2] = -2 * ratio * math.sqrt(force.gain[0] * mass)


def inherit(reader, found, force):
    """inheritrange: limits about the middle of the range of what the actuator drives, so many times as wide."""
    way = next((key for key in ("joint", "tendon") if found.has(key)), None)
    limits = reader.ranges_of.get((way, found.get(way) if way else None))
    name = "actrange" if force.dynamics == "integrator" else "ctrlrange"
    if found.has(name):
        found.problem(f"{name} and inheritrange: one is right", "inheritrange")
    elif limits is None or limits[0] >= limits[1]:
        found.problem("inheritrange needs a joint or a tendon with a range", "inheritrange")
    else:
        middle, radius = (limits[0] + limits[1]) / 2, (limits[1] - limits[0]) / 2 * force.share
        return (middle - radius, middle + radius)
    return None


# --- effects ---


def write(reader, name, length, force):
    """The effect of an actuator, and the definition of its kind."""
    model = reader.model
    own = f"{name}_drive" if force.control else name
    if length.wrench is not None:
        model.kinds["thrust"] = THRUST
        carrier, place, gear = length.wrench
        push, twist = apply(place.turn, gear[:3]), apply(place.turn, gear[3:])
        gain = force.gain[0]
        if not force.is_motor():
            model.unique_note(
                f"{name}: a thrust is its gain times the control; limits, bias and dynamics are not taken"
            )
        model.effect(
            own,
            "thrust",
            f"place {carrier}{point(place)}",
            f"control {force.control}",
            f"push {vector([gain * x for x in push])} N",
            f"twist {vector([gain * x for x in twist])} N*m",
        )
        unlimited(reader, name)
        return
    if force.is_motor() and len(length.joints) == 1:
        made, ratio = length.joints[0]
        model.kinds["motor"] = MOTOR
        size = f"{number(ratio * force.gain[0])} {made.effort()}"
        model.effect(own, "motor", f"along {made.name}", f"control {force.control}", f"ratio {size}")
        reader.efforts.append((made.name, f"({size}) * {force.control}"))
        return
    kind, text = definition(length, force)
    model.kinds[kind] = text
    lines = [f"along{k + 1} {made.name}" for k, (made, _) in enumerate(length.joints)]
    lines += [f"ratio{k + 1} {number(ratio)}" for k, (_, ratio) in enumerate(length.joints)]
    if length.points is not None:
        (one, at_one), (other, at_other) = ground_first(length.points)
        first = f"one {one}{point(at_one)}" if one != "ground" else f"one {vector(at_one.at)} m"
        lines += [first, f"other {other}{point(at_other)}", f"ratio {number(length.scale)}"]
    if force.control:
        lines.append(f"control {force.control}")
    lines += [f"{key} {number(x)}" for key, x in zip(GAINS, (*force.gain, *force.bias)) if x]
    if length.zero:
        lines.append(f"zero {number(length.zero)}")
    if force.limits is not None:
        lines += [f"least {number(force.limits[0])}", f"most {number(force.limits[1])}"]
    if force.dynamics == "filter":
        lines.append(f"lag {number(force.time)} s")
    if force.active is not None:
        lines += [f"lowest {number(force.active[0])}", f"highest {number(force.active[1])}"]
    effect = model.effect(own, kind, *lines)
    if force.control:
        for made, ratio in length.joints:
            reader.efforts.append((made.name, f"({number(ratio)} {made.effort()}) * {effect}.force"))
        if length.points is not None:
            unlimited(reader, name)


def unlimited(reader, name):
    """Says that the limits of joints leave out an actuator that drives no joint by name."""
    if reader.effort_limits:
        reader.model.unique_note(f"actuatorfrcrange: the limits of joints do not count {name}, which drives no joint by name")


def ground_first(points):
    """Two ends, of which the ground, if it is one, comes first: it is a fixed point, and takes no force."""
    return sorted(points, key=lambda end: end[0] != "ground")


def definition(length, force):
    """The kind of an effect, by its parts: its name and its text."""
    is_hung = length.points is not None and ground_first(length.points)[0][0] == "ground"
    ends = "".join("t" if made.turns() else "s" for made, _ in length.joints) or ("hung" if is_hung else "line")
    parts = [ends] + [force.dynamics] * (force.dynamics != "none") + ["kept"] * (force.active is not None)
    parts += ["limited"] * (force.limits is not None)
    kind = "_".join(["servo" if force.control else "strain", *parts])
    count = range(1, len(length.joints) + 1)
    lines = [f"joint along{k}" for k in count] + [f"value ratio{k} = 1" for k in count]
    if length.points is not None:
        lines += ["value one = (0, 0, 0) m" if is_hung else "body one", "body other", "value ratio = 1"]
    lines += ["signal control"] * bool(force.control)
    lines += ["value zero = 0                          # the length where all positions are zero"]
    lines += [f"value {key} = 0" for key in GAINS]
    if length.points is not None:
        lines += [
            f"let gap = position of other - {'one' if is_hung else 'position of one'}",
            "let away = gap / norm(gap)",
            "let length = ratio * norm(gap) / 1 m",
            f"let by_time = ratio * dot(away, velocity of other{'' if is_hung else ' - velocity of one'}) / 1 m * 1 s",
        ]
    else:
        units = [made.unit() for made, _ in length.joints]
        lines += [
            "let length = "
            + " + ".join(["zero", *(f"ratio{k} * position of along{k} / 1 {unit}" for k, unit in zip(count, units))]),
            "let by_time = "
            + " + ".join(f"ratio{k} * speed of along{k} / 1 {unit} * 1 s" for k, unit in zip(count, units)),
        ]
    signal = "control"
    if force.dynamics != "none":
        signal = "activation"
        lines += ["value lag s"] * (force.dynamics == "filter") + ["state activation = 0"]
        rate = "(control - activation) / lag" if force.dynamics == "filter" else "control / 1 s"
        if force.active is not None:
            signal = "clamp(activation, lowest, highest)"
            lines += ["value lowest", "value highest", f"let free = {rate}"]
            rate = "if(activation < lowest, max(free, 0), if(activation > highest, min(free, 0), free))"
        lines.append(f"rate activation = {rate}")
    gain = f"(gain + gain_by_length * length + gain_by_rate * by_time) * {signal} + " if force.control else ""
    whole = f"{gain}bias + bias_by_length * length + bias_by_rate * by_time"
    if force.limits is not None:
        lines += ["value least", "value most"]
        whole = f"clamp({whole}, least, most)"
    lines.append(f"let force = {whole}")
    if length.points is not None:
        lines.append(f"force on other{'' if is_hung else ' against one'} = ratio * force * 1 N * away")
    lines += [
        f"effort on along{k} = ratio{k} * force * 1 {made.effort()}" for k, (made, _) in zip(count, length.joints)
    ]
    lines.append("output force")
    note = "# What an actuator of MuJoCo does, in its numbers: SI, without units."
    return kind, "\n".join([note, *long_block(f"effect {kind}", lines)])


MOTOR = """
# A motor: its control, a number, times the effort that one has.
effect motor {
    joint along
    signal control
    value ratio like effort of along
    effort on along = ratio * control
}"""

THRUST = """
# A force and a moment at a place of a body, in its axes, times a number.
effect thrust {
    body place
    signal control
    value push = (0, 0, 0) N
    value twist = (0, 0, 0) N*m
    force on place in body = control * push
    moment on place in body = control * twist
}"""
