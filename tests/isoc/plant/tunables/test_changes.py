"""Tunables: what follows from them alone is computed when one changes. A change between two ticks is what a plant does that was
compiled with these values; the rest of a step costs as much as with constants."""
import pathlib
import re

import numpy as np
import pytest
from harness.plants import replaced

CHAIN = pathlib.Path('tests/isoc/plant/tunables/chain.scene').read_text()
FIXED = replaced(r'^tunable (\w+ = [0-9.]+ \S+) in .*', r'constant \1', CHAIN)
OTHER = 'rod = 0.45 kg; length = 0.27 m; drag = 0.03 N*m*s/rad; stiffness = 3.3 N*m/rad; delay = 35 ms'
VALUES = [0.45, 0.27, 0.03, 3.3, 0.035]
TICKS = 200
WAYS = [(*way, 'float') for way in [('rk4', 'held'), ('rk4', 'smooth'), ('ab4', 'smooth'), ('bdf4', 'smooth'), ('rosenbrock', 'held'),
                                    ('semi_implicit', 'held'), ('adams', 'held')]] + [('rk4', 'held', 'double')]


@pytest.fixture(scope='module', params=WAYS, ids='-'.join)
def way(request):
    method, inputs, real = request.param
    return ['--method', method, '--inputs', inputs], real


def tuned_of(plant, way, **of_plant):
    return plant(CHAIN, *way[0], real=way[1], **of_plant)


def change(p, count=5):
    p.now['p'][0, :count] = VALUES[:count]


def goes_on_as_compiled(plant, way, **of_plant):
    """Whether after a change between two ticks the bits are those of a plant that was compiled with these values; the restarts
    before it and after it."""
    p, other = tuned_of(plant, way, **of_plant), plant(CHAIN, *way[0], '--set', OTHER, real=way[1])
    p.start()
    p.go(TICKS)
    before = p.facts.restarts
    other.start()
    other.now['x'] = p.now['x']
    other.begin(TICKS)
    change(p)
    rows, others = p.go(TICKS, first=TICKS)[0], other.go(TICKS, first=TICKS)[0]
    return rows['x'].tobytes() == others['x'].tobytes(), before, p.facts.restarts


def test_a_change_between_two_ticks_has_the_bits_of_a_plant_that_was_compiled_so(plant, way):
    assert goes_on_as_compiled(plant, way) == (True, 0, 1)


def test_a_plant_that_does_not_look_is_found(plant):
    forgets, *_ = goes_on_as_compiled(plant, WAYS_OF_CONTROL, change=lambda text: replaced(r'^    found \|= memory->changed != 0;$', '', text))
    assert not forgets


WAYS_OF_CONTROL = ['--method', 'rk4', '--inputs', 'held'], 'double'


def test_the_derivative_is_that_with_constants_to_rounding(plant, way):
    """An acceleration is a sum of some 30 products of up to three times its size, each with a rounding in either plant."""
    p, fixed = tuned_of(plant, way), plant(FIXED, *way[0], '--set', OTHER, real=way[1])
    assert 'static void tune(' in p.made.file('plant.c')
    assert not re.search(r'PLANT_P_|p\[', fixed.made.file('plant.c')), 'a constant is a literal'
    rows, others = (q.follow(TICKS, sets=sets).rows for q, sets in ((p, {0: dict(zip(p.places['p'], VALUES))}), (fixed, None)))
    rows = rows.copy()
    slopes, constants = p.slopes_at(rows[1:], rows['x'][1:])[0], fixed.slopes_at(others[1:], rows['x'][1:])[0]
    assert 0 < np.abs(slopes - constants).max() <= 100 * p.ulp * np.abs(constants).max()


def test_a_copy_of_the_memory_is_all(plant, way):
    """What was tried after it leaves no trace; two plants, each with its own tunables, a tick of one after a tick of the other."""
    p = tuned_of(plant, way)
    p.start()
    change(p, 3)
    p.go(TICKS)
    kept = p.now.copy()
    straight = p.go(TICKS, first=TICKS)[0]['x'].tobytes()
    p.now[:] = kept
    change(p)
    other_way = p.go(TICKS, first=TICKS)[0]['x'].tobytes()
    p.now[:] = kept
    assert p.go(TICKS, first=TICKS)[0]['x'].tobytes() == straight != other_way
    ends = []
    for count in (0, 2):
        p.start()
        change(p, count)
        p.go(20)
        ends.append(p.now['x'].tobytes())
    memories = []
    for count in (0, 2):
        p.start()
        change(p, count)
        memories.append(p.now.copy())
    for tick in range(20):
        for memory in memories:
            p.now[:] = memory
            p.go(1, first=tick)
            memory[:] = p.now
    assert [memory['x'].tobytes() for memory in memories] == ends and ends[0] != ends[1]


def test_what_is_not_finite_is_no_change_and_a_limit_that_is_passed_is_one(plant, way):
    p = tuned_of(plant, way)
    p.start()
    p.go(1)
    restarts, tick = [p.facts.restarts], 1
    for value in (np.nan, 100, 200):
        p.now['p'][0, 0] = value
        p.go(2, first=tick)
        restarts.append(p.facts.restarts)
        tick += 2
    assert np.diff(restarts).tolist() == [0, 1, 0] and p.now['p'][0, 0] == p.number(1)


# --- what tunables cost on the board ---


def on_board(isochron, tmp_path, scene, kind):
    """Of a short run with its tunables as this kind of parameter: the instructions of a step, and the margin of a tick."""
    (tmp_path / 'plant.scene').write_text(replaced('^tunable ', f'{kind} ', scene) if kind != 'tunable' else scene)
    said = isochron('run', tmp_path / 'plant.scene', '--target', 'cortex-m4f', '--seconds', '0.1').said
    return int(said['instructions_per_step']), int(said['margin'].split()[0]), said


def costs(isochron, tmp_path, scene):
    """With tunables a step takes at most 2 % and 15 more instructions than with constants, which are literals; and another number,
    so that it is another plant. In one with many spills gcc may find it the cheaper one. Returns both, and what the rest of a tick
    takes more."""
    (constant, left, _), (step, margin, _) = (on_board(isochron, tmp_path, scene, kind) for kind in ('constant', 'tunable'))
    assert 0 < constant != step and 100 * (step - constant) <= 2 * constant + 1500
    return step, constant, left - margin - (step - constant)


def core_says(text):
    return text in ' '.join(pathlib.Path('core/README.md').read_text().split())


def test_tunables_of_a_small_plant_cost_what_core_says(isochron, tmp_path):
    step, constant, _ = costs(isochron, tmp_path, pathlib.Path('models/cart_pole.scene').read_text())
    assert core_says(f'`cart_pole` takes {step} instructions, with constants {constant}.')


def changed(text, *changes):
    for pattern, by in changes:
        text = replaced(pattern, by, text)
    return text


SIX = '''tunable mass = 1.2 kg
tunable about_x = 12 g*m^2
tunable about_y = 12.5 g*m^2
tunable about_z = 21 g*m^2
'''
OF_BODY = [('    mass 1.2 kg', '    mass mass'),
           (r'inertia \(12, 12.5, 21; 0.1, 0.2, -0.1\) g.*', 'inertia (about_x, about_y, about_z; 0.1 g*m^2, 0.2 g*m^2, -0.1 g*m^2)')]


def test_six_tunables_of_the_quadrotor_cost_what_core_says(isochron, tmp_path):
    scene = changed(pathlib.Path('models/quadrotor.scene').read_text(), *OF_BODY, (r' damping 0\.2.*', ' damping drag'),
                    ('spin_damping 5.*', 'spin_damping spin_drag'),
                    ('^constant hover', SIX + r'tunable drag = 0.2 N*s/m\ntunable spin_drag = 5 mN*m*s/rad\n\g<0>'))
    step, constant, beside = costs(isochron, tmp_path, scene)
    with_change, _, said = on_board(isochron, tmp_path, replaced('^step.*$', r'\g<0>\nat 50 ms set mass = 1.5 kg', scene), 'tunable')
    after = int(said['restart_execution'].split()[0])
    assert with_change == step and said['restarts'] == '1' and step < after < step + 100
    assert core_says(f'takes {step} instructions of a step on the Cortex-M4F, with constants {constant}; the step after a change takes '
                     f'{after}, and the checks of the tunables {beside} in each tick'), (step, constant, after, beside)


def test_seven_tunables_of_the_quadrotor_with_effects_cost_little(isochron, tmp_path):
    """Its mass and inertia, and of its propellers and of the air."""
    scene = changed(pathlib.Path('models/quadrotor_sih.scene').read_text(), *OF_BODY, ('lag 50 ms', 'lag lag'), (r'area 500 cm\^2', 'area face'),
                    ('^constant thrust', 'tunable thrust'), ('^constant arm', SIX + r'tunable lag = 50 ms\ntunable face = 500 cm^2\n\g<0>'))
    assert len(re.findall('^tunable ', scene, re.M)) == 7
    costs(isochron, tmp_path, scene)
