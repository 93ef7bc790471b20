"""A chain of rods in a plane with dry friction in every joint, as a model of its own: absolute angles, the efforts of
what is stuck from the rows of the mass matrix that are stuck, times of changes by bisection of steps of order six, and
the rules by which holds settle as tools/isoc/README.md states them."""
import numpy as np

GRAVITY = 9.81
SHARE = 1e-4  # of its limit: what is released may accelerate against its direction by so much


# Butcher (1964), J. Austral. Math. Soc. 4, 179: seven stages, order six.
STAGES = [[], [1 / 3], [0, 2 / 3], [1 / 12, 1 / 3, -1 / 12], [-1 / 16, 9 / 8, -3 / 16, -3 / 8],
          [0, 9 / 8, -3 / 8, -3 / 4, 1 / 2], [9 / 44, -9 / 11, 63 / 44, 18 / 11, 0, -16 / 11]]
WEIGHTS = np.array([11 / 120, 0, 27 / 40, 27 / 40, -4 / 15, -4 / 15, 11 / 120])


def step(rates, x, h):
    """The states a time h later."""
    k = []
    for row in STAGES:
        k.append(rates(x + h * sum((a * r for a, r in zip(row, k)), np.zeros_like(x))))
    return x + h * (WEIGHTS @ np.array(k))


class ComesToRest(Exception):
    """Of a contact: impacts follow each other ever faster."""


class Chain:
    """Rods of these lengths and masses; friction with a static and a sliding limit; efforts amplitude sin(w t + phase).
    The state: relative angles, speeds, the time."""

    def __init__(self, lengths, masses, static, sliding, amplitudes, w, phases):
        self.count = len(lengths)
        self.static, self.sliding = np.array(static, float), np.array(sliding, float)
        self.efforts = [np.array(part, float) for part in (amplitudes, w, phases)]
        beyond = [sum(masses[i + 1:]) for i in range(self.count)]
        self.couples = np.array([[lengths[i] * lengths[j] * (masses[i] / 3 + beyond[i] if i == j
                                                             else masses[max(i, j)] / 2 + beyond[max(i, j)])
                                  for j in range(self.count)] for i in range(self.count)])
        self.weights = GRAVITY * np.array([lengths[i] * (masses[i] / 2 + beyond[i]) for i in range(self.count)])
        self.sums = np.tril(np.ones((self.count, self.count)))
        self.modes = np.zeros(self.count, int)

    def equations(self, x):
        """Mass matrix and efforts without friction, of the relative angles."""
        n = self.count
        angles, speeds = self.sums @ x[:n], self.sums @ x[n:2 * n]
        apart = angles[:, None] - angles[None, :]
        bias = -(self.couples * np.sin(apart)) @ (speeds * speeds) - self.weights * np.sin(angles)
        amplitude, w, phase = self.efforts
        drive = amplitude * np.sin(w * x[2 * n] + phase)
        return self.sums.T @ (self.couples * np.cos(apart)) @ self.sums, self.sums.T @ bias + drive

    def accelerations(self, x, modes):
        """And the efforts of friction."""
        mass, given = self.equations(x)
        effort = -modes * self.sliding
        slips = np.flatnonzero(modes)
        found = np.zeros(self.count)
        if len(slips):
            found[slips] = np.linalg.solve(mass[np.ix_(slips, slips)], (given + effort)[slips])
        return found, np.where(modes == 0, mass @ found - given, effort)

    def rates(self, x):
        n = self.count
        return np.concatenate([x[n:2 * n], self.accelerations(x, self.modes)[0], [1.0]])

    def mobility(self, x):
        """Of each joint, to an effort of its own alone."""
        return np.diagonal(np.linalg.inv(self.equations(x)[0]))

    def settle(self, x, released, most=50):
        """All changes of modes at this instant."""
        released = set(released)
        for _ in range(most):
            found, effort = self.accelerations(x, self.modes)
            wrong = {i: -self.modes[i] * found[i] / self.mobility(x)[i] / self.static[i] for i in released
                     if x[self.count + i] == 0}
            wrong = {i: share for i, share in wrong.items() if share > SHARE}
            over = {i: abs(effort[i]) / self.static[i] for i in range(self.count) if self.modes[i] == 0}
            over = {i: share for i, share in over.items() if share > 1}
            if wrong:
                i = max(wrong, key=wrong.get)
                self.modes[i] = 0
                released.discard(i)
            elif over:
                i = max(over, key=over.get)
                self.modes[i] = -np.sign(effort[i])
                released.add(i)
            else:
                return
        raise AssertionError('the holds do not settle')

    def functions(self, x):
        """Of each joint: below zero where it has to change."""
        effort = self.accelerations(x, self.modes)[1]
        return np.where(self.modes == 0, self.static - np.abs(effort), self.modes * x[self.count:2 * self.count])


class Course:
    """The motion from a start at rest: states and modes in rows, the times of changes and of impacts on walls: (joint,
    place, side, what is left of the speed), of which the joint stays on that side of the place."""

    def __init__(self, chain, angles, h, walls=()):
        self.chain, self.h, self.walls, self.impacts = chain, h, walls, []
        self.x = np.concatenate([angles, np.zeros(chain.count), [0.0]])
        self.times = []
        chain.settle(self.x, ())

    def impact(self, i):
        """On wall i: an impulse on its joint alone, since friction has none; what then moves slips."""
        chain, n = self.chain, self.chain.count
        joint, place, _, rest = self.walls[i]
        if len(self.impacts) == 100:
            raise ComesToRest
        self.impacts.append((self.x[2 * n], i))
        self.x[joint] = place
        row = np.linalg.inv(chain.equations(self.x)[0])[joint]
        self.x[n:2 * n] -= row * (1 + rest) * self.x[n + joint] / row[joint]
        chain.modes = np.sign(self.x[n:2 * n]).astype(int)
        chain.settle(self.x, ())

    def functions(self, x):
        """Those of the holds, then the distances of the walls."""
        return np.concatenate([self.chain.functions(x), [side * (x[joint] - place) for joint, place, side, _ in self.walls]])

    def change(self, i):
        """Joint i, now, and all that follows at once."""
        chain, n = self.chain, self.chain.count
        if i >= n:
            self.impact(i - n)
            return
        self.times.append(self.x[2 * n])
        if chain.modes[i] != 0:
            self.x[n + i] = 0.0
            chain.modes[i] = 0
            chain.settle(self.x, ())
        else:
            chain.modes[i] = -np.sign(chain.accelerations(self.x, chain.modes)[1][i])
            chain.settle(self.x, (i,))

    def at(self, length):
        """The state so much later, in these modes."""
        return step(self.chain.rates, self.x, length)

    def crossing(self, length):
        """The time to the first change in this step, its joint, and the state there."""
        first = length, None, self.at(length)
        below = np.flatnonzero(self.functions(first[2]) < 0)
        # What has just changed is at zero: it is asked a little later.
        soon = self.functions(self.at(1e-7 * length)) if len(below) else None
        for i in below:
            low, high = 0.0, first[0]
            if self.functions(first[2])[i] >= 0:
                continue
            for _ in range(60 if soon[i] >= 0 else 0):
                middle = 0.5 * (low + high)
                if self.functions(self.at(middle))[i] >= 0:
                    low = middle
                else:
                    high = middle
            first = (high, i, self.at(high)) if soon[i] >= 0 else (0.0, i, self.x)
        return first

    def until(self, end, most=50):
        """The state and the modes at this time."""
        at_once = 0
        while end - self.x[2 * self.chain.count] > 1e-12:
            length, i, self.x = self.crossing(min(self.h, end - self.x[2 * self.chain.count]))
            self.x[self.chain.count:2 * self.chain.count][self.chain.modes == 0] = 0.0
            at_once = at_once + 1 if length == 0.0 else 0
            assert at_once < most, 'the holds change for ever'
            if i is not None:
                self.change(i)
        return self.x.copy(), self.chain.modes.copy()


def rows(course, period, count):
    """Angles, speeds and modes in these rows."""
    found = [course.until(period * k) for k in range(1, count + 1)]
    return np.array([x[:-1] for x, _ in found]), np.array([modes for _, modes in found])


def scene(chain_parts, angles, step_text, options, walls=()):
    """The same as a scene of isoc."""
    lengths, masses, static, sliding, amplitudes, w, phases = chain_parts
    lines = [f'gravity (0, -{GRAVITY}, 0) m/s^2', f'step {step_text}', options,
             'effect pull { joint along; value most N*m; value w rad/s; value phase rad; state now s = 0 s; rate now = 1',
             'effort on along = most * sin(w * now + phase) }',
             'effect rub { joint along; value static N*m; value sliding N*m',
             'hold grip on along up to static then sliding; let effort = effort of grip; output grip; output effort }']
    for i, (length, mass) in enumerate(zip(lengths, masses)):
        parent = 'ground' if i == 0 else f'rod{i - 1} at (0, -{lengths[i - 1]}, 0) m'
        lines += [f'body rod{i} {{ rod {length} m of {mass} kg at (0, -{length / 2}, 0) m rotate 90 deg about x }}',
                  f'joint j{i} revolute {{ parent {parent}; child rod{i}; axis z; start {angles[i]!r} rad }}',
                  f'effect pull{i} pull {{ along j{i}; most {amplitudes[i]!r} N*m; w {w[i]!r} rad/s; '
                  f'phase {phases[i]!r} rad }}',
                  f'effect rub{i} rub {{ along j{i}; static {static[i]!r} N*m; sliding {sliding[i]!r} N*m }}']
    for joint, place, side, rest in walls:
        lines += [f'when position of j{joint} {"<" if side > 0 else ">"} {place!r} rad '
                  f'{{ set speed of j{joint} = -{rest} * speed of j{joint} }}']
    for what in ('position of j', 'speed of j'):
        lines += [f'output {what[0]}{i} = {what}{i}' for i in range(len(lengths))]
    lines += [f'output m{i} = rub{i}.grip' for i in range(len(lengths))]
    lines += [f'output e{i} = rub{i}.effort' for i in range(len(lengths))]
    return '\n'.join(lines) + '\n'
