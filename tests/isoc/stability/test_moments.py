"""What isoc says of the start and of the end of a run: joints that turn too far in a step, sums in float that grow too
slowly, an energy that nothing in the scene changes and that is another one. What is right is told nothing."""
import pathlib
import random
import sys

import numpy as np
import pytest

sys.path.append(str(pathlib.Path(__file__).parents[1] / 'closure/singular'))
from draw import drawn  # noqa: E402

ROTOR = '''
step 1 ms
body frame { mass 2 kg; inertia (0.1, 0.2, 0.15) kg*m^2 }
body rotor { mass 1 kg; com (0.001, 0, 0) m; inertia (0.01, 0.01, 0.02) kg*m^2 }
joint f spherical { parent ground; child frame; spin (0.3, 0.2, 0.5) rad/s }
joint s revolute { parent frame at (0, 0, 0.2) m; child rotor; axis z; continuous; speed 30000 rpm }
output energy = energy
'''
SLIDE = '''
step 1 ms
body b { mass 1 kg }
joint j prismatic { parent ground; child b; axis x; start 100 m; speed 0.1 m/s }
output x = position of j
'''
CELL = '''
step 1 ms
body b { mass 1 kg }
joint j prismatic { parent ground; child b; axis x }
effect store { value current A; state charge s*A = 100 Ah; rate charge = -current; output charge }
effect cell store { current 1 A }
output q = cell.charge
'''
WORDS = ('turns by', 'rounding in float', 'the energy is')


def told(errors):
    """The beginnings of these warnings that isoc said."""
    return [word for word in WORDS if word in errors]


def ended(isoc, scene, x, ticks, folder, *options):
    """What isoc says of the end of a run."""
    end = folder / 'last.txt'
    end.write_text(f'ticks {ticks}\nstate ' + ' '.join(repr(float(value)) for value in x) + '\n')
    made = isoc(scene, *options, '--ended', end, writes=False)
    assert made.status == 0, made.errors
    return made.errors


def last_words(isoc, plant, scene, ticks, folder, *options, real='double', **of_plant):
    rows = plant(scene, *options, real=real, **of_plant).run(ticks, every=ticks)
    return ended(isoc, scene, rows['x'][-1], ticks, folder, *options, '--real', real)


def test_fast_rotor(isoc, plant, tmp_path):
    first = isoc(ROTOR).errors
    assert told(first) == ['turns by'] and "'s' turns by 3.14 rad" in first
    assert 'take a step of 0.159 ms, or `substeps 7`' in first
    assert 'turns by' in last_words(isoc, plant, ROTOR, 100, tmp_path)
    assert not told(isoc(ROTOR, '--step', '0.15ms').errors) and not told(isoc(ROTOR + 'substeps 7').errors)
    # Around a round and balanced wheel the motion does not depend on the angle.
    assert not told(isoc(ROTOR.replace('com (0.001, 0, 0) m; ', '')).errors)


def test_fast_body(isoc):
    body = ('step 10 ms\nbody b { mass 1 kg; inertia (2, 3, 4) kg*m^2 }\noutput p = position of b\n'
            'joint j free { parent ground; child b; spin (30, %d, 30) rad/s }\n')
    assert told(isoc(body % 30).errors) == ['turns by'] and not told(isoc(body % 2).errors)


def test_screw(isoc, tmp_path):
    """All joints of a loop turn together: the motion depends on the angle of none."""
    scene = pathlib.Path('tests/isoc/mechanism/lead_screw.scene')
    assert not told(ended(isoc, scene, [2.7, -2.7, 1660, -1660], 10000, tmp_path))
    tilted = scene.read_text().replace('mass 1 kg\n', 'mass 1 kg; com (1, 0, 0) mm\n') + 'gravity (0, -9.81, 0) m/s^2'
    assert told(ended(isoc, tilted, [2.7, -2.7, 1660, -1660], 10000, tmp_path)) == ['turns by']


@pytest.mark.parametrize('step, says', [('1ms', ['the energy is']), ('0.25ms', [])])
def test_fast_loop(isoc, plant, tmp_path, step, says):
    """Its steps are too long, and it is near no singular position."""
    scene = pathlib.Path('tests/isoc/stability/fast_loop.scene')
    ticks = 10000 if step == '1ms' else 40000
    assert told(last_words(isoc, plant, scene, ticks, tmp_path, '--step', step, by='gcc')) == says


def test_slow_sums(isoc, plant, tmp_path):
    for scene in (SLIDE, CELL):
        assert told(isoc(scene).errors) == ['rounding in float']
        assert told(last_words(isoc, plant, scene, 1000, tmp_path, real='float')) == ['rounding in float']
        assert not told(isoc(scene + 'compensated yes').errors) and not told(isoc(scene, '--real', 'double').errors)
    start = SLIDE.replace('start 100 m', 'start 0 m')
    assert not told(isoc(start).errors) and not told(last_words(isoc, plant, start, 1000, tmp_path, real='float'))
    assert told(last_words(isoc, plant, start, 1000000, tmp_path, real='float')) == ['rounding in float']


STICK = '''
step 1 ms
body block { mass 2 kg }
joint rail prismatic { parent ground; child block; axis x; start %r m }
effect stick { joint along; value drive m/s; value k N/m; state pull m = 0 m; rate pull = drive - speed of along
    effort on along = k * pull }
effect e stick { along rail; drive 0.1 m/s; k 100 N/m }
effect rub friction { along rail; sliding 4 N; static 6 N }
output x = position of rail
'''


def test_sums_of_what_sticks_and_slips(isoc, plant, tmp_path):
    """A block that a belt pulls in leaps: between them it creeps, by less than half a last place of 100 m in a step. What
    slips is told nothing, nor is the same block near zero, where its creep counts."""
    for place, says in ((100, ['rounding in float']), (0, [])):
        rows = plant(STICK % place, real='float').run(10000, every=10)['x'].astype(float)
        creeps = [i for i in range(500, 1000) if 5e-4 < rows[i - 3:i + 1, 2].min() and rows[i - 3:i + 1, 2].max() < 1.5e-3]
        slips = [i for i in range(500, 1000) if rows[i, 2] > 0.1]
        assert len(creeps) > 20 and len(slips) > 10
        for i in creeps[::4]:
            assert told(ended(isoc, STICK % place, rows[i], 10 * i, tmp_path)) == says, (place, i)
        for i in slips[::4]:
            assert not told(ended(isoc, STICK % place, rows[i], 10 * i, tmp_path)), (place, i)


@pytest.mark.seeds(40, 10)
def test_family_of_sums(isoc, plant, seed):
    """A body at a constant speed: a sum that loses 1 % of its way and more, besides 200 of its last places, is told, one
    that loses less than 0.1 % is not."""
    draw_ = random.Random(seed)
    place, speed = 10 ** draw_.uniform(-1, 3), 10 ** draw_.uniform(-5, 0)
    scene = SLIDE.replace('start 100 m', f'start {place!r} m').replace('0.1 m/s', f'{speed!r} m/s')
    x = plant(scene, real='float').run(10000, every=10000)['x'][:, 0].astype(float)
    lost = abs(x[1] - x[0] - 10 * float(np.float32(speed)))
    says = told(isoc(scene).errors)
    if lost > 0.1 * speed and lost > 200 * np.finfo(np.float32).eps * place:
        assert says == ['rounding in float'], (place, speed, lost)
    elif lost < 0.01 * speed:
        assert not says, (place, speed, lost)


def chain(seed):
    """A random chain of bodies in space without gravity or losses: all its energy is kinetic."""
    of = random.Random(seed)

    def vector(size):
        return '(' + ', '.join(repr(of.uniform(-size, size)) for _ in range(3)) + ')'
    lines, parent = [], 'ground'
    for i in range(of.randint(1, 4)):
        kind = of.choice(('revolute', 'revolute', 'spherical'))
        speed = 10 ** of.uniform(0, 2)
        lines.append(f'body b{i} {{ box (0.3, {of.uniform(0.1, 0.4)!r}, 0.1) m of {of.uniform(0.5, 2)!r} kg at {vector(0.3)} m }}')
        motion = f'axis {vector(1)}; speed {speed!r} rad/s' if kind == 'revolute' else f'spin {vector(speed)} rad/s'
        lines.append(f'joint j{i} {kind} {{ parent {parent} at {vector(0.5)} m; child b{i}; {motion} }}')
        parent = f'b{i}'
    method = of.choice('rk4 heun ab4 semi_implicit euler'.split())
    step = 10 ** of.uniform(2, 4.5)
    return '\n'.join(lines + [f'step {step:.0f} us', f'method {method}', 'output energy = energy']), step


def loop(seed):
    """A planar loop that keeps away from singular positions."""
    step = 10 ** random.Random(seed).uniform(3, 4.7)
    return drawn(seed, 0.3).replace('step 1 ms', f'step {step:.0f} us'), step


def verdict(isoc, plant, scene, step, folder):
    """Whether a run of 2 s keeps its energy to 1 %, and what isoc says of it; a guard that ends it says enough."""
    ticks = int(2e6 / step)
    run = plant(scene)
    rows = run.run(ticks, whole=False)
    energy = rows['y'][:, 0]
    if len(rows) <= ticks:
        return False, ['guard']
    says = told(run.made.errors) + told(ended(isoc, scene, rows['x'][-1], ticks, folder, '--real', 'double'))
    return abs(energy[-1] - energy[0]) <= 0.01 * energy[0], says


@pytest.mark.seeds(60, 12)
@pytest.mark.parametrize('family', [chain, loop])
def test_family_of_long_steps(isoc, plant, tmp_path, family, seed):
    """Each run is told, or right within 1 % of its energy."""
    right, says = verdict(isoc, plant, *family(seed), tmp_path)
    assert right or says


def test_families_have_both(isoc, plant, tmp_path):
    """Some runs are right and told nothing, and some are told by their energy alone."""
    seen = [(right, tuple(says)) for family in (chain, loop) for right, says in
            (verdict(isoc, plant, *family(seed), tmp_path) for seed in range(1, 31))]
    assert seen.count((True, ())) > 10 and seen.count((False, ('the energy is',))) > 3


def test_damping_gives_nothing(isoc, plant, tmp_path):
    """With losses alone the energy may fall, and may not rise."""
    scene = pathlib.Path('models/pendulum.scene').read_text().replace('axis z\n', 'axis z\n damping 0.2 N*m*s/rad\n')
    assert not told(last_words(isoc, plant, scene, 2000, tmp_path))
    assert told(ended(isoc, scene, [0.3, 5.0], 2000, tmp_path)) == ['the energy is']


@pytest.mark.parametrize('of_joint, alone, giver', [
    ('drive motor', None, 'input motor'),
    ('spring k', 'tunable k = 1 N*m/rad', 'at 1 s set k = 2 N*m/rad'),
    ('', 'effect push { joint along; effort on along = 1 N*m }', 'effect p push { along pivot }'),
    ('', '', 'input wind; force f { body bob; axis x; drive wind }')])
def test_what_gives_energy(isoc, tmp_path, of_joint, alone, giver):
    """Where an input, a change or an effect has a part in the energy, nothing is told of it."""
    scene = pathlib.Path('models/pendulum.scene').read_text().replace('axis z\n', f'axis z\n {of_joint}\n')
    if alone is not None:
        assert told(ended(isoc, scene + alone, [0.3, 5.0], 2000, tmp_path)) == ['the energy is']
    assert not told(ended(isoc, f'{scene}{alone or ""}\n{giver}\n', [0.3, 5.0], 2000, tmp_path))


def test_planted_gain(isoc, plant, tmp_path):
    """A plant with 1 % more gravity than the scene is told."""
    scene = pathlib.Path('models/pendulum.scene')
    assert not told(last_words(isoc, plant, scene, 10000, tmp_path))
    planted = last_words(isoc, plant, scene, 10000, tmp_path, change=lambda text: text.replace('9.81', '9.9081'))
    assert told(planted) == ['the energy is']


@pytest.mark.parametrize('scene', sorted(map(str, [*pathlib.Path('models').glob('*.scene'), *pathlib.Path('tests').glob('*/*.scene')])))
def test_no_false_alarm(isoc, plant, tmp_path, scene):
    """Models that are right are told nothing, at their starts and after 2 s."""
    made = isoc(pathlib.Path(scene), '--real', 'float')
    if made.status != 0:
        pytest.skip('it is refused')
    assert not told(made.errors)
    of = plant(pathlib.Path(scene), real='float')
    ticks = round((0.1 if 'stewart' in scene else 2) / of.step_size)
    rows = of.run(ticks, every=ticks, whole=False)
    if len(rows) == 2:
        says = told(ended(isoc, pathlib.Path(scene), rows['x'][-1], ticks, tmp_path, '--real', 'float'))
        assert says == (['the energy is'] if scene in WRONG else [])


# Near a dead position, which the run tells too.
WRONG = ['tests/isoc/closure/singular/near_dead.scene']


def test_said_once(isoc, tmp_path):
    """The end of a run tells what is of the end alone: what was said of the plant is not said again."""
    odd = SLIDE.replace('mass 1 kg', 'mass 1 kg; inertia (1, 2, 4) g*m^2 as_given')
    assert isoc(odd).errors.count('warning') == 2
    said = ended(isoc, odd, [101.0, 0.1], 10000, tmp_path)
    assert said.count('warning') == 1 and told(said) == ['rounding in float']


def test_no_end(isoc, tmp_path):
    for text in ('', 'ticks 3\nstate 1', 'state 1 2'):
        (tmp_path / 'last.txt').write_text(text)
        made = isoc(ROTOR, '--ended', tmp_path / 'last.txt', writes=False)
        assert made.status == 1 and 'is no end of a run of' in made.errors
