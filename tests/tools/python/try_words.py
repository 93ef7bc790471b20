"""The words of a plant, asked of the plant in this process, or of that at the other end of a wire: with equal results.

What must be equal is kept as properties of the tests (--junitxml).
"""
import array
import importlib
import os
import zlib

import pytest

plant = importlib.import_module("words_link" if os.environ.get("ISOCHRON_LINK") else "words_plant")


@pytest.fixture(scope="module")
def cart():
    with plant.Plant() as cart:
        cart.start("lockstep")
        yield cart, cart.snapshot()
        cart.stop()


def begin(cart, start):
    cart.restore(start)
    cart.run()
    return cart


@pytest.fixture
def fresh(cart):
    """The plant at tick 0 of a run that goes on: by a snapshot, so that the trace of `isochron link` goes on too."""
    return begin(*cart)


@pytest.fixture
def start(cart):
    return cart[1]


def balance(cart, ticks):
    """So many steps by a law of the outputs, as they were read."""
    y = cart.outputs
    for _ in range(ticks):
        y = cart.step(force=30 * y.measured + 6 * y.pole_speed + 2 * y.cart + 4 * y.cart_speed, wind=0.25)
    return y


def counted(cart):
    """The counts of a run, without the times and late ticks, which are of a target, and without those of a wire alone."""
    return {name: number for name, number in cart.counts().items()
            if not name.startswith(("execution", "margin", "restart_max", "late", "lost", "overruns", "link_")) or name == "link_inputs"}


def keep(record_property, cart, **more):
    record_property("hash", "%016x" % cart.state().hash)
    record_property("outputs", [value.hex() for value in vars(cart.outputs).values()])
    for name, value in more.items():
        record_property(name, value)


def test_steps(fresh, record_property):
    y = balance(fresh, 60)
    assert fresh.tick == fresh.state().tick == 60 and abs(y.pole) < 0.2 and y is fresh.outputs
    keep(record_property, fresh, counts=counted(fresh))


def test_exchange_is_step(fresh, start):
    once = [fresh.step(force=1.5, wind=0).pole for _ in range(3)]
    begin(fresh, start)
    assert once == [fresh.exchange(force=1.5, wind=0).pole for _ in range(3)]


def test_inputs_stay_and_are_checked(fresh, record_property):
    before = fresh.counts()
    fresh.step(force=3, wind=0)
    fresh.step()
    assert fresh.counts()["inputs_clamped"] == before["inputs_clamped"]
    fresh.step(force=21)
    fresh.step(force=float("nan"))
    assert all(fresh.counts()[name] == before[name] + 1 for name in ("inputs_clamped", "inputs_held"))
    keep(record_property, fresh, counts=counted(fresh))


def test_tunables_and_faults(fresh, start, record_property):
    balance(fresh, 10)
    assert fresh.set("shift.active", 1) == 10 and fresh.set("rod_mass", 0.25) == 10
    balance(fresh, 10)
    assert fresh.get("shift_active") == 1 and fresh.get("rod_mass") == 0.25
    fresh.set("rod_mass", 5)
    fresh.set("hiss.active", float("nan"))
    fresh.step(force=0, wind=0)
    assert abs(fresh.get("rod_mass") - plant.TUNABLES["rod_mass"][2]) < 1e-6 and fresh.get("hiss_active") == 0
    keep(record_property, fresh, counts=counted(fresh))
    fresh.restore(start)
    assert abs(fresh.get("rod_mass") - 0.2) < 1e-7


def test_snapshot(fresh, record_property):
    balance(fresh, 15)
    record = fresh.snapshot()
    assert len(record) == fresh.state().snapshot_bytes
    first = balance(fresh, 15)
    hash = fresh.state().hash
    y = fresh.restore(record)
    assert fresh.tick == 15 and fresh.state().state == "rests" and y is fresh.outputs
    fresh.run()
    assert balance(fresh, 15) == first and fresh.state().hash == hash
    keep(record_property, fresh, snapshot="%08x" % zlib.crc32(record))


def test_record(fresh, start, record_property):
    force = array.array("d", [0.5 * (i % 7) - 1 for i in range(40)])
    rows = fresh.record(40, force=force, wind=0.125)
    assert list(rows) == list(plant.OUTPUTS) and fresh.tick == 40
    assert all(len(column) == 41 and column.format == plant.REAL and column[40] == vars(fresh.outputs)[name]
               for name, column in rows.items())
    hash = fresh.state().hash
    begin(fresh, start)
    for i, value in enumerate(force):
        assert fresh.outputs == plant.Outputs(**{name: column[i] for name, column in rows.items()})
        fresh.step(force=value, wind=0.125)
    assert fresh.state().hash == hash
    begin(fresh, start)
    fresh.record(40, force=array.array(plant.REAL, force), wind=memoryview(array.array(plant.REAL, 80 * [0.125]))[::2])
    assert fresh.state().hash == hash
    fresh.step()  # with the inputs of the last
    keep(record_property, fresh, rows=[zlib.crc32(column.tobytes()) for column in rows.values()])


def test_run_and_rest(fresh):
    assert fresh.run(5).left == 5
    balance(fresh, 5)
    state = fresh.state()
    assert state.state == "rests" and state.tick == 5 and state.left == 0
    assert fresh.run().state == "runs" and fresh.pause().state == "rests"


@pytest.mark.parametrize("why, call", [
    ("no tunable is called", lambda cart, record: cart.set("rod_mas", 0.2)),
    ("no tunable is called", lambda cart, record: cart.get("shift.passive")),
    ("no input is called", lambda cart, record: cart.step(forse=1)),
    ("no input is called", lambda cart, record: cart.record(2, forse=1)),
    ("force has 3 numbers for 2 steps", lambda cart, record: cart.record(2, force=[1, 2, 3])),
    ("refused: the snapshot is damaged", lambda cart, record: cart.restore(record[:70] + bytes([record[70] ^ 1]) + record[71:])),
    ("refused: the snapshot is not whole", lambda cart, record: cart.restore(record[:-1])),
    ("refused: this is no snapshot", lambda cart, record: cart.restore(bytes(len(record)))),
])
def test_refused(fresh, why, call):
    balance(fresh, 3)
    hash, record = fresh.state().hash, fresh.snapshot()
    with pytest.raises(plant.PlantError, match=why):
        call(fresh, record)
    assert fresh.state().hash == hash and fresh.tick == 3


def test_end_of_a_run(cart, record_property):
    cart, _ = cart
    try:
        y = cart.start(ticks=8)
    except plant.PlantError as refusal:
        if "makes one run" in str(refusal):
            pytest.skip(str(refusal))  # a program that was told how long to run
        raise
    assert cart.tick == 0 and y.cart == 0
    assert balance(cart, 7) is cart.outputs
    assert cart.step() is None and cart.tick == 8 and cart.end["ticks"] == 8 and cart.stop() is cart.end
    assert cart.state().state == "no run"
    with pytest.raises(plant.PlantError, match="there is no run"):
        cart.set("rod_mass", 0.2)
    keep(record_property, cart, end="%016x" % cart.end["hash"])
    cart.start()
    balance(cart, 5)
    y = cart.reset()
    assert cart.tick == 0 and y.cart == 0 and cart.state().state == "rests" and cart.counts()["ticks"] == 0
    cart.run()
    rows = cart.record(4, force=0, wind=0)
    assert len(rows["pole"]) == 5 and cart.stop()["ticks"] == 4
