# Commands from Python: a rest, steps, a snapshot and the way back to it, what is refused, a reset.
import cart_pole_link as plant
from refused import is_refused_by

is_refused = is_refused_by(plant.LinkError)


def balance(link, y, tick):
    while link.tick < tick:
        y = link.exchange(force=30 * y.pole + 6 * y.pole_speed + 2 * y.cart_position + 4 * y.cart_speed)
    return y


with plant.Link() as link:
    assert link.state().state == "no run" and is_refused("no run", link.run, 1)
    y = balance(link, link.start("lockstep"), 10)
    assert link.pause().state == "rests" and link.run(5).left == 5
    y = balance(link, y, 15)
    assert link.state().state == "rests" and link.state().tick == 15
    record = link.snapshot()
    assert len(record) == link.state().snapshot_bytes
    link.run()
    y = balance(link, y, 40)
    end = link.state().hash
    y = link.restore(record)
    assert link.tick == 15 and link.run().state == "runs"
    y = balance(link, y, 40)
    assert link.state().hash == end
    damaged = record[:60] + bytes([record[60] ^ 1]) + record[61:]
    assert is_refused("damaged", link.restore, damaged) and is_refused("not whole", link.restore, record[:-1])
    assert link.state().hash == end and link.state().tick == 40
    y = link.reset()
    assert link.tick == 0 and link.run(5).state == "runs"
    y = balance(link, y, 5)
    assert link.state().state == "rests" and link.stop()["ticks"] == 5
