"""Random scenes with states, modes and events against runs whose events are found to rounding (exact.py): the same events
in the same order, their times, and the states at the end. The scene and the functions of the reference come from one
list of random numbers, by different ways."""
import random

import numpy as np
import pytest

from exact import Event, Run
from harness.plants import replaced

STEP, ROWS = 2e-3, 600


class Tank:
    """A state that goes to one of two levels by a mode, which events switch at two others; at one of these it may be set
    back. It is pulled by the tank before."""

    def __init__(self, draw, i):
        self.i = i
        self.levels = [draw.uniform(-2, -1), draw.uniform(1, 2)]
        self.lag, self.pull = draw.uniform(0.1, 0.5), draw.uniform(0, 0.3)
        self.low, self.high = draw.uniform(-0.6, -0.2), draw.uniform(0.2, 0.6)
        self.start, self.mode = draw.uniform(-0.1, 0.1), draw.choice([0, 1])
        self.back = draw.choice([None, 0.4, 0.7])
        self.joined = draw.choice(['plain', 'and', 'or', 'not'])

    def text(self, before):
        i, (off, on) = self.i, self.levels
        rising = {'plain': f'y{i} > {self.high} and m{i} == 1',
                  'and': f'y{i} > {self.high} and m{i} == 1 and {before} > -1.9',
                  'or': f'(y{i} > {self.high} and m{i} == 1) or y{i} > 1.9',
                  'not': f'not (y{i} < {self.high} or m{i} == 0)'}[self.joined]
        more = '' if self.back is None else f'; set y{i} = {self.back} * y{i}'
        return (f'    state y{i} = {self.start}\n    mode m{i} = {self.mode}\n'
                f'    rate y{i} = (if(m{i} == 1, {on}, {off}) + {self.pull} * {before} - y{i}) / ({self.lag} s)\n'
                f'    when {rising} {{ set m{i} = 0{more}; set n = n + 1; set at = now }}\n'
                f'    when y{i} < {self.low} and m{i} == 0 {{ set m{i} = 1; set n = n + 1; set at = now }}\n'
                f'    output y{i}; output m{i}\n')


class Scene:
    """Tanks, and a mass on a spring between two walls, one of which takes a part of its speed."""

    def __init__(self, seed):
        draw = random.Random(seed)
        self.tanks = [Tank(draw, i) for i in range(draw.randint(1, 4))]
        self.spring, self.start = draw.uniform(20, 200), draw.uniform(0.2, 0.5)
        self.wall, self.rest = draw.uniform(-0.1, -0.01), draw.uniform(0.6, 0.95)
        self.count = len(self.tanks)

    def text(self):
        tanks = ''.join(tank.text(f'y{(i - 1) % self.count}') for i, tank in enumerate(self.tanks))
        shown = ''.join(f'output y{i} = all.y{i}\noutput m{i} = all.m{i}\n' for i in range(self.count))
        return f'''step {STEP * 1e3} ms
method rk4
events 3 rest rk4
body load {{ mass 1 kg }}
joint rail prismatic {{ parent ground; child load; axis x; start {self.start} m; spring {self.spring} N/m; damping 0.2 N*s/m }}
when position of rail < {self.wall} m {{ set speed of rail = -{self.rest} * speed of rail }}
effect tanks {{
    state now s = 0 s
    state at s = 0 s
    mode n = 0
    rate now = 1
    rate at = 0
{tanks}    output n; output at
}}
effect all tanks {{ }}
output x = position of rail
output v = speed of rail
output n = all.n
output at = all.at
{shown}'''

    def run(self):
        """States: y0, m0, y1, m1, ..., x, v."""
        size = 2 * self.count

        def rates(s):
            slopes = []
            for i, tank in enumerate(self.tanks):
                level = tank.levels[1 if s[2 * i + 1] == 1 else 0]
                slopes += [(level + tank.pull * s[(2 * i - 2) % size] - s[2 * i]) / tank.lag, 0.0]
            return slopes + [s[size + 1], -self.spring * s[size] - 0.2 * s[size + 1]]

        def switch(i, to, back=None):
            def sets(s):
                s = list(s)
                s[2 * i + 1] = to
                s[2 * i] = s[2 * i] if back is None else back * s[2 * i]
                return s
            return sets
        events = []
        for i, tank in enumerate(self.tanks):
            def rising(s, i=i, tank=tank):
                plain = max(tank.high - s[2 * i], abs(s[2 * i + 1] - 1) - 0.5)
                return {'plain': plain, 'and': max(plain, -1.9 - s[(2 * i - 2) % size]),
                        'or': min(plain, 1.9 - s[2 * i]),
                        'not': -min(s[2 * i] - tank.high, abs(s[2 * i + 1]) - 0.5)}[tank.joined]

            def falling(s, i=i, tank=tank):
                return max(s[2 * i] - tank.low, abs(s[2 * i + 1]) - 0.5)
            events += [Event(rising, switch(i, 0, tank.back), True), Event(falling, switch(i, 1), True)]
        events.append(Event(lambda s: s[size] - self.wall, lambda s: s[:-1] + [-self.rest * s[-1]]))
        start = [number for tank in self.tanks for number in (tank.start, tank.mode)] + [self.start, 0.0]
        return Run(rates, events, start, STEP / 4)


@pytest.mark.seeds(8, 4)
def test_events_of_random_scenes(plant, seed):
    scene = Scene(seed)
    found = plant(scene.text()).outputs(ROWS)
    run = scene.run()
    truth = np.array([run.until(STEP * k) for k in range(ROWS // 10, ROWS + 1, ROWS // 10)])
    switches = [at for at, i in run.fired if i < 2 * scene.count]
    hits = [at for at, i in run.fired if i == 2 * scene.count]
    assert len(switches) > 2 and len(hits) > 0
    assert found.n[-1] == len(switches)
    last = [found.at[np.argmax(found.n == n)] for n in range(1, len(switches) + 1) if n in found.n]
    exact = [switches[n - 1] for n in range(1, len(switches) + 1) if n in found.n]
    assert np.abs(np.array(last) - exact).max() < 1e-7
    names = [f'{letter}{i}' for i in range(scene.count) for letter in 'ym'] + ['x', 'v']
    ours = np.stack([getattr(found, name)[ROWS // 10::ROWS // 10] for name in names], axis=1)
    assert np.abs(ours - truth).max() < 2e-6


@pytest.mark.parametrize('pattern, by', [
    (r'both\[1\] = .*;', 'both[1] = R(0.0);'),
    (r'set_owners\[(\d+)\] = \{0', r'set_owners[\1] = {1'),
    (r'\.rest = &iso_tableau_rk4', '.rest = &iso_tableau_euler')])
def test_a_planted_defect_is_found(plant, pattern, by):
    """A place without a step of Newton's method; a set of another event; a rest of order one."""
    scene = Scene(1)
    found = plant(scene.text(), change=lambda text: replaced(pattern, by, text).replace(
        '#include "core/methods/event.h"', '#include "core/methods/euler.h"\n#include "core/methods/event.h"')).outputs(ROWS)
    run = scene.run()
    truth = run.until(STEP * ROWS)
    names = [f'{letter}{i}' for i in range(scene.count) for letter in 'ym'] + ['x', 'v']
    assert max(abs(getattr(found, name)[-1] - t) for name, t in zip(names, truth)) > 2e-6
