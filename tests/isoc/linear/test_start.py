"""What isoc knows of the start is row 0 of the plant: every function of time, of a scene's input and in a formula, with
limits, held and smooth, by everything of isoc that looks there."""
import random
import re

import numpy as np
import pytest

# One ulp of a float for the table of a literal, some for sines, at numbers up to 20; in double the host computes the
# same numbers, and a linear model adds roundings of its own.
CLOSE = {'float': 1e-5, 'double': 1e-12}


def of_time(kind, r, place, least=-3, most=3):
    """A function of time with random arguments; a constant is within the limits."""
    f, phase, late = r.uniform(1, 20), r.uniform(-180, 180), r.choice([0, 0, 3, 40])
    if kind == 'file':
        (place / 'data.csv').write_text(f'{late / 1000}, {r.uniform(-3, 3)}\n0.9, 2\n')
        return 'file "data.csv"'
    return {
        'constant': f'{r.uniform(least, most):.6f}',
        'sin': f'sin({f:.4f} Hz, {phase:.3f} deg)',
        'cos': f'cos({f:.4f} Hz, {phase:.3f} deg)',
        'time': f'({r.uniform(-3, 3):.6f} + time / 1 s)',
        'table': f'table({late} ms: {r.uniform(-3, 3):.5f}, 1 s: 2)',
        'ramp': f'ramp({late} ms: {r.uniform(-3, 3):.5f}, 1 s: 2)',
        'noise': f'noise({r.randrange(1000)})',
        'step': f'step({late} ms)',
        'square': f'square({r.choice([5, 10, 12.5])} Hz, {phase:.3f} deg)',
        'square of any period': f'square({f:.4f} Hz, {phase:.3f} deg)',
        'prbs': f'prbs({r.randrange(1, 500)}, 2 ms, 9)',
        'chirp': f'(0.5 + chirp({f:.4f} Hz, 30 Hz, 2 s))',
    }[kind]


IN_FORMULAS = ['constant', 'time', 'noise', 'step', 'square', 'square of any period', 'prbs', 'chirp', 'file']
IN_INPUTS = IN_FORMULAS + ['sin', 'cos', 'table', 'ramp']
FORMS = ['held', 'smooth', 'in -0.6 to 0.7', 'in 0.2 to 5', 'tunable', 'formula']
CASES = [(kind, form) for form in FORMS for kind in (IN_FORMULAS if form == 'formula' else IN_INPUTS)]


def scene_of(kind, form, r, place):
    """A body that an effect pulls with a stiffness which follows a function of time: `wave` in the outputs."""
    wave = of_time(kind, r, place, *(map(float, form[3:].split(' to ')) if form.startswith('in') else ()))
    limits, reading = (form if form.startswith('in') else ''), (' smooth' if form == 'smooth' else '')
    if form == 'tunable':
        wave = f'gain * {wave}'
    return f'''
step 1 ms
body b {{ mass 2 kg }}
joint j prismatic {{ parent ground; child b; axis x; start 0.1 m; speed 0.2 m/s; drive push }}
{'signal' if form == 'formula' else 'input'} wave{reading} = {wave} {limits}
input push = 3 N * cos(1 Hz) in 1 N to 2 N
tunable k = 1 N/m
tunable gain = 1
at 0 s set k = 4 N/m
at 0 s set gain = 1.25
effect pull {{
    joint along
    signal a
    value k N/m
    state z = 2 * a + 1 / (1 m) * position of along
    rate z = -z * a / 1 s
    memory q = z + a
    next q = 0.5 * q + a
    effort on along = -k * a * position of along
    output z
    output q
}}
effect e pull {{ along j; a wave; k k }}
output wave_now = wave
output rate = acceleration of j
output z = e.z
output q = e.q
output given = push
'''


def case(kind, form, seed, place):
    """A scene and its number type: the same for all tests, so that its plant is compiled once."""
    r = random.Random(f'{kind} {form} {seed}')
    real = r.choice(['float', 'double'])
    return scene_of(kind, form, r, place), real


def numbers(text, name):
    return np.array([float(n) for n in re.search(rf'^{name} = \[(.*)\]$', text, re.M)[1].split(', ')])


@pytest.fixture
def written(tmp_path):
    def write(text):
        path = tmp_path / 'start.scene'
        path.write_text(text)
        return path

    return write


def row_0(plant, scene, real, change=None):
    y = plant(scene, real=real, change=change).outputs(1)
    return {name: float(y.rows[0, i]) for i, name in enumerate(['wave_now', 'rate', 'z', 'q', 'given'])}


def compare(isoc, row, scene, real):
    """The linear model, and the starts that are numbers in the text of a plant and of an FMU, with row 0."""
    close = dict(rtol=CLOSE[real], atol=CLOSE[real])
    made = isoc(scene, '--linear', '--real', real)
    assert made.status == 0, made.errors
    model = made.file('linear_model.py')
    slopes = re.search(r'^A = \[\n(.*?)\n\]', model, re.M | re.S)[1].splitlines()
    start = re.search(r'X_E_Z\] = R\((.*)\)', isoc(scene, '--real', real).file('plant.c'))[1]
    described = isoc(scene, '--fmu', '--real', real).file('modelDescription.xml')
    np.testing.assert_allclose(numbers(model, 'output_point'), list(row.values()), **close)
    np.testing.assert_allclose(numbers(model, 'state_rates')[1:], [-row['z'] * row['wave_now'], row['rate']], **close)
    np.testing.assert_allclose(float(slopes[2].strip(' [],').split(', ')[0]), -4 * row['wave_now'] / 2, **close)
    np.testing.assert_allclose(float(start), row['z'], **close)
    start = re.search(r'name="states.e_z".* start="([^"]*)"', described)[1]
    np.testing.assert_allclose(float(start), row['z'], **close)


@pytest.mark.parametrize('kind, form', CASES)
def test_linear_model_and_starts(isoc, plant, written, tmp_path, seed, kind, form):
    scene, real = case(kind, form, seed, tmp_path)
    scene = written(scene)
    compare(isoc, row_0(plant, scene, real), scene, real)


def test_another_row_0_is_found(isoc, plant, written, tmp_path):
    """The control: a plant whose square begins in its other half."""
    scene = written(scene_of('square', 'held', random.Random(1), tmp_path))
    row = row_0(plant, scene, 'double', change=lambda text: text.replace('= iso_square(', '= -iso_square('))
    with pytest.raises(AssertionError, match='Not equal'):
        compare(isoc, row, scene, 'double')


@pytest.mark.parametrize('kind, form', CASES)
def test_stability(isoc, plant, written, tmp_path, seed, kind, form):
    """The eigenvalue that isoc tells of a spring of 4e8 N/m times the size of the function."""
    scene, real = case(kind, form, seed, tmp_path)
    wave = row_0(plant, written(scene), real)['wave_now']
    made = isoc(written(scene.replace('k * a * position', '1e8 * k * abs(a) * position')), '--real', 'double')
    told = re.search(r"'e' is too fast .* at the start has the eigenvalue (?:0 \+- )?(\S+)", made.errors)
    if abs(wave) < 0.1:
        return  # slow enough
    assert told, (wave, made.errors)
    np.testing.assert_allclose(float(told[1]), np.sqrt(4e8 * abs(wave) / 2), rtol=1e-3)


@pytest.mark.parametrize('kind, form', CASES)
def test_division_by_the_start(isoc, plant, written, tmp_path, seed, kind, form):
    """An effort that divides by the function is refused where the plant divides by zero in row 0, and nowhere else."""
    scene, real = case(kind, form, seed, tmp_path)
    wave = row_0(plant, written(scene), real)['wave_now']
    made = isoc(written(scene.replace('a * position of along', 'position of along / a')))
    assert made.status == (wave == 0.0), (wave, made.errors)
    assert ('a division by what is zero at the start' in made.errors) == (wave == 0.0)


def test_an_input_of_the_port(isoc, plant, written):
    """It is zero at the start, or the limit that is nearest to that."""
    for limits, start in ('', 0), ('in -1 to 3', 0), ('in 2 to 3', 2), ('in -3 to -2', -2):
        scene = written(re.sub('input wave = .*', f'input wave V/V {limits}', scene_of('constant', 'held', random, None)))
        assert row_0(plant, scene, 'double')['wave_now'] == start
        assert numbers(isoc(scene, '--linear', '--real', 'double').file('linear_model.py'), 'input_point')[0] == start
        described = isoc(scene, '--fmu').file('modelDescription.xml')
        assert float(re.search(r'name="wave" .* start="([^"]*)"', described)[1]) == start


def test_equilibrium(isoc, written):
    """10 N push at the start. The control: a function that is zero there."""
    scene = '''
step 1 ms
body b {{ mass 2 kg }}
input push N = 10 N * {}
joint j prismatic {{ parent ground; child b; axis x; drive push; damping 1 N*s/m }}
output a = acceleration of j
'''
    assert 'equilibrium no: the rate of j_speed' in isoc(written(scene.format('square(5 Hz)')), '--linear').printed
    assert 'equilibrium yes' in isoc(written(scene.format('step(1 s)')), '--linear').printed


@pytest.mark.parametrize('kind', IN_INPUTS)
def test_trim(isoc, plant, written, tmp_path, seed, kind):
    """A spring of 4 N/m comes to rest where it carries the force that pushes at the start."""
    r = random.Random(f'trim {kind} {seed}')
    scene = written(f'''
step 1 ms
body b {{ mass 2 kg }}
input push N = 1 N * {of_time(kind, r, tmp_path, -2, 2)} in -2 N to 2 N
joint j prismatic {{ parent ground; child b; axis x; drive push; spring 4 N/m }}
output given = push
output place = position of j
''')
    given = float(plant(scene).outputs(1).rows[0, 0])
    model = isoc(scene, '--linear', '--trim', 'rest', '--real', 'double').file('linear_model.py')
    np.testing.assert_allclose(numbers(model, 'output_point'), [given, given / 4], rtol=1e-7, atol=1e-7)


@pytest.mark.parametrize('motion', ['0.3 rad * sin(2 Hz, 40 deg)', 'ramp(0 s: 0 rad, 1 s: 2 rad)', 'ramp(0.5 s: 0.2 rad, 1 s: 2 rad)',
                                    '(1 rad/s) * time'])
def test_motions(isoc, plant, written, motion):
    """The clock of a motion, and what is assembled by it."""
    scene = written(f'''
step 1 ms
body b {{ mass 2 kg; com (0, 1, 0) m }}
joint j revolute {{ parent ground; child b; axis z }}
close c motion {{ first j; motion {motion} }}
output place = position of j
output rate = speed of j
''')
    rows = plant(scene).run(1)
    model = isoc(scene, '--linear', '--real', 'double').file('linear_model.py')
    np.testing.assert_allclose(numbers(model, 'output_point'), rows['y'][0], rtol=1e-12, atol=1e-12)
    text = isoc(scene, '--real', 'double').file('plant.c')
    clocks = [float(n) for n in re.findall(r'^    \[PLANT_X_CLOCK_\d+\] = R\((.*)\)', text, re.M)]
    np.testing.assert_allclose(clocks, rows['x'][0, 1:1 + len(clocks)], rtol=1e-15, atol=1e-15)
