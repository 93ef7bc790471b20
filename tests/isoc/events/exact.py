"""A run whose events are found to rounding: steps of Runge and Kutta that are short against the motion, and bisection of
their length at an event. It shares nothing with isoc or core but what the reference says of events."""


def step(rates, x, h):
    """The states a time h later, by the classical method of order four."""
    a = rates(x)
    b = rates([s + h / 2 * r for s, r in zip(x, a)])
    c = rates([s + h / 2 * r for s, r in zip(x, b)])
    d = rates([s + h * r for s, r in zip(x, c)])
    return [s + h / 6 * (p + 2 * (q + r) + v) for s, p, q, r, v in zip(x, a, b, c, d)]


class Event:
    """It fires where `function` of the states falls below zero, and `sets` gives the states behind it. `moves`: whether
    these change its own function."""

    def __init__(self, function, sets, moves=False):
        self.function, self.sets, self.moves = function, sets, moves


class Run:
    """The states from the start on, as far as `until` was asked for, and the events: (time, number)."""

    def __init__(self, rates, events, x, h):
        self.rates, self.events, self.x, self.h = rates, events, list(x), h
        self.time, self.fired = 0.0, []
        self.zero, self.passed = [0.0] * len(events), set()
        self.armed = [event.function(self.x) >= 0 for event in events]

    def value(self, i, x):
        return self.events[i].function(x) - self.zero[i]

    def crossing(self, i, length):
        """The time in this step at which an event fires, or None."""
        if not self.armed[i]:
            return None
        if self.value(i, self.x) < 0:
            return 0.0
        low, high = 0.0, length
        if self.value(i, step(self.rates, self.x, length)) >= 0:
            return None
        for _ in range(60):
            middle = 0.5 * (low + high)
            if self.value(i, step(self.rates, self.x, middle)) >= 0:
                low = middle
            else:
                high = middle
        return high

    def fire(self, i):
        """Event i, now."""
        self.fired.append((self.time, i))
        self.armed = [armed or self.value(k, self.x) >= 0 for k, armed in enumerate(self.armed)]
        self.x = list(self.events[i].sets(self.x))
        for k, event in enumerate(self.events):
            value = self.value(k, self.x)
            self.armed[k] = (value >= 0 and k not in self.passed) or (self.armed[k] and k != i)
        if not self.events[i].moves:
            self.zero[i] = self.events[i].function(self.x)
            ahead = step(self.rates, self.x, 1e-9)
            self.armed[i] = self.events[i].function(ahead) >= self.zero[i]
            if not self.armed[i]:
                self.passed.add(i)

    def until(self, end, most=100000):
        """The states at a time."""
        for _ in range(most):
            left = end - self.time
            if left <= 1e-13:
                return self.x
            length = min(self.h, left)
            found = [(at, i) for i in range(len(self.events)) if (at := self.crossing(i, length)) is not None]
            at, first = min(found, default=(length, None))
            self.x = step(self.rates, self.x, at) if at > 0 else self.x
            self.time = end if first is None and length == left else self.time + at
            if first is not None:
                self.fire(first)
            else:
                for k in range(len(self.events)):
                    self.zero[k] = 0.0
                    self.armed[k] = self.value(k, self.x) >= 0
                self.passed.clear()
        raise AssertionError('too many events')
