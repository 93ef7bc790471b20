"""Ten cases of a cart with its pole, each from the same snapshot of the balanced plant: which faults does the controller survive?

    tools/isochron link models/hil/faults.scene --seconds 60 --controller 'pytest-3 models/hil --junitxml=build/faults.xml'

Without a link the plant stands in this process: its package is what `tools/isochron python models/hil/faults.scene` makes.
"""
import copy
import importlib
import math
import os

import pytest

plant = importlib.import_module("faults_link" if os.environ.get("ISOCHRON_LINK") else "faults_plant")

BALANCED, TICKS = 2000, 1500  # of the controller alone, then of a case
COUNT = 2 * math.pi / 4096  # of the encoder, in rad


class Tracked:
    """A signal and its speed, by a filter of 10 ms."""

    def __init__(self, place):
        self.place, self.speed = place, 0.0

    def follow(self, place):
        self.speed = (place - self.place) / 0.01
        self.place += plant.PERIOD_NS * 1e-9 * self.speed


class Regulator:
    """The law of controller.c beside this: gains of a linear-quadratic regulator."""

    def __init__(self, y):
        self.cart, self.pole = Tracked(y.measured_cart), Tracked(y.measured_pole)

    def volts(self, y):
        self.cart.follow(y.measured_cart)
        self.pole.follow(y.measured_pole)
        friction = 0.6 * self.cart.speed / (abs(self.cart.speed) + 0.02)
        volts = 43.6 * y.measured_cart + 39.7 * self.cart.speed + 144.7 * y.measured_pole + 25.2 * self.pole.speed + friction
        return min(max(volts, -12.0), 12.0)


@pytest.fixture(scope="module")
def balanced():
    """The plant, its snapshot with the pole balanced, and the regulator there."""
    with plant.Plant() as cart:
        y = cart.start("lockstep")
        for _ in range(2):  # the first readings are those before the sensors'
            y = cart.step(command=0.0)
        regulator = Regulator(y)
        while cart.tick < BALANCED:
            y = cart.step(command=regulator.volts(y))
        yield cart, cart.snapshot(), regulator
        print("hash %016x" % cart.stop()["hash"])


def course(balanced, faults):
    """The outputs of a case. `faults`: the tunables to be set, each with its value, by the tick."""
    cart, record, regulator = balanced
    regulator = copy.deepcopy(regulator)
    y = cart.restore(record)
    cart.run()
    rows = []
    for tick in range(TICKS):
        for name, value in faults.get(tick, []):
            assert cart.set(name, value) == BALANCED + tick
        y = cart.step(command=regulator.volts(y))
        rows.append(y)
    return rows


def sways(rows):
    """With noise the pole is 3.3 degrees off in the mean square, and less than 9 in 200 s."""
    return all(abs(y.pole) < math.radians(10) for y in rows)


def stands(rows):
    return sways(rows) and abs(rows[-1].pole) < math.radians(2)


def falls(rows):
    return abs(rows[-1].pole) > math.radians(30)


CASES = [
    ("nothing fails", {}, stands),
    ("half the voltage", {0: [("sag.active", 1)]}, stands),
    ("no supply for 30 ms", {0: [("supply.active", 1)], 30: [("supply.active", 0)]}, stands),
    ("no supply", {0: [("supply.active", 1)]}, falls),
    ("an open circuit", {0: [("drive.open", 1)]}, falls),
    ("a jammed belt", {100: [("belt.active", 1)]}, falls),
    ("a stuck encoder for 30 ms", {0: [("angle.active", 1)], 30: [("angle.active", 0)]}, stands),
    ("a noisy encoder", {0: [("hiss.active", 1)]}, sways),
    ("the cart read 0.1 m off", {0: [("shift.active", 1)]}, lambda rows: stands(rows) and abs(rows[-1].cart + 0.1) < 0.05),
    ("the cart read 4 ms late", {0: [("wire.active", 1)]}, stands),
]


@pytest.mark.parametrize("faults, holds", [case[1:] for case in CASES], ids=[case[0] for case in CASES])
def test_case(balanced, faults, holds):
    assert holds(course(balanced, faults))
