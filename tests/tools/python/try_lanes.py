"""Plants side by side against each of them alone: random tunables and faults, inputs that change every tick, lanes that are put to
their start or stopped by the guard."""
import array
import os
import random

import cart_plant as plant
import lanes
import pytest

TICKS = 120
LIBRARY = os.environ["LANES_LIBRARY"]


@pytest.fixture
def many():
    return lanes.Lanes(LIBRARY)


def number(chance, least, most):
    return array.array(plant.REAL, [least + (most - least) * chance.randrange(65) / 64])[0]


def drawn(count, seed):
    """Tunables of each lane, and inputs of each step and lane, some no numbers and some beyond their limits."""
    chance = random.Random(seed)
    tunables = [{name: number(chance, least, most) if most < 1e3 else float(chance.randrange(2))
                 for name, (_, least, most) in plant.TUNABLES.items()} for _ in range(count)]
    inputs = {name: array.array(plant.REAL, [float("nan") if chance.random() < 0.02 else number(chance, -25, 25)
                                             for _ in range(TICKS * count)]) for name in plant.INPUTS}
    return tunables, inputs


def shaped(numbers, count):
    return memoryview(numbers).cast("B").cast(plant.REAL, (TICKS, count))


def alone(tunables, inputs, lane, count, first=0):
    one = plant.Plant()
    one.start()
    for name, value in tunables.items():
        one.set(name, value)
    rows = one.record(TICKS - first, **{name: numbers[first * count + lane::count] for name, numbers in inputs.items()})
    return rows, one.state().hash


def give(many, tunables, chosen):
    for lane in chosen:
        for name, value in tunables[lane].items():
            many.tunables[name][lane] = value


@pytest.mark.seeds(4)
def test_each_lane_is_a_plant_alone(many, seed):
    tunables, inputs = drawn(many.count, seed)
    give(many, tunables, range(many.count))
    rows = many.record(TICKS, **{name: shaped(numbers, many.count) for name, numbers in inputs.items()})
    assert many.tick == TICKS and list(rows) == list(plant.OUTPUTS) and len(set(many.hashes())) == many.count
    for lane, hash in enumerate(many.hashes()):
        expected, of_one = alone(tunables[lane], inputs, lane, many.count)
        assert hash == of_one
        for name, column in rows.items():
            assert column.shape == (TICKS + 1, many.count)
            assert [column[tick, lane] for tick in range(TICKS + 1)] == expected[name].tolist()


def test_steps_and_restarts(many):
    """Every third lane begins again at tick 40, with other tunables; the others do not notice."""
    tunables, inputs = drawn(many.count, 9)
    again, chosen = drawn(many.count, 10)[0], range(0, many.count, 3)
    give(many, tunables, range(many.count))
    for tick in range(TICKS):
        if tick == 40:
            many.restart(chosen)
            assert all(many.hashes()[lane] != many.hashes()[1] for lane in chosen)
            give(many, again, chosen)
        assert many.step(**{name: numbers[tick * many.count:(tick + 1) * many.count] for name, numbers in inputs.items()})
    for lane, hash in enumerate(many.hashes()):
        first = 40 if lane in chosen else 0
        # An input that was no number in the first step is the last good one, 0 at the start.
        assert hash == alone((again if lane in chosen else tunables)[lane], inputs, lane, many.count, first)[1]
    other = many.hashes()
    many.inputs["force"][1] += 0.125
    many.step()
    assert many.hashes()[1] != other[1]


def test_guard(many):
    same = {"force": 1.5, "push": 0.5}
    many.states["rail"][1] = float("nan")
    many.record(10, **same)
    hashes, stopped = many.hashes(), many.stopped()
    assert stopped[1] == 1 and not any(stopped[:1] + stopped[2:])
    assert set(hashes[:1] + hashes[2:]) == {alone({}, {name: array.array(plant.REAL, TICKS * [value]) for name, value in same.items()},
                                                  0, 1, TICKS - 10)[1]}
    many.restart([1])
    many.record(10, **same)
    assert not any(many.stopped()) and many.hashes()[1] == hashes[0]
    for lane in range(many.count):
        many.states["rail"][lane] = float("nan")
    rows = many.record(5)
    assert many.tick == 21 and rows["pole"].shape == (2, many.count) and not many.step()
    many.start()
    assert many.tick == 0 and many.step(force=[0.0] * many.count)


def test_refused(many):
    for why, call in (("no input is called forse", lambda: many.step(forse=1)),
                      ("force has 3 numbers for 2", lambda: many.record(2, force=[1, 2, 3])),
                      ("force has the shape", lambda: many.record(3, force=shaped(drawn(many.count, 1)[1]["force"], many.count))),
                      ("there is no lane", lambda: many.restart([many.count]))):
        with pytest.raises(lanes.LanesError, match=why):
            call()
    assert many.tick == 0


def test_numpy(many):
    numpy = pytest.importorskip("numpy")
    masses = numpy.asarray(many.tunables["rod_mass"])
    masses[:] = numpy.linspace(0.1, 0.4, many.count)
    assert many.tunables["rod_mass"][many.count - 1] == masses[-1]
    force = numpy.linspace(-3, 3, TICKS * many.count, dtype=plant.REAL).reshape(TICKS, many.count)
    rows = many.record(TICKS, force=force)
    pole = numpy.asarray(rows["pole"])
    assert pole.shape == (TICKS + 1, many.count) and not pole.flags.owndata
    pole[3, 1] = 0.75
    assert rows["pole"][3, 1] == 0.75
    tunables = {"rod_mass": float(masses[1])}
    inputs = {"force": array.array(plant.REAL, force.tobytes()), "push": array.array(plant.REAL, TICKS * many.count * [0.0])}
    assert many.hashes()[1] == alone(tunables, inputs, 1, many.count)[1]
