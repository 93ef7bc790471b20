"""Numbers with a bound on their error: what a plant may show that rounds every operation, in whatever order.

Each operation hands on the bounds of its operands to first order, and adds ROUNDINGS units of the last place of its result:
one of its own, one of a constant that is folded, and two of an order of operations of the compiler's. A comparison or a whole
number that the bounds leave open makes a result of which nothing is known: its bound is infinite.
"""
import math

ROUNDINGS = 4
INFINITE = float("inf")


class Number:
    __slots__ = ("value", "bound")
    epsilon = 2.0**-53

    def __init__(self, value, bound=None):
        self.value = value
        self.bound = (0.0 if is_short(value) else Number.epsilon * abs(value)) if bound is None else bound


def is_short(x):
    """Whether it is the same in every type: a multiple of 1/8 of few bits."""
    return abs(x) < 4096 and x * 8 == math.floor(x * 8)


def rounded(value, bound, *of):
    if not math.isfinite(value):
        return Number(0.0, INFINITE)
    exact = bound == 0.0 and is_short(value) and all(is_short(x.value) for x in of)
    size = max([abs(value)] + [abs(x.value) for x in of if len(of) == 2])
    return Number(value, bound if exact else bound + ROUNDINGS * Number.epsilon * size)


def add(a, b):
    return rounded(a.value + b.value, a.bound + b.bound, a, b)


def negative(a):
    return Number(-a.value, a.bound)


def product(a, b):
    if INFINITE in (a.bound, b.bound):
        return Number(0.0, 0.0) if (a.value, a.bound) == (0, 0) or (b.value, b.bound) == (0, 0) else Number(0.0, INFINITE)
    value = a.value * b.value
    bound = abs(a.value) * b.bound + abs(b.value) * a.bound + a.bound * b.bound
    exact = bound == 0.0 and is_short(value) and is_short(a.value) and is_short(b.value)
    return Number(value, bound if exact else bound + ROUNDINGS * Number.epsilon * abs(value))


def quotient(a, b):
    if b.bound >= abs(b.value) or a.bound == INFINITE:
        return Number(0.0, INFINITE)
    value = a.value / b.value
    bound = (a.bound + abs(value) * b.bound) / (abs(b.value) - b.bound)
    exact = bound == 0.0 and is_short(value) and is_short(a.value) and is_short(b.value)
    return Number(value, bound if exact else bound + ROUNDINGS * Number.epsilon * abs(value))


def power(a, b):
    """Of a number above zero: the bounds of the exponent b log a, to which the logarithm and the product add."""
    if INFINITE in (a.bound, b.bound) or a.value - a.bound <= 0.0:
        return Number(0.0, INFINITE)
    value, logarithm = a.value**b.value, math.log(a.value)
    slope = abs(b.value) / (a.value - a.bound) * a.bound + (abs(logarithm) + a.bound / (a.value - a.bound)) * b.bound
    roundings = 2 * ROUNDINGS * Number.epsilon * (1 + 3 * abs(b.value * logarithm) + abs(b.value))
    return Number(value, value * math.expm1(slope + roundings))


def function(name, x):
    """sin, cos, atan, exp, log, tanh, sqrt, and what is exact: abs, sign, floor, round."""
    v, e = x.value, x.bound
    if e == INFINITE:
        return Number(0.0, INFINITE)
    if name == "abs":
        return Number(abs(v), e)
    if name == "sign":
        return Number(float((v > 0) - (v < 0)), 0.0 if e == 0.0 or abs(v) > e else INFINITE)
    if name == "floor":
        return Number(float(math.floor(v)), 0.0 if e == 0.0 or math.floor(v - e) == math.floor(v + e) else INFINITE)
    if name == "round":
        return Number(float(round(v)), 0.0 if e == 0.0 or round(v - e) == round(v + e) else INFINITE)
    if name in ("sqrt", "log") and v - e <= 0.0:
        return Number(0.0, 0.0 if name == "sqrt" and v == e == 0.0 else INFINITE)
    value, slope = {
        "sin": lambda: (math.sin(v), 1.0),
        "cos": lambda: (math.cos(v), 1.0),
        "tanh": lambda: (math.tanh(v), 1.0),
        "atan": lambda: (math.atan(v), 1.0),
        "exp": lambda: (math.exp(v), math.exp(v + e)),
        "log": lambda: (math.log(v), 1.0 / (v - e)),
        "sqrt": lambda: (math.sqrt(v), 0.5 / math.sqrt(v - e)),
    }[name]()
    # The errors of core's functions are up to 1.5 units of the last place, those of sin and cos of 1.
    size = max(abs(value), 1.0) if name in ("sin", "cos") else abs(value)
    return Number(value, slope * e + 2 * ROUNDINGS * Number.epsilon * size)


def above(a, b):
    open_ = abs(a.value - b.value) <= a.bound + b.bound and a.bound + b.bound > 0.0
    return Number(float(a.value > b.value), INFINITE if open_ else 0.0)


def least(a, b):
    """Continuous: where the order is open, either may be it."""
    return Number(min(a.value, b.value), max(a.bound, b.bound) if abs(a.value - b.value) <= a.bound + b.bound
                  else (a if a.value < b.value else b).bound)
