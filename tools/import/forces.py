"""The law of an actuator's force. Each kind is a `general` one: the defaults of all kinds, from the outermost, and then the
element itself set the same numbers, one after the other.

https://mujoco.readthedocs.io/en/stable/XMLreference.html, actuator."""
import math
from dataclasses import dataclass, field

KNOWN = {
    "gaintype": ("fixed", "affine"),
    "biastype": ("none", "affine"),
    "dyntype": ("none", "integrator", "filter", "filterexact"),
}


@dataclass
class Force:
    """gain (control or activation) + bias, of which each is a number, and so much by the length and by its rate."""

    gain: list = field(default_factory=lambda: [1.0, 0.0, 0.0])
    bias: list = field(default_factory=lambda: [0.0, 0.0, 0.0])
    types: dict = field(default_factory=lambda: {name: words[0] for name, words in KNOWN.items()})
    time: float = 1.0  # of a filter
    share: float = 0.0  # of the range of what it drives, which becomes its limits
    limits: tuple = None
    active: tuple = None  # limits of the activation
    control: str = ""

    @property
    def dynamics(self):
        word = self.types["dyntype"]
        return "filter" if word == "filterexact" else word

    def is_servo(self):
        """Whether it is a spring between the control and the length."""
        return self.types["gaintype"] == "fixed" and self.types["biastype"] == "affine" and self.gain[0] == -self.bias[1]

    def is_motor(self):
        """Whether it is a number times the control."""
        return not any((*self.gain[1:], *self.bias)) and self.limits is None and self.dynamics == "none"

    def be(self, dynamics, gain, bias):
        self.types = {"dyntype": dynamics, "gaintype": gain, "biastype": bias}


def force_of(found, autolimits):
    """Of an actuator; None where its kind of law is not taken."""
    force = Force()
    for element in reversed(found.chain):
        SETTERS[element.tag](force, element)
    for name, words in KNOWN.items():
        if force.types[name] not in words:
            found.leave(f"a {name} of {', '.join(words)} is taken")
            return None
    if force.types["gaintype"] == "fixed":
        force.gain[1:] = [0.0, 0.0]
    if force.types["biastype"] == "none":
        force.bias = [0.0, 0.0, 0.0]
    limits = found.numbers("forcerange", 2)
    if found.is_limited("forcelimited", limits):
        force.limits = tuple(limits)
    elif limits is not None:
        found.leave("the force is not limited", "forcerange")
    active = found.numbers("actrange", 2)
    if force.dynamics != "none" and found.is_limited("actlimited", active, autolimits):
        if active[0] >= active[1]:
            found.problem("the lower end of actrange is below the upper one", "actrange")
        force.active = tuple(active)
    elif active is not None:
        found.leave("the activation is not limited", "actrange")
    return force


def general(force, element):
    for name in KNOWN:
        force.types[name] = element.get(name, force.types[name])
    for own, name in ((force.gain, "gainprm"), (force.bias, "biasprm")):
        for k, x in enumerate(element.numbers(name, (1, 10), [])[:3]):
            own[k] = x
    force.time = element.numbers("dynprm", (1, 10), [force.time])[0]


def motor(force, element):
    element.take()
    force.gain[0] = 1.0
    force.be("none", "fixed", "none")


def position(force, element):
    """A damping ratio stands where the damping would, above zero, until the masses are known."""
    kp, kv, ratio = (element.number(name) for name in ("kp", "kv", "dampratio"))
    if kv is not None and ratio is not None:
        element.problem("kv and dampratio: one is right", "dampratio")
    for value, name in ((kv, "kv"), (ratio, "dampratio")):
        if value is not None and value < 0:
            element.problem(f"{name} is not below zero", name)
    force.gain[0] = force.gain[0] if kp is None else kp
    force.bias[1] = -force.gain[0]
    force.bias[2] = -kv if kv is not None else force.bias[2] if ratio is None else ratio
    force.share = element.number("inheritrange", force.share)
    time, dynamics = element.number("timeconst"), force.types["dyntype"]
    if time is not None:
        force.time, dynamics = time, "filter" if time > 0 else "none"
    force.be(dynamics, "fixed", "affine")


def intvelocity(force, element):
    position(force, element)
    force.be("integrator", "fixed", "affine")


def velocity(force, element):
    kv = element.number("kv", force.gain[0])
    force.gain[0], force.bias = kv, [0.0, 0.0, -kv]
    force.be("none", "fixed", "affine")


def damper(force, element):
    kv = element.number("kv", -force.gain[2] if force.types["gaintype"] == "affine" else 0.0)
    force.gain = [0.0, 0.0, -kv]
    force.be("none", "affine", "none")


def cylinder(force, element):
    force.time = element.number("timeconst", force.time)
    force.bias = list(element.numbers("bias", 3, force.bias))
    force.gain[0] = element.number("area", force.gain[0])
    diameter = element.number("diameter")
    if diameter is not None:
        force.gain[0] = math.pi / 4 * diameter**2
    force.be("filter", "fixed", "affine")


SETTERS = {
    "general": general,
    "motor": motor,
    "position": position,
    "velocity": velocity,
    "intvelocity": intvelocity,
    "damper": damper,
    "cylinder": cylinder,
}
