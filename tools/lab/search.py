"""The search for the longest tick, or the fewest steps in a tick, with which every error stays below its bound."""
import math

# The ticks that are tried, in steps of the scene; where they divide it, also so many steps in one.
LONG_TICKS = [2, 3, 4, 5, 6, 8, 10, 12, 15, 16, 20, 25, 30, 32, 40, 50, 60, 64, 80, 100, 120, 125, 150, 160, 200, 250,
              300, 320, 400, 500, 600, 625, 800, 1000]
TOLERANCES = '1e-06', '1e-04', '1e-08'
AGAIN = 3
HOPELESS = 50


class Grid:
    """Places: at 0 the tick is the scene's step and one step long; at 1, 2, ... it is so many of the scene's steps as
    LONG_TICKS says; at -1, -2, ... it has as many steps as divide it, up to `most_n`. `ratio_of(k, n)` is the largest
    error in its bound; each place is tried once."""

    def __init__(self, motions, longest, order, most_n, ratio_of):
        period, room = motions.period, motions.rows // (8 * motions.every)
        self.order, self.ratio_of, self.tried, self.why = order, ratio_of, {}, 'steps'
        self.ticks = [k for k in LONG_TICKS if k <= longest and k * period <= 1e9 and k <= room]
        self.parts = [n for n in LONG_TICKS if period % n == 0 and period / n >= 1000 and n <= most_n]
        self.coarsest, self.finest = len(self.ticks), -len(self.parts)

    def k(self, place):
        return self.ticks[place - 1] if place > 0 else 1

    def n(self, place):
        return self.parts[-place - 1] if place < 0 else 1

    def at(self, place):
        return self.k(place) / self.n(place)

    def ratio(self, place):
        if place not in self.tried:
            self.tried[place] = self.ratio_of(self.k(place), self.n(place))
        return self.tried[place]

    def leap(self, place, by, ratio):
        """The place whose step is that much longer, or less, in the direction of `by`; at least the next."""
        wanted = 4 if ratio <= 0 else 1 if ratio == math.inf else ratio ** (-1 / self.order)
        wanted *= self.at(place) * (0.95 if by > 0 else 1.3)
        to = place + by
        while self.finest <= to + by <= self.coarsest:
            if self.at(to + by) > wanted if by > 0 else self.at(to) <= wanted:
                break
            to += by
        return to

    def coarser(self, place):
        """From a place that is good to coarser ones, until AGAIN in turn are not, or the next is hopeless; the coarsest
        that is good."""
        while True:
            to = self.leap(place, 1, self.ratio(place))
            while place < to <= self.coarsest and self.ratio(to) > 1:
                to -= 1
            for i in range(2, AGAIN + 1):
                if to > place or place + i > self.coarsest or self.ratio(place + 1) > HOPELESS:
                    break
                to = place + i if self.ratio(place + i) <= 1 else to
            if to <= place or to > self.coarsest:
                return place
            place = to

    def fewer_roundings(self, place):
        """From a place that is not good to coarser ones, as long as the error hardly grows: then it is that of
        rounding, of which fewer steps have less. The coarsest that is good, or None."""
        grown, to = 0, place + 1
        while self.ratio(place) < math.inf and to <= self.coarsest and grown < 2:
            if self.ratio(to) <= 1:
                return self.coarser(to)
            if self.ratio(to) > 8 * self.ratio(place):
                break
            grown += self.ratio(to) > 2 * self.ratio(place)
            to += 1
        return None

    def finer(self, place):
        """From a place that is not good to finer ones, until one is: the coarsest good one that is known, or None."""
        stuck = 0
        while place > self.finest:
            was = self.ratio(place)
            to = self.leap(place, -1, was)
            if self.ratio(to) <= 1:
                between = place - 1
                while between > to and self.ratio(between) > 1:
                    between -= 1
                return between
            stuck = stuck + 1 if 0.7 * was < self.ratio(to) < math.inf else 0
            if stuck > 3:
                self.why = 'rounding'
                return None
            place = to
        return None

    def search(self, start, only_coarser):
        """The place that was found, or None. Where the first one keeps the bounds, places are tried to coarser ones;
        else to finer ones. It leaps as far as the order of the method says; the places that it leapt over are tried
        backwards."""
        start = max(start, self.finest)
        if start > self.coarsest:
            self.why = 'no longer tick'
            return None
        if self.ratio(start) <= 1:
            return self.coarser(start)
        found = None if only_coarser else self.fewer_roundings(start)
        return found if found is not None or only_coarser else self.finer(start)


def search_adams(motions, longest, one, more, least, ratio_of):
    """The cheapest tick of adams that keeps every bound, as (method with tolerance, k, n, ratio), and whether any was
    tried. Its sub-steps vary with the error; the cost of its dearest tick is bounded by their number, at any
    tolerance: a tick of one takes `one` cycles at most, each further `more`; `least` cycles per second and more are
    too dear. For each tick, the longest first, the most sub-steps that are not too dear are tried: if they keep the
    bounds, half as many, until these do not; if not, a tick as long as the error lets expect."""
    period, found, tried, wanted = motions.period, None, False, longest

    def rate(k, n):
        return (one + (n - 1) * more) / (period * k) * 1e9

    def most(k):
        return next((n for n in (2 ** i for i in range(10 if k == 1 else 6, -1, -1)) if rate(k, n) < least), 0)

    for k in reversed([1] + LONG_TICKS):
        if k > wanted or k > 1 and (k * period > 1e9 or k * motions.every * 8 > motions.rows):
            continue
        n = most(k)
        while n >= 1:
            best, method = math.inf, None
            for tolerance in TOLERANCES:
                # A further tolerance, as long as that could help.
                if tolerance == TOLERANCES[0] or 1 < best < 4:
                    tried, ratio = True, ratio_of(f'adams-{tolerance}', k, n)
                    if ratio < best:
                        best, method = ratio, f'adams-{tolerance}'
            if best > 1:
                break
            least, found, wanted, n = rate(k, n), (method, k, n, best), k, n // 2
        # Where the most do not keep the bounds, the error is of the tick, which is of the first order in it at least.
        if n >= 1 and n == most(k):
            wanted = k * 1.3 * (0.5 if best == math.inf else best ** -0.5)
    return found, tried
