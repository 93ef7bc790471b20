"""Effects of a scene, row by row, as the section Sampled time of tools/isoc/README.md has them: an interpreter of the text.

It reads the part of the language that generator.py writes, and shares nothing with isoc. What it computes is a list of
Numbers for each row.
"""
import re

from number import INFINITE, Number, above, add, function, least, negative, power, product, quotient

UNITS = {"s": 1.0, "ms": 1e-3, "rad": 1.0, "Hz": 1.0, "V": 1.0, "m": 1.0, "kg": 1.0, "N": 1.0}
WORDS = re.compile(r"\s*(\d+\.?\d*(?:e-?\d+)?|[A-Za-z_]\w*(?:\.\w+)?|<=|>=|.)")


class Parser:
    def __init__(self, text):
        self.words, self.at = WORDS.findall(text.strip()), 0

    def next(self):
        return self.words[self.at] if self.at < len(self.words) else ""

    def take(self, *words):
        if self.next() in words and self.next():
            self.at += 1
            return self.words[self.at - 1]
        return None

    def sum(self):
        left = self.term()
        while sign := self.take("+", "-"):
            left = (sign, left, self.term())
        return left

    def term(self):
        left = self.factor()
        while sign := self.take("*", "/"):
            left = (sign, left, self.factor())
        return left

    def factor(self):
        if self.take("-"):
            return ("negative", self.factor())
        base = self.primary()
        if not self.take("^"):
            return base
        sign = self.take("-")
        exponent = self.primary()
        return ("^", base, ("negative", exponent) if sign else exponent)

    def order(self):
        left = self.sum()
        sign = self.take("<", ">", "<=", ">=")
        return (sign, left, self.sum()) if sign else left

    def primary(self):
        word = self.next()
        self.at += 1
        if word == "(":
            inner = self.order()
            assert self.take(")"), self.words
            return inner
        if word[0].isdigit():
            value = float(word)
            if self.next() in UNITS:
                value *= UNITS[self.take(self.next())]
            return ("constant", value)
        if word in ("position", "speed") and self.take("of"):
            return (word, self.primary()[1])
        if not self.take("("):
            return ("name", word)
        parts = []
        while True:
            self.take("every")
            parts.append(self.order())
            if not self.take(",", ":"):
                break
        assert self.take(")"), self.words
        return (word, *parts)


def parse(text):
    p = Parser(text)
    made = p.order()
    assert p.at == len(p.words), (text, p.words[p.at :])
    return made


def hash_of(x, key):
    """triple32 (Wellons, 2018), with a key behind its first product."""
    x = ((x ^ x >> 17) * 0xED5AD4BB + key) % 2**32
    x = (x ^ x >> 11) * 0xAC4C1B51 % 2**32
    x = (x ^ x >> 15) * 0x31848BAB % 2**32
    return x ^ x >> 14


def noise(tick, seed):
    """The sum of 16 pairs of bits, each counted with all the products of 2^-8 that core/numbers/noise.h keeps of it."""
    bits = hash_of((tick + hash_of(seed, 0x9E3779B9)) % 2**32, seed * 0x7FEB352D + (tick >> 32))
    groups = [sum(bits >> (8 * byte + 2 * pair) & 3 for pair in range(4)) for byte in range(4)]
    total = sum(groups[byte] << (8 * place) for byte in range(4) for place in range(byte, 4))
    return (total + (bits * 0x31848BAB % 2**32 >> 8) - 412224518) * 1.3261512544296112e-08


def seed_of(use):
    """FNV-1a (Fowler, Noll, Vo) of the name of an effect; 0 outside of effects."""
    hash = 2166136261 if use else 0
    for c in use.encode():
        hash = (hash ^ c) * 16777619 % 2**32
    return hash


class Row:
    """What formulas read: of row k, of a stage of the step from it (is_stage), or of the next of row k (is_next)."""

    def __init__(self, k, states, memories, is_stage=False, is_next=False):
        self.k, self.states, self.memories = k, states, memories
        self.is_stage, self.is_next, self.known = is_stage, is_next, {}


TABLEAUX = {
    "euler": ([[]], [1.0]),
    "heun": ([[], [1.0]], [0.5, 0.5]),
    "rk4": ([[], [0.5], [0.0, 0.5], [0.0, 0.0, 1.0]], [1 / 6, 1 / 3, 1 / 3, 1 / 6]),
}


class Plant:
    """Of a scene that generator.py describes: its lines are in dictionaries of formulas, by full names. `planted` is a defect."""

    def __init__(self, scene, planted=None):
        self.scene, self.planted, self.rows = scene, planted, []
        self.h = scene["step"]
        self.formulas = {name: (parse(text), use) for name, (text, use) in scene["formulas"].items()}
        self.states, self.memories = scene["states"], scene["memories"]
        start = Row(0, {}, {})
        self.rows.append(start)

    # --- a formula in a row ---

    def look_up(self, name, use, row):
        full = use + "." + name if use + "." + name in self.formulas else name
        if full == "time":
            return Number(row.k * self.h)
        if full == "step":
            return Number(self.h)
        if full in self.scene["sets"]:
            at, later = self.scene["sets"][full]
            if row.k >= at:
                return Number(later)
        for kept in (row.states, row.memories):
            if full in kept:
                return kept[full]
        if full not in row.known:
            value = self.evaluate(*self.formulas[full], row)
            for kept, names in ((row.states, self.states), (row.memories, self.memories)):
                if full in names:
                    kept[full] = value
            row.known[full] = value
        return row.known[full]

    def past(self, node, use, row):
        kind, e = node[0], node[1]
        start = None
        if kind == "previous":
            steps = 2 if self.planted == "previous" else 1
            start = node[2] if len(node) > 2 else None
            k = row.k - steps
        else:
            n = round(self.evaluate(node[2], use, row).value / self.h)
            start = node[3] if len(node) > 3 else None
            k = row.k - n if kind == "delay" else row.k - row.k % n
            if kind == "delay" and self.planted == "delay":
                k -= 1
            if kind == "sample" and row.k < n and start is not None:
                k = -1
            if kind == "sample" and k == row.k and not row.is_stage and self.planted != "sample":
                return self.evaluate(e, use, row)
            if kind == "sample" and self.planted == "sample":
                k = max(k - 1, 0)
        if k < 0 and start is not None:
            return self.evaluate(start, use, row)
        if k <= 0 and row.k == 0 and not row.is_stage:
            return self.evaluate(e, use, row)
        return self.evaluate(e, use, self.rows[max(k, 0)])

    def evaluate(self, node, use, row):
        kind = node[0]
        if kind == "constant":
            return Number(node[1])
        if kind == "name":
            return self.look_up(node[1], use, row)
        if kind in ("position", "speed"):
            return self.look_up(kind + " of " + node[1], "", row)
        if kind in ("previous", "delay", "sample"):
            return self.past(node, use, row)
        if kind == "noise":
            seed = (seed_of(use) + int(node[1][1])) % 2**32
            value = noise(row.k + (self.planted == "noise"), seed)
            return Number(value, 3 * Number.epsilon * abs(value))  # of the whole number, the factor and their product
        x = [self.evaluate(part, use, row) for part in node[1:]]
        if kind in "+-":
            return add(x[0], x[1] if kind == "+" else negative(x[1]))
        if kind == "*":
            return product(*x)
        if kind == "/":
            return quotient(*x)
        if kind == "negative":
            return negative(x[0])
        if kind == "^":
            return power(*x)
        if kind == "hypot":
            return function("sqrt", add(add(product(x[0], x[0]), product(x[1], x[1])), Number(1e-30)))
        if kind == "mod":
            return add(x[0], negative(product(x[1], function("floor", quotient(x[0], x[1])))))
        if kind in ("min", "max"):
            return least(*x) if kind == "min" else negative(least(negative(x[0]), negative(x[1])))
        if kind == "clamp":
            return least(negative(least(negative(x[0]), negative(x[1]))), x[2])
        if kind in (">", "<"):
            return above(*x) if kind == ">" else above(x[1], x[0])
        if kind in ("<=", ">="):
            other = above(*x) if kind == "<=" else above(x[1], x[0])
            return Number(1.0 - other.value, other.bound)
        if kind == "if":
            if x[0].bound > 0.0:
                return Number(0.0, INFINITE)
            return x[1] if x[0].value else x[2]
        if kind == "step":
            return Number(float(row.k * self.h >= x[0].value - 1e-9))
        if kind == "square":
            return Number(1.0 if (row.k * self.h * x[0].value + 1e-9) % 1.0 < 0.5 else -1.0)
        if kind == "table":
            return self.table(x)
        return function(kind, x[0])

    @staticmethod
    def table(x):
        """Straight lines, constant beyond; between two lines either holds at their point, and the steeper has the bound."""
        places, values = [p.value for p in x[1::2]], [v.value for v in x[2::2]]
        at = min(max(x[0].value, places[0]), places[-1])
        slopes = [(b - a) / (q - p) for a, b, p, q in zip(values, values[1:], places, places[1:])]
        i = max(i for i in range(len(slopes)) if places[i] <= at)
        size = max(map(abs, values)) + max(map(abs, slopes)) * max(map(abs, places + [at]))
        bound = max(map(abs, slopes)) * x[0].bound + 8 * len(places) * Number.epsilon * size
        return Number(values[i] + slopes[i] * (at - places[i]), bound)

    # --- rows ---

    def rates(self, row):
        return {s: self.evaluate(*self.formulas["rate " + s], row) for s in self.states}

    def step(self, row):
        stages, weights = TABLEAUX[self.scene["method"]]
        h = Number(self.h)
        slopes = []

        def moved(factors):
            made = dict(row.states)
            for factor, slope in zip(factors, slopes):
                for s in made:
                    made[s] = add(made[s], product(product(h, Number(factor)), slope[s])) if factor else made[s]
            return made

        for factors in stages:
            slopes.append(self.rates(Row(row.k, moved(factors), row.memories, is_stage=True)))
        return moved(weights)

    def run(self, last):
        """The rows from 0 to last, each a list of outputs."""
        start = self.rows[0]
        for name in self.states + self.memories:
            self.look_up(name, "", start)
        shown = [[self.look_up(o, "", start) for o in self.scene["outputs"]]]
        for k in range(last):
            row = self.rows[k]
            new = self.step(row)
            between = Row(k + 1, new, row.memories, is_next=True)
            memories = {}
            for m in self.memories:
                formula, use = self.formulas["next " + m]
                memories[m] = self.evaluate(formula, use, between)
                if self.planted == "next":
                    between = Row(k + 1, new, {**row.memories, **memories}, is_next=True)
            self.rows.append(Row(k + 1, new, memories))
            shown.append([self.look_up(o, "", self.rows[-1]) for o in self.scene["outputs"]])
        return shown
