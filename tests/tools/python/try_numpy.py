"""What numpy makes of the arrays of a plant: it takes them where they are, and what it writes there shows."""
import importlib

import pytest

numpy = pytest.importorskip("numpy")
plant = importlib.import_module("words_plant")
TICKS = 50


def record(**inputs):
    with plant.Plant() as cart:
        cart.start()
        return cart.record(TICKS, **inputs), cart.state().hash


def test_taken_without_a_copy():
    rows, _ = record(force=1.5)
    arrays = {name: numpy.asarray(column) for name, column in rows.items()}
    assert all(a.shape == (TICKS + 1,) and a.dtype.char == plant.REAL and not a.flags.owndata for a in arrays.values())
    first, second = (a.__array_interface__["data"][0] for a in list(arrays.values())[:2])
    assert second - first == (TICKS + 1) * arrays["pole"].itemsize  # one block has all


def test_writes_show_through():
    rows, _ = record(force=1.5)
    pole = numpy.asarray(rows["pole"])
    before = rows["pole_speed"].tobytes()
    pole[3:5] = 0.75
    assert rows["pole"][3] == rows["pole"][4] == 0.75 != rows["pole"][5] and rows["pole_speed"].tobytes() == before
    rows["pole"][7] = 0.5
    assert pole[7] == 0.5


def test_given_as_inputs():
    values = [0.5 * (i % 7) - 1 for i in range(TICKS)]
    _, expected = record(force=values, wind=0.25)
    for kind in "fd":
        assert record(force=numpy.array(values, dtype=kind), wind=0.25)[1] == expected
    every_second = numpy.repeat(numpy.array(values, dtype=plant.REAL), 2)[::2]
    assert record(force=every_second, wind=numpy.float32(0.25))[1] == expected
    with pytest.raises(plant.PlantError, match="force has 2 numbers"):
        record(force=numpy.zeros(2, dtype=plant.REAL))
