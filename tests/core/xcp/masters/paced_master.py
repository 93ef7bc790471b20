"""A controller that makes a plant tick, at most 1000 times a second, in lockstep: its force is a known function of the tick. It ends
the run when there is a file STOP.

    paced_master.py FOLDER STOP"""
import os
import sys
import time

sys.path.insert(0, sys.argv[1])
import cart_link as plant  # noqa: E402

plant.TRIES = 10 ** 6  # for as long as the plant is paused

with plant.Link() as link:
    y, tick = link.start("lockstep"), 0
    while y and not os.path.exists(sys.argv[2]):
        time.sleep(0.001)
        y, tick = link.exchange(force=5.0 if tick % 100 < 50 else -5.0), tick + 1
    link.stop()
