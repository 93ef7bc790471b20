"""<equality> of MJCF: closures and gears. What they hold is what holds where the file draws the bodies."""
from model import Use
from place import Place, of_quaternion
from scene import number, where

SOFT = "a closure is hard"


def read(reader):
    for group in reader.root.all("equality"):
        group.take()
        for element in group.children:
            maker = {"connect": connect, "weld": weld, "joint": joint}.get(element.tag)
            if maker is None:
                element.leave("only connect, weld and joint are closures")
                continue
            found = reader.found(element)
            for name in ("solref", "solimp"):
                found.leave(SOFT, name)
            if found.get("active", "true") == "false":
                found.leave("it is not active")
                continue
            maker(reader, found)
    if reader.model.closures:
        reader.model.notes.append("an equality is a closure, which is hard; MuJoCo's is soft")
        for made, _ in reader.joints.values():
            made.is_given = True


def globals_of(model):
    """The place of each body where all coordinates are zero."""
    places = {"ground": Place()}
    for made in model.joints.values():
        start = made.start_place or Place()
        places[made.child] = places[made.parent] * made.parent_place * start * made.child_place.inverse()
    return places


def body(reader, found, name, default=None):
    text = found.get(name, default)
    if text is None:
        found.problem(f"<{found.element.tag}> has no {name}")
    elif text not in reader.carrier:
        found.problem(f"there is no body '{text}'", name)
    return reader.carrier.get(text, ("ground", Place()))


def named(reader, found, one, other):
    return reader.model.name(found.get("name") or f"{one}_to_{other}", "closure", not found.get("name"))


def ends(reader, found):
    """The two sides of a connect or a weld: carriers and places."""
    if found.has("site1") or found.has("site2"):
        sides = []
        for name in ("site1", "site2"):
            site = found.get(name)
            if site not in reader.sites:
                found.problem(f"there is no site '{site}'", name)
                return None
            sides.append(reader.sites[site])
        return sides
    return [body(reader, found, "body1"), body(reader, found, "body2", "world")]


def close(reader, found, kind, first, second):
    (one, at_one), (other, at_other) = first, second
    if one == other:
        found.leave("both sides are one body of the scene")
        return
    name = named(reader, found, one, other)
    reader.model.closures.append(
        Use(f"close {name} {kind}", [f"parent {one}{where(at_one)}", f"child {other}{where(at_other)}"])
    )


def connect(reader, found):
    sides = ends(reader, found)
    if sides is None:
        return
    (one, at_one), (other, at_other) = sides
    if not found.has("site1"):
        anchor = found.numbers("anchor", 3)
        if anchor is None:
            found.problem("a connect has an anchor: anchor=\"0 0 0\"")
            return
        places = globals_of(reader.model)
        at_one = Place(at_one.point(anchor))
        at_other = Place(places[other].inverse().point(places[one].point(at_one.at)))
    close(reader, found, "spherical", (one, Place(at_one.at)), (other, Place(at_other.at)))


def weld(reader, found):
    sides = ends(reader, found)
    if sides is None:
        return
    (one, at_one), (other, at_other) = sides
    found.leave(SOFT, "torquescale")
    found.leave("a weld holds all of a body, wherever its anchor is", "anchor")
    pose = found.numbers("relpose", 7)
    if not found.has("site1"):
        places = globals_of(reader.model)
        if pose is not None and any(pose[3:]):
            at_one = at_one * Place(pose[:3], of_quaternion(pose[3:]))
        else:
            at_one = places[one].inverse() * places[other] * at_other
    close(reader, found, "fixed", (one, at_one), (other, at_other))


def joint(reader, found):
    """joint1 = a + b joint2, each from where the file draws it; higher powers are no gear."""
    name, other = found.get("joint1"), found.get("joint2")
    for which, text in (("joint1", name), ("joint2", other)):
        if text not in reader.joints and not (which == "joint2" and text is None):
            found.problem(f"there is no joint '{text}'", which)
            return
    coefficients = [*found.numbers("polycoef", (1, 5), [0.0, 1.0, 0.0, 0.0, 0.0]), 0.0, 0.0, 0.0, 0.0][:5]
    if any(coefficients[2:]):
        found.leave("a polynomial is no gear: polycoef with two numbers is")
        return
    first = reader.joints[name][0]
    second = reader.joints[other][0] if other is not None else None
    if not first.has_one_coordinate() or (second is not None and not second.has_one_coordinate()):
        found.leave("of joints of one coordinate that move")
        return
    if second is None:
        closure = named(reader, found, first.name, "place")
        first.start = coefficients[0]
        reader.model.closures.append(
            Use(f"close {closure} motion", [f"first {first.name}", f"motion {number(coefficients[0])} {first.unit()}"])
        )
        return
    closure = named(reader, found, first.name, second.name)
    first.start = coefficients[0] + coefficients[1] * second.start
    unit = "" if first.unit() == second.unit() else f" {first.unit()}/{second.unit()}"
    reader.model.closures.append(
        Use(
            f"close {closure} gear",
            [f"first {first.name}", f"second {second.name}", f"ratio {number(coefficients[1])}{unit}"],
        )
    )
