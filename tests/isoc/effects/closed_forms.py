"""Closed forms that tests of effects share.

Impacts have the law F = -k x (1 + d x'), whatever k is. After one with the speed v the speed w is that of
d (v + w) = ln((1 + d v) / (1 - d w)): Marhefka, Orin (1999), IEEE Trans. SMC A 29(6), eq. 24."""
import math

import numpy as np


def bisected(low, high, is_below):
    """Where is_below(x) ends to hold, between two numbers."""
    for _ in range(200):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if is_below(middle) else (low, middle)
    return low


def holds(v, w, d):
    """Whether w is less than what an impact with v leaves."""
    return d * w < 1 and d * (v + w) > math.log1p(d * v) - math.log1p(-d * w)


def damping(rest):
    """The d that leaves `rest` of a speed of 1."""
    return bisected(0.0, 1.0 / rest, lambda d: holds(1.0, rest, d)) if rest < 1 else 0.0


def speed_after(v, d):
    return bisected(0.0, v, lambda w: holds(v, w, d))


def series(a, b, y, ticks, terms, h):
    """y' = a y + b from y, so many ticks: a step by so many terms of the series of the exponential."""
    last, factor = np.eye(len(a)), np.eye(len(a))  # factor is 1 + z / 2 + z^2 / 6 ..., with z = h a
    for n in range(2, terms + 1):
        last = last @ a * h / n
        factor = factor + last
    rows = []
    for _ in range(ticks):
        y = y + factor @ (a @ y + b) * h
        rows.append(y)
    return np.array(rows)
