"""`compensated yes` in closed loops with the projection, in float: what the projection moves is added with the
compensation too, so that the runs come nearer to that in double as those of trees do. Loops of five kinds of closures and
methods of each kind, from 16 starts each, since one run alone may be near by chance; over all of them ten times nearer.
Control: where the projection adds without it, at most a third is gained. One method for each loop, by turns."""
import numpy as np

from harness.plants import replaced
from harness.project import ROOT, turn

HERE = ROOT / 'tests/core/methods/compensated'
METHODS = 'heun rk4 ab4 rosenbrock'.split()
SCENES = 'four_bar slider_crank driven ball geared'.split()
# What the projection of a gear moves is nearly nothing, and of quaternions the length, which their turns do not feel.
CONTROLLED = SCENES[:3]
SECONDS, STARTS, POINTS = 2, 16, 16
# The step as a float has it, which the run in double takes too: else its time would be another one.
FLOAT_STEP = 'R(9.9999997473787516e-05)'


def in_floats(text):
    return replaced(r'R\(0\.0001\)', FLOAT_STEP, text)


def without(text):
    """The projection adds without the compensation."""
    by = 'for (int i = 0; i < (int)(sizeof moved / sizeof *moved); i++) x[settled_states[i]] += moved[i];'
    return replaced(r'iso_method_move\(.*', by, in_floats(text))


def outputs(plant, scene, method, real, compensated, change=in_floats):
    """Of runs in steps of 0.1 ms: the speeds of a start are those of the scene times 1 + k/64."""
    text = (HERE / f'{scene}.scene').read_text() + f'\ncompensated {compensated}\n'
    loop = plant(text, '--method', method, real=real, by='gcc', change=change)
    rows = []
    for k in range(STARTS):
        loop.start()
        loop.now['x'][0, loop.states - loop.states // 2:] *= 1 + k / 64
        every = int(SECONDS / 1e-4) // POINTS
        part, ended = loop.go(POINTS * every, every)
        assert ended == POINTS * every
        rows.append(part['y'][1:].astype(float))
    return np.concatenate(rows)


def tried():
    """The loops with the methods of this turn."""
    now = turn(4)
    return [(scene, method) for at, scene in enumerate(SCENES) for i, method in enumerate(METHODS)
            if now is None or i == (at + now) % 4]


def test_the_runs_come_nearer_to_that_in_double(plant):
    gains = {}
    for scene, method in tried():
        def off(*how):
            return np.sqrt(np.mean((outputs(plant, scene, method, *how) - truth) ** 2))

        truth = outputs(plant, scene, method, 'double', 'yes')
        plain = off('float', 'no')
        gains[scene, method] = plain / off('float', 'yes')
        if scene in CONTROLLED:
            assert gains[scene, method] >= 3 * plain / off('float', 'yes', without), (scene, method)
    assert min(gains.values()) >= 3, gains
    mean = np.exp(np.mean(np.log(list(gains.values()))))
    print(f'over {len(gains)} of them {mean} times nearer, the geometric mean')
    assert mean >= 10
    if len(gains) == len(SCENES) * len(METHODS):
        words = ' '.join((ROOT / 'core/README.md').read_text().split())
        assert f'five loops in float come {mean:.0f} times nearer to their runs in double' in words
