"""Loads on joints, as effects of the scene."""
from scene import number


def stop(model, joint, lower, upper, impact=0.0):
    """The limits of a joint. The default speed of impact is half of the range in a second."""
    unit = joint.unit()
    speed = impact or max((upper - lower) / 2, 1e-3)
    model.effect(
        f"{joint.name}_stop",
        "stop",
        f"along {joint.name}",
        f"lower {number(lower)} {unit}",
        f"upper {number(upper)} {unit}",
        f"impact {number(speed)} {unit}/s",
    )
    joint.continuous = False


def friction(model, joint, size):
    sliding = f"sliding {number(size)} {joint.effort()}"
    model.effect(f"{joint.name}_friction", "friction", f"along {joint.name}", sliding)


def gear(model, name, first, second, ratio):
    """A closure: the first joint follows the second, times a ratio."""
    unit = "" if first.unit() == second.unit() else f" {first.unit()}/{second.unit()}"
    model.close(name, "gear", f"first {first.name}", f"second {second.name}", f"ratio {number(ratio)}{unit}")


GEARED = """
# An input of a motor, behind a gear: the joint has its effort times the ratio.
effect geared {
    joint along
    signal motor like effort of along
    value ratio
    effort on along = ratio * motor
}"""


def geared(model, joint, drive, ratio):
    model.kinds["geared"] = GEARED
    model.effect(f"{joint.name}_gear", "geared", f"along {joint.name}", f"motor {drive}", f"ratio {number(ratio)}")


def hold(model, joint):
    """Makes a joint a fixed one, and removes the loads on it."""
    joint.parent_place = joint.parent_place * joint.place_at_start()
    joint.kind = "fixed"
    drive, joint.drive = joint.drive, ""
    joint.damping = joint.spring = 0.0
    joint.start = 0.0
    joint.start_place = joint.key_place = None
    joint.continuous = False
    lines = {f"along {joint.name}", f"first {joint.name}", f"second {joint.name}"}
    gone = [use for use in model.effects if lines & set(use.lines)]
    motors = {line.partition(" ")[2] for use in gone for line in use.lines if line.startswith(("motor ", "control "))}
    model.effects = [use for use in model.effects if use not in gone]
    model.closures = [use for use in model.closures if not lines & set(use.lines)]
    model.inputs = [found for found in model.inputs if found.name != drive and found.name not in motors]
