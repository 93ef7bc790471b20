"""Compares the equations that isoc writes with its plant, and those in LaTeX with those in text.

Each number has a bound of its rounding error: every operation adds an epsilon of its result to what the errors of its operands
make of it (running error analysis: Higham 2002, Accuracy and Stability of Numerical Algorithms, 3.3). The plant adds and
multiplies in another order; its error has a bound of the same kind, so that both are apart by twice that at most. Where a
comparison, floor or round falls between the bounds, either answer is right, and what follows from it is left undecided.
"""
import math

import reading

EPSILON = 2.0**-51
UNDECIDED = (0.0, math.inf)


class Unsaid(Exception):
    """A function whose numbers stand in plant.c alone."""


def add(a, b, sign):
    value = a[0] + sign * b[0]
    return value, a[1] + b[1] + EPSILON * abs(value)


def multiply(a, b):
    value = a[0] * b[0]
    if math.isinf(a[1]) or math.isinf(b[1]):
        return UNDECIDED
    return value, abs(a[0]) * b[1] + abs(b[0]) * a[1] + a[1] * b[1] + EPSILON * abs(value)


def divide(a, b):
    if math.isinf(a[1]) or abs(b[0]) <= 2 * b[1]:
        return UNDECIDED
    value = a[0] / b[0]
    return value, (a[1] + abs(value) * b[1]) / (abs(b[0]) - b[1]) + EPSILON * abs(value)


def smooth(function, slope):
    def of(a):
        if math.isinf(a[1]):
            return UNDECIDED
        value = function(a[0])
        return value, abs(slope(a[0], value)) * 2 * a[1] + 8 * EPSILON * max(abs(value), 2.0**-1000)

    return of


def root(a):
    if a[1] > abs(a[0]) / 2:
        return UNDECIDED
    if a[0] < 0:
        return math.nan, 0.0
    return smooth(math.sqrt, lambda x, y: 0 if y == 0 else 0.5 / y)(a)


def stepped(function):
    def of(a):
        if math.isinf(a[1]) or function(a[0] - a[1]) != function(a[0] + a[1]):
            return UNDECIDED
        return float(function(a[0])), 0.0

    return of


def angle(y, x):
    size = y[0] ** 2 + x[0] ** 2
    if math.isinf(y[1] + x[1]) or y[1] + x[1] >= math.sqrt(size) / 2 or (x[0] < 0 and abs(y[0]) <= y[1]):
        return (0.0, 0.0) if size == 0 and y[1] + x[1] == 0 else UNDECIDED
    value = math.atan2(y[0], x[0])
    return value, 2 * (y[1] + x[1]) / math.sqrt(size) + 8 * EPSILON * (abs(value) + abs(y[0]) / math.sqrt(size))


def chosen(pick):
    def of(a, b):
        value = pick(a[0], b[0])
        if a[0] == b[0]:
            return value, max(a[1], b[1])
        clear = abs(a[0] - b[0]) > a[1] + b[1]
        return value, (a[1] if value == a[0] else b[1]) if clear else max(a[1], b[1])

    return of


def where(is_else):
    def of(condition, a):
        if abs(condition[0] - 0.5) <= condition[1]:
            return UNDECIDED
        return a if (condition[0] > 0.5) != is_else else (0.0, 0.0)

    return of


def power(a, b):
    """Of a number above zero, to a constant."""
    if a[0] <= 0:
        return UNDECIDED
    value, size = a[0] ** b[0], abs(b[0] * math.log(a[0]))
    return value, abs(b[0] * value / a[0]) * 2 * a[1] + 8 * EPSILON * (1 + 3 * size) * value


def wrapped(turns):
    return 2 * math.pi * ((turns + 0.5) % 1 - 0.5)


def phase(k, a, b):
    """The product of a tick and a fraction of a turn is rounded here, and exact in the plant but for 2^-64 of each factor."""
    turns = k[0] * a[0] + b[0]
    if abs((turns + 0.5) % 1) < 1e-9 or (turns + 0.5) % 1 > 1 - 1e-9:
        return UNDECIDED
    return wrapped(turns), 7 * (k[0] * a[0] + abs(b[0]) + 1) * 2.0**-51


def half(k, a, b):
    at = (k[0] * a[0] + b[0]) % 1
    return UNDECIDED if min(at, abs(at - 0.5), 1 - at) < 1e-9 else (1.0 if at < 0.5 else -1.0, 0.0)


def since(k, a):
    first = math.floor(a[0])
    return (k[0] - a[0] if k[0] >= first else first - a[0] - 1, 1e-11 * abs(a[0]))


FUNCTIONS = {
    "sin": smooth(math.sin, lambda x, y: 1),
    "cos": smooth(math.cos, lambda x, y: 1),
    "exp": smooth(math.exp, lambda x, y: y),
    "log": smooth(lambda x: math.log(x) if x > 0 else -math.inf, lambda x, y: 1 / x if x else 0),
    "tanh": smooth(math.tanh, lambda x, y: 1),
    "sqrt": root,
    "abs": lambda a: (abs(a[0]), a[1]),
    "sign": lambda a: UNDECIDED if 0 < abs(a[0]) <= a[1] or a[0] == 0 < a[1] else ((a[0] > 0) - (a[0] < 0), 0.0),
    "floor": stepped(math.floor),
    "round": stepped(round),
    "wrap": lambda a: UNDECIDED if math.pi - abs(math.remainder(a[0], 2 * math.pi)) < 1e-9 else (
        math.remainder(a[0], 2 * math.pi), a[1] + 8 * EPSILON * (1 + abs(a[0]))),
    "atan2": angle,
    "power": power,
    "max": chosen(max),
    "min": chosen(min),
    "where": where(False),
    "unless": where(True),
    "only": lambda a, b: b if a[0] > 0.5 else UNDECIDED,
    "phase": phase,
    "half": half,
    "since": since,
    "square": lambda k, a, b, c: (1.0 if (k[0] + b[0]) % a[0] < c[0] else -1.0, 0.0),
}  # fmt: skip


def compare(sign, a, b):
    if a[0] != b[0] and abs(a[0] - b[0]) <= a[1] + b[1] or a[0] == b[0] and a[1] + b[1] > 0:
        return UNDECIDED
    return float(a[0] > b[0] or (sign == ">=" and a[0] == b[0])), 0.0


def key(left):
    """How an equation's left side is called among the values: a name, or a name in a word."""
    return left[1] if left[0] == "name" else f"{left[1]}({left[2][0][1]})"


def evaluate(tree, known):
    kind = tree[0]
    if kind == "number":
        return float(tree[1]), 0.0
    if kind == "name" or (kind == "call" and tree[1] == "der"):
        if key(tree) not in known:
            raise ValueError("not defined: " + key(tree))
        return known[key(tree)]
    if kind == "call":
        if tree[1] not in FUNCTIONS:
            raise Unsaid(tree[1])
        return FUNCTIONS[tree[1]](*(evaluate(argument, known) for argument in tree[2]))
    if kind == "compare":
        return compare(tree[1], evaluate(tree[2], known), evaluate(tree[3], known))
    if kind == "sum":
        result = (0.0, 0.0)
        for sign, term in tree[1]:
            result = add(result, evaluate(term, known), sign)
        return result
    result = (1.0, 0.0)
    for power, factor in tree[1]:
        value = evaluate(factor, known)
        for _ in range(abs(power)):
            result = multiply(result, value) if power > 0 else divide(result, value)
    return result


def points_of(text):
    """What values.c prints, by point."""
    points = []
    for row in text.splitlines():
        word, *numbers = row.split()
        if word == "k":
            points.append({})
        points[-1][word] = [float(number) for number in numbers]
    return points


class Tally:
    def __init__(self):
        self.compared = self.undecided = self.unsaid = 0
        self.off = []

    def check(self, name, value, expected):
        if math.isinf(value[1]):
            self.undecided += 1
            return
        self.compared += 1
        # Numbers below the normal ones are rounded otherwise.
        if not abs(value[0] - expected) <= 2 * value[1] + 1e-290:
            self.off.append(f"{name} is {expected!r}, by its equation {value[0]!r}, rounding {2 * value[1]:.2g}")


def results_of(point, lists):
    """What the plant says of each left side."""
    held = lists.get("Inputs", []) + lists.get("Memories", [])
    found = dict(zip(held, point["u"]))
    found.update(zip(lists["States"], point["x"]))
    found.update(zip(lists["Outputs"], point["y"]))
    for word in ("der", "corrected"):
        found.update((f"{word}({name})", value) for name, value in zip(lists["States"], point[word]))
    found.update((f"next({name})", value) for name, value in zip(held, point["next"]))
    return found


def check_point(point, lists, parts, tally):
    results = results_of(point, lists)
    given = {name: (value, 0.0) for name, value in zip(lists.get("Tunables", []), point["p"])}
    given.update({name: (results[name], 0.0) for name in lists["States"] + lists.get("Inputs", []) + lists.get("Memories", [])})
    given.update({f"turns_{i}": (0.0, 0.0) for i in range(len(lists["States"]))}, local_error=(0.0, 0.0), residual=(0.0, 0.0))
    given["k"] = (point["k"][0], 0.0)
    rates = {}
    for title, equations in parts.items():
        known = dict(given, **rates)
        if title == "Functions of time":
            known = {name: value for name, value in given.items() if name == "k" or name in lists.get("Tunables", [])}
        for left, right in equations:
            try:
                known[key(left)] = evaluate(right, known)
            except Unsaid:
                tally.unsaid += 1
                known[key(left)] = UNDECIDED
            if key(left) in results:
                tally.check(key(left), known[key(left)], results[key(left)])
            if key(left).startswith("der("):
                rates[key(left)] = known[key(left)]


def check_values(lists, parts, points):
    tally = Tally()
    for point in points:
        check_point(point, lists, parts, tally)
    return tally


def check_same(lists, parts, document):
    """What is wrong with the LaTeX document beside the text; or nothing."""
    if not reading.is_closed(document):
        return "something is open"
    other_lists, other_parts = reading.latex(document)
    if list(parts) != list(other_parts) or list(lists) != list(other_lists):
        return "other parts or lists"
    names = {}
    for title in lists:
        pairs = zip(lists[title], other_lists[title])
        if len(lists[title]) != len(other_lists[title]) or not all(reading.same(("name", a), ("name", b), names) for a, b in pairs):
            return "another list: " + title
    for title in parts:
        if len(parts[title]) != len(other_parts[title]):
            return "more or fewer equations: " + title
        for a, b in zip(parts[title], other_parts[title]):
            if not all(reading.same(x, y, names) for x, y in zip(a, b)):
                return f"another equation of {key(a[0])} in {title}"
    return ""


def turned_signs(document):
    """The document with one sign turned, for each between two terms in the derivatives."""
    begin = document.index("## Derivatives")
    end = document.find("\n## ", begin)
    for at in range(begin, end):
        if document[at : at + 3] in (" - ", " + ") and not document[document.rfind("\n", 0, at) + 1] == "#":
            yield document[: at + 1] + {"+": "-", "-": "+"}[document[at + 1]] + document[at + 2 :]
