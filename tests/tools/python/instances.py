# instances.py MODULE HASH TICKS: plants of one module beside one another, in threads too, have the hash of one alone;
# and that is HASH, unless it is `alone`.
import importlib
import sys
import threading

plant = importlib.import_module(sys.argv[1])
expected, ticks = sys.argv[2], int(sys.argv[3])


def hash_of(one):
    return "%016x" % one.state().hash


whole = plant.Plant()
whole.start()
rows = whole.record(ticks)
expected = hash_of(whole) if expected == "alone" else expected
assert hash_of(whole) == expected, hash_of(whole)
assert all(len(column) == ticks + 1 for column in rows.values())

# In turns, a step of one and three of the other; then from the snapshot of one in a third.
fast, slow, late = plant.Plant(), plant.Plant(), plant.Plant()
for one in (fast, slow, late):
    one.start()
while slow.tick < ticks // 3:
    slow.step()
    fast.record(3)
fast.record(ticks - fast.tick)
late.restore(slow.snapshot())
late.run()
late.record(ticks - late.tick)
assert hash_of(fast) == hash_of(late) == expected
assert all(late.outputs.__dict__[name] == column[ticks] for name, column in rows.items())

many = [plant.Plant() for _ in range(4)]
for one in many:
    one.start()
threads = [threading.Thread(target=one.record, args=(ticks,)) for one in many]
for thread in threads:
    thread.start()
for thread in threads:
    thread.join()
assert {hash_of(one) for one in many} == {expected}
