"""Tunes the controller of a cart with its pole, on the plant in this process: python3 models/hil/tune.py [EVALUATIONS]

A digital controller sets the force 100 times a second. An evaluation is 5 s of the plant from its start, where the pole leans by
5 degrees; its cost is the mean of (pole / 1 deg)^2 + (place / 0.1 m)^2 + (force / 5 N)^2. The search varies one gain after
another by a factor, and takes a smaller one where none makes it better.
"""
import math
import sys

import cart_plant

SECONDS, RATE, MOST_FORCE = 5, 100, 20.0
TICKS = round(1e9 / RATE) // cart_plant.PERIOD_NS  # of one force
NAMES = ("pole", "pole_speed", "cart_position", "cart_speed")


def cost_of(gains, cart, start):
    """Runs the plant from a snapshot."""
    y = cart.restore(start)
    cart.run()
    total = 0.0
    for _ in range(SECONDS * RATE):
        force = sum(gain * getattr(y, name) for gain, name in zip(gains, NAMES))
        force = min(max(force, -MOST_FORCE), MOST_FORCE)
        cart.record(TICKS, force=force)
        y = cart.outputs
        total += (y.pole / math.radians(1)) ** 2 + (y.cart_position / 0.1) ** 2 + (force / 5) ** 2
        if cart.end or abs(y.pole) > 1:
            return math.inf  # it fell
    return total / (SECONDS * RATE)


def tuned(gains, cost, evaluations):
    """The gains of the least cost that was found."""
    best, factor = cost(gains), 1.5
    evaluations -= 1
    while evaluations > 0 and factor > 1.005:
        before = best
        for place in range(len(gains)):
            for change in (factor, 1 / factor):
                tried = gains[:place] + [gains[place] * change] + gains[place + 1:]
                found = cost(tried)
                evaluations -= 1
                if found < best:
                    best, gains = found, tried
                    break
        factor = factor if best < before else math.sqrt(factor)
    return gains, best


def main():
    with cart_plant.Plant() as cart:
        cart.start()
        start = cart.snapshot()
        gains = [30.0, 6.0, 2.0, 4.0]
        print("before: cost %.3f" % cost_of(gains, cart, start))
        gains, cost = tuned(gains, lambda tried: cost_of(tried, cart, start), int(sys.argv[1]) if len(sys.argv) > 1 else 400)
        print("after: cost %.3f with" % cost, *("%s %.2f" % pair for pair in zip(NAMES, gains)))


main()
