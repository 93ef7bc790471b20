"""The text of a scene."""
import math
import textwrap

from place import QUARTER, UNTURNED, Place, quaternion


def number(x):
    """The shortest text that is read as this number; of one below the least of a float, zero."""
    x = 0.0 if abs(x) < 2.0**-126 else float(x)
    text = repr(x)
    return text[:-2] if text.endswith(".0") else text


def vector(v):
    return f"({', '.join(number(x) for x in v)})"


def axis_of(v):
    for k, name in enumerate("xyz"):
        if v[k] != 0 and all(v[i] == 0 for i in range(3) if i != k):
            return name if v[k] > 0 else f"-{name}"
    return vector(v)


def angle(x):
    quarters = x / QUARTER
    if abs(quarters - round(quarters)) < 1e-14 * max(1.0, abs(quarters)):
        return f"{90 * round(quarters)} deg"
    return f"{number(x)} rad"


def turns(place):
    words = []
    for size, axis in place.steps():
        name = axis_of(axis)
        if name.startswith("-"):
            size, name = -size, name[1:]
        words.append(f"rotate {angle(size)} about {name}")
    return " ".join(words)


def point(place):
    return f" at {vector(place.at)} m" if any(place.at) else ""


def where(place):
    """` at (...) m rotate ...`, or nothing."""
    return point(place) + (f" {turns(place)}" if place.turn != UNTURNED else "")


def inertia(values):
    diagonal = ", ".join(number(x) for x in values[:3])
    return f"({diagonal})" if not any(values[3:]) else f"({diagonal}; {', '.join(number(x) for x in values[3:])})"


def comment(lines):
    wrap = textwrap.TextWrapper(
        118, initial_indent="# ", subsequent_indent="#     ", break_long_words=False, break_on_hyphens=False
    )
    result = []
    for line in lines:
        line = "".join(c if c.isprintable() else " " for c in line)
        result += wrap.wrap(line) or ["#"]
    return result


def long_block(head, lines):
    return [f"{head} {{", *(f"    {line}" for line in lines), "}"]


def block(head, lines):
    """A statement with braces, on one line where it fits."""
    short = f"{head} {{ {'; '.join(lines)} }}"
    return [short] if len(short) <= 100 and len(lines) <= 4 else long_block(head, lines)


def solid_lines(solid, several):
    """A body of one part has a mass, a centre and an inertia; one of several has solids."""
    of = f"    # {solid.of}" if solid.of and several else ""
    mass = number(solid.mass)
    if solid.text:
        return [f"{solid.text} of {mass} kg{where(solid.place)}{of}"]
    given = " as_given" if solid.is_as_given else ""
    if several:
        return [f"lump {inertia(solid.inertia)} kg*m^2{given} of {mass} kg{where(solid.place)}{of}"]
    lines = [f"mass {mass} kg"]
    if any(solid.place.at):
        lines.append(f"com {vector(solid.place.at)} m")
    if any(solid.inertia):
        rotated = turns(solid.place)
        lines.append(f"inertia {inertia(solid.inertia)} kg*m^2{given}{' ' + rotated if rotated else ''}")
    return lines


def body_text(body):
    solids = [solid for solid in body.solids if solid.mass > 0]
    lines = [line for solid in solids for line in solid_lines(solid, len(solids) > 1)]
    if len(lines) < 2 and not any("#" in line for line in lines):
        return [f"body {body.name} {{ {(lines or ['mass 0'])[0]} }}"]
    return long_block(f"body {body.name}", lines)


def speed_lines(joint):
    """Speeds at the start: along axes of the ground, and about those of the child."""
    if joint.has_one_coordinate():
        return [f"speed {number(joint.speeds[0])} {joint.unit()}/s"]
    along = [f"speed {vector(joint.speeds[:3])} m/s"] if joint.kind == "free" else []
    return [*along, f"spin {vector(joint.speeds[-3:])} rad/s"]


def joint_text(joint):
    lines = [f"parent {joint.parent}{where(joint.parent_place)}", f"child {joint.child}{where(joint.child_place)}"]
    unit = joint.unit()
    if joint.kind in ("revolute", "prismatic", "planar"):
        lines.append(f"axis {axis_of(joint.axis)}")
    if joint.has_one_coordinate() and (joint.start or joint.is_given):
        lines.append(f"start {angle(joint.start) if joint.turns() else number(joint.start) + ' m'}")
    start_place = joint.key_place or joint.start_place or Place()
    if joint.kind == "spherical" and (joint.is_given or joint.key_place is not None):
        lines.append(f"start quaternion {vector(quaternion(start_place.turn))}")
    elif joint.kind == "free" and joint.is_given:
        turned = turns(start_place) if start_place.turn != UNTURNED else "rotate 0 deg about z"
        lines.append(f"start at {vector(start_place.at)} m {turned}")
    elif where(start_place):
        lines.append(f"start{where(start_place)}")
    if any(joint.speeds):
        lines += speed_lines(joint)
    if joint.continuous:
        lines.append("continuous")
    if joint.damping and joint.kind in ("spherical", "free"):
        lines.append(f"spin_damping {number(joint.damping)} N*m*s/rad")
    if joint.damping and joint.kind != "spherical":
        lines.append(f"damping {number(joint.damping)} {joint.effort()}*s/{unit}")
    if joint.spring:
        rest = f" rest {number(joint.rest)} {unit}" if joint.rest else ""
        lines.append(f"spring {number(joint.spring)} {joint.effort()}/{unit}{rest}")
    if joint.armature and joint.kind in ("spherical", "free"):
        lines.append(f"spin_armature {number(joint.armature)} kg*m^2")
    if joint.armature and joint.kind != "spherical":
        lines.append(f"armature {number(joint.armature)} {'kg*m^2' if joint.turns() else 'kg'}")
    if joint.drive:
        lines.append(f"drive {joint.drive}")
    return long_block(f"joint {joint.name} {joint.kind}", lines)


def input_text(found):
    of = f"    # {found.of}" if found.of else ""
    unit = f" {found.unit}" if found.unit else ""
    limits = f" in {number(found.limits[0])}{unit} to {number(found.limits[1])}{unit}" if found.limits else ""
    # A plain number has a value: of its limits that nearest to zero.
    least, most = found.limits or (0, 0)
    value = unit or f" = {number(max(least, min(most, 0)))}"
    return f"input {found.name}{value}{limits}{of}"


def scene_text(model, head):
    """The whole scene: `head` is the text of its first comment."""
    lines = comment(head)
    step = model.step * 1e9
    step = f"{number(step / 1e6)} ms" if math.isclose(step, round(step), rel_tol=1e-9) else f"{round(step)} ns"
    lines += [
        "",
        *([f"gravity {vector(model.gravity)} m/s^2"] if any(model.gravity) else []),
        f"step {step}",
        f"method {model.method}",
        *([f"stabilisation {model.stabilisation}"] if model.stabilisation else []),
    ]
    for text in model.kinds.values():
        lines += ["", *text.strip().splitlines()]
    if model.inputs:
        lines += ["", *(input_text(found) for found in model.inputs)]
    for body in model.bodies.values():
        lines += ["", *body_text(body)]
    if model.frames:
        lines += [""]
    lines += [f"frame {name} {{ on {body}{where(place)} }}" for name, body, place in model.frames]
    for joint in model.joints.values():
        lines += ["", *joint_text(joint)]
    for uses in (model.closures, model.effects):
        if uses:
            lines.append("")
        for use in uses:
            lines += block(use.head, use.lines)
    lines.append("")
    lines += [f"output {name} = {formula}" for name, formula in model.outputs]
    return "\n".join(lines) + "\n"
