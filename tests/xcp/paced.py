"""A controller that makes a plant tick about 1000 times a second, in lockstep: its force is a known function of the tick.

    paced.py FOLDER TICKS"""
import sys
import time

sys.path.insert(0, sys.argv[1])
import cart_link as plant  # noqa: E402

with plant.Link() as link:
    y, tick = link.start("lockstep", int(sys.argv[2])), 0
    while y:
        time.sleep(0.001)
        y, tick = link.exchange(force=5.0 if tick % 100 < 50 else -5.0), tick + 1
