"""A controller that sees slow outputs over a link: what it gets is computed in every fourth row, and held between."""
import sys

sys.path.insert(0, sys.argv[1])
import wired_link as plant

with plant.Link() as link:
    rows = wrong = held = 0
    y = link.start("lockstep", 60)
    while y:
        held = y.theta if rows % 4 == 0 else held
        wrong += y.theta_4 != held
        rows += 1
        y = link.exchange(push=0.1 * y.theta_4)
    print("rows %d wrong %d" % (rows, wrong))
