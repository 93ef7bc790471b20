# script.py SCHEDULE TICKS: balances the cart of the scene, sets tunables by a schedule of lines `tick name value`, and
# prints the hash of the trajectory. Then what a test needs besides: to read tunables and counts, and what is refused.
import sys

import script_link as plant
from refused import is_refused_by

is_refused = is_refused_by(plant.LinkError)
schedule = {}
with open(sys.argv[1]) as file:
    for line in file:
        tick, name, value = line.split()
        schedule.setdefault(int(tick), []).append((name, float(value)))
last = int(sys.argv[2])

with plant.Link() as link:
    assert is_refused("no run", link.set, "reach", 0.1)
    y = link.start("lockstep")
    while link.tick < last:
        for name, value in schedule.get(link.tick, []):
            assert link.set(name, value) == link.tick
        y = link.exchange(command=min(max(30 * y.measured_pole + 2 * y.measured_cart, -12), 12))
    hash, counts = link.state().hash, link.counts()
    assert counts["ticks"] == counts["link_inputs"] == counts["tick"] == last and counts["hash"] == hash
    assert counts["tunables_clamped"] == counts["tunables_held"] == 0

    # A tunable as it is set, and as the next step has it within its limits; one that is not finite stays.
    assert is_refused("no tunable is called", link.set, "reech", 0.1) and is_refused("no tunable is called", link.get, "reech")
    link.set("reach", 7)
    assert link.get("reach") == 7
    link.exchange(command=0)
    assert abs(link.get("reach") - plant.TUNABLES["reach"][2]) < 1e-7 and link.counts()["tunables_clamped"] == 1
    link.set("drive.open", float("nan"))
    before = link.get("drive_open")
    link.exchange(command=0)
    assert before != before and link.get("drive_open") in (0, 1) and link.counts()["tunables_held"] == 1
    link.reset()
    assert abs(link.get("reach") - 0.1) < 1e-7 and link.counts()["ticks"] == 0
    link.run()
    assert link.stop()["ticks"] == 0
print("%016x" % hash)
