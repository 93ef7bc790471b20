"""Loads of MJCF beside actuators: springs of ball and free joints, `springdamper`, `gravcomp`, and the limits of all
actuators of a joint together.

https://mujoco.readthedocs.io/en/stable/XMLreference.html, body and body/joint."""
from model import outboard
from place import add, norm, scale
from scene import number, point, vector


def joint(reader, found, made):
    """Reads what a joint has of these."""
    spring = found.numbers("springdamper", 2, [0.0, 0.0])
    limits = found.numbers("actuatorfrcrange", 2)
    limited = found.is_limited("actuatorfrclimited", limits, reader.settings.autolimits)
    compensated = found.flag("actuatorgravcomp", False)
    if any(spring) and min(spring) <= 0:
        found.problem("springdamper is a time and a ratio above zero: springdamper=\"0.1 1\"", "springdamper")
    elif any(spring):
        reader.springdampers.append((found, made, *spring))
    if not made.has_one_coordinate():
        return
    if limited and limits[0] >= limits[1]:
        found.problem("the lower end of actuatorfrcrange is below the upper one", "actuatorfrcrange")
    elif limited:
        reader.effort_limits[made.name] = (made, limits)
    elif limits is not None:
        found.leave("the actuators of the joint are not limited", "actuatorfrcrange")
    if compensated:
        reader.compensated.add(made.name)
        if "actuation" in reader.settings.off:  # then they do not act on it either
            reader.effort_limits[made.name] = (made, (0.0, 0.0))


# --- springs ---


def springs(reader):
    """Once all masses are known: stiffness and damping of `springdamper`, and the springs of ball and free joints."""
    for found, made, time, ratio in reader.springdampers:
        if made.kind == "fixed":
            continue
        inertia = reader.mass_matrix(found).inertia_of(made)
        if "spring" not in reader.settings.off:
            made.spring = inertia / (time * ratio) ** 2
        if "damper" not in reader.settings.off:
            made.damping = 2 * inertia / time
    for made in reader.model.joints.values():
        if made.spring and made.kind in ("spherical", "free"):
            of_several(reader.model, made)


def of_several(model, made):
    """A spring in all directions, to where the file draws the child."""
    stiffness, made.spring = made.spring, 0.0
    place = made.start_place if made.kind == "free" else made.parent_place
    lines = [f"part {made.child}{point(made.child_place)}"]
    if made.parent == "ground":
        kind = "turn_spring_to_ground"
        axes = zip("xyz", zip(*place.turn))
        lines += [f"{name} {vector(axis)}" for name, axis in axes]
    else:
        kind = "turn_spring"
        seat = model.name(f"{made.name}_seat", "frame", True)
        model.frames.append((seat, made.parent, place))
        lines.append(f"seat {seat}")
    model.kinds[kind] = TURN_SPRING[kind]
    model.effect(f"{made.name}_spring", kind, *lines, f"stiffness {number(stiffness)} N*m/rad")
    if made.kind == "free":
        model.kinds["place_spring"] = PLACE_SPRING
        model.effect(
            f"{made.name}_pull",
            "place_spring",
            f"part {made.child}",
            f"rest {vector(place.at)} m",
            f"stiffness {number(stiffness)} N/m",
        )


def turn_spring(kind, operands, axes):
    """A moment against the turn of a part: its angle along its axis. Half the sum of the products of the axes before and
    after is the sine along the axis, and half the trace less one the cosine."""
    pairs = [(f"{name}_axis of part", axis) for name, axis in zip("xyz", axes)]
    return f"""
# A spring against the turn of a body, the same about all axes.
effect {kind} {{
    body part
{operands}
    value stiffness N*m/rad
    let across = ({' + '.join(f'cross({axis}, {now})' for now, axis in pairs)}) / 2
    let cosine = ({' + '.join(f'dot({axis}, {now})' for now, axis in pairs)} - 1) / 2
    let angle = atan2(norm(across), cosine)
    moment on part{' against seat' if 'seat' in operands else ''} = -stiffness * angle / norm(across) * across
    energy = stiffness * angle^2 / 2
}}"""


TURN_SPRING = {
    "turn_spring": turn_spring("turn_spring", "    body seat", [f"{name}_axis of seat" for name in "xyz"]),
    "turn_spring_to_ground": turn_spring(
        "turn_spring_to_ground", "\n".join(f"    value {name} = (0, 0, 0)" for name in "xyz"), "xyz"
    ),
}

PLACE_SPRING = """
# A spring to a place of the ground, the same along all axes.
effect place_spring {
    body part
    value rest = (0, 0, 0) m
    value stiffness N/m
    let away = position of part - rest
    force on part = -stiffness * away
    energy = stiffness * dot(away, away) / 2
}"""


# --- gravity ---


def body(reader, element, name, carrier, solids):
    """Reads how much of the weight of a body a force carries."""
    share = element.number("gravcomp", 0.0)
    if share and carrier != "ground":
        reader.lifts.append((name, carrier, solids, share))


def lifts(reader):
    """Once all masses are known: forces at the centres of bodies."""
    if not any(reader.model.gravity) or "passive" in reader.settings.off:
        reader.lifts = []
    placed = []
    for name, carrier, solids, share in reader.lifts:
        mass = sum(solid.mass for solid in solids)
        if mass == 0:
            continue
        centre = (0.0, 0.0, 0.0)
        for solid in solids:
            centre = add(centre, scale(solid.mass / mass, solid.place.at))
        lift = scale(-share * mass, reader.model.gravity)
        reader.model.kinds["gravcomp"] = GRAVCOMP
        at = f"{carrier} at {vector(centre)} m" if any(centre) else carrier
        reader.model.effect(f"{name}_lift", "gravcomp", f"part {at}", f"lift {vector(lift)} N")
        placed.append((name, carrier, at, lift))
    reader.lifts = placed


GRAVCOMP = """
# A force that carries a share of the weight of a part, at its centre of mass.
effect gravcomp {
    body part
    value lift = (0, 0, 0) N
    force on part = lift
    energy = -dot(lift, position of part)
}"""


# --- limits of all actuators of a joint ---


def limits(reader):
    """Once all actuators are read: the sum of their efforts on a joint is within limits, with the part of the lifts that
    counts as theirs."""
    model = reader.model
    for made, (least, most) in reader.effort_limits.values():
        if made.kind == "fixed":
            continue
        terms = [text for name, text in reader.efforts if name == made.name]
        if made.name in reader.compensated:
            terms += lifted(reader, made)
        if not terms:
            continue
        model.kinds["actuator_limit"] = ACTUATOR_LIMIT
        unit = made.effort()
        model.effect(
            f"{made.name}_limit",
            "actuator_limit",
            f"along {made.name}",
            f"actuators {' + '.join(terms)}",
            f"least {number(least)} {unit}",
            f"most {number(most)} {unit}",
        )


def lifted(reader, made):
    """The efforts of lifts on a joint, by the names of outputs of effects."""
    model, terms = reader.model, []
    behind = set(outboard(model, made.child))
    for name, carrier, at, lift in reader.lifts:
        if carrier not in behind:
            continue
        kind = "lift_that_turns" if made.turns() else "lift_that_slides"
        model.kinds[kind] = LIFTED[kind]
        effect = model.effect(
            f"{name}_lift_on_{made.name}",
            kind,
            *([f"part {at}"] if made.turns() else []),
            f"hub {made.child}{point(made.child_place)}",
            f"axis {vector(scale(1 / norm(made.axis), made.axis))}",
            f"lift {vector(lift)} N",
        )
        terms.append(f"{effect}.effort")
    return terms


ACTUATOR_LIMIT = """
# All actuators of a joint together, within limits: this adds what they have too much or too little.
effect actuator_limit {
    joint along
    signal actuators like effort of along
    value least like effort of along
    value most like effort of along
    effort on along = clamp(actuators, least, most) - actuators
}"""

AXIS = "dot(axis, (1, 0, 0)) * x_axis of hub + dot(axis, (0, 1, 0)) * y_axis of hub + dot(axis, (0, 0, 1)) * z_axis of hub"
LIFTED = {
    "lift_that_turns": f"""
# The effort of a lift on a joint that turns about an axis of its child.
effect lift_that_turns {{
    body part
    body hub
    value axis = (0, 0, 0)
    value lift = (0, 0, 0) N
    let along = {AXIS}
    output effort = dot(along, cross(position of part - position of hub, lift))
}}""",
    "lift_that_slides": f"""
# The effort of a lift on a joint that slides along an axis of its child.
effect lift_that_slides {{
    body hub
    value axis = (0, 0, 0)
    value lift = (0, 0, 0) N
    let along = {AXIS}
    output effort = dot(along, lift)
}}""",
}
