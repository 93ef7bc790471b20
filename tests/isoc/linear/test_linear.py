"""Linear models. Those of random scenes with effects, trees and closed loops, away from rest, equal central differences of their plants;
Bode plots of five models meet the sines that the plants answer, one of them also by waiting until all else has decayed (decay.c);
equilibria, modes and errors in words.

Nothing in the differences is of isoc: a small turn turns a quaternion, and a four-bar linkage is closed by Newton's method on its lengths."""
import importlib.util
import pathlib
import re

import numpy as np
import pytest
from harness.programs import run
from linear_scene import scene as random_scene

README = ' '.join(pathlib.Path('tools/linear/README.md').read_text().split())
TOOL = [f'tools/{name}.c' for name in ('linear/model', 'linear/sine', 'linear/main', 'table/table', 'file/file')]


def product(a, b):
    """Of quaternions."""
    w, v = a[..., :1] * b[..., :1] - (a[..., 1:] * b[..., 1:]).sum(-1, keepdims=True), a[..., :1] * b[..., 1:] + b[..., :1] * a[..., 1:]
    return np.concatenate([w, v + np.cross(a[..., 1:], b[..., 1:])], -1)


class Differences:
    """What a plant does where one row of the model or an input is moved."""

    def __init__(self, p, row_names, geometry):
        self.p, self.names = p, row_names
        p.start()
        self.start = p.now['x'][0].copy()
        # Of a row the state, or of a turn of a quaternion, NAME_about_x, its first number and the axis of the parent.
        self.rows = [(p.places['x'][n], None) if n in p.places['x'] else (p.places['x'][n[:-7] + 'w'], 'xyz'.index(n[-1])) for n in row_names]
        self.lengths = list(map(float, geometry.split()[1:]))
        if self.lengths:
            self.angles, self.speeds = ([p.places['x'][f'j{i}{end}'] for i in range(3)] for end in ('', '_speed'))
            self.kept = next(i for i in range(3) if f'j{i}' in row_names)

    def close(self, x):
        """Moves the two other angles, and then speeds, so that the linkage stays closed."""
        l, others = self.lengths, [(self.kept + 1) % 3, (self.kept + 2) % 3]
        for i in range(8):
            first, third = x[self.angles[0]], x[self.angles[2]]
            second = first + x[self.angles[1]]
            s, c = np.array(l[:3]) * np.sin([first, second, third]), np.array(l[:3]) * np.cos([first, second, third])
            by = np.array([[-s[0] - s[1], -s[1], s[2]], [c[0] + c[1], c[1], -c[2]]])
            open_by = by @ x[self.speeds] if i == 7 else np.array([c[0] + c[1] - c[2] - l[3], s[0] + s[1] - s[2]])
            x[np.array(self.speeds if i == 7 else self.angles)[others]] -= np.linalg.solve(by[:, others], open_by)

    def moved(self, row, by):
        x, (state, axis) = self.start.copy(), self.rows[row]
        if axis is None:
            x[state] += by
        else:
            turn = np.array([np.cos(by / 2), 0, 0, 0])
            turn[1 + axis] = np.sin(by / 2)
            x[state:state + 4] = product(turn, x[state:state + 4])
        if self.lengths:
            self.close(x)
        return x

    def omega(self, x, dx, state):
        """The angular velocity in the axes of the parent: 2 q' times q conjugated."""
        return 2 * product(dx[state:state + 4], x[state:state + 4] * [1, -1, -1, -1])[1:]

    def values(self, x, u, row, by):
        """The rates of the rows and the outputs; of a small turn e, e' = omega - omega of the start - e x that."""
        memory = np.repeat(self.p.now, 2)
        memory['u'][:, :self.p.facts.inputs] = [np.zeros_like(u), u]
        slopes, y = self.p.slopes_at(memory, np.array([self.start, x]))
        rates = []
        for state, axis in self.rows:
            if axis is None:
                rates.append(slopes[1, state])
                continue
            before, e = self.omega(self.start, slopes[0], state), np.zeros(3)
            if row is not None and self.rows[row] == (state, self.rows[row][1]) and self.rows[row][1] is not None:
                e[self.rows[row][1]] = by
            rates.append((self.omega(x, slopes[1], state) - before - np.cross(e, before))[axis])
        return np.concatenate([rates, y[1]])

    def slope(self, row=None, put=None):
        """Central differences over two distances, extrapolated to none (Richardson)."""
        found = []
        for h in (4e-4, 2e-4):
            sides = []
            for by in (h, -h):
                u = np.zeros(self.p.facts.inputs)
                if row is None:
                    u[put] += by
                sides.append(self.values(self.start if row is None else self.moved(row, by), u, row, by))
            found.append((sides[0] - sides[1]) / (2 * h))
        return (4 * found[1] - found[0]) / 3


def entries(folder):
    """(matrix, row, column, value) of the model's table."""
    lines = [line.split('\t') for line in (folder / 'matrices.tsv').read_text().splitlines()[1:]]
    return [(kind, row, column, float(value)) for kind, row, column, value, *_ in lines]


def off(plant, isoc, seed, change=lambda table: table):
    """The largest difference of the model's entries from the differences, as a part of 1 + |entry|; infinite where some are missing."""
    scene, geometry = random_scene(seed)
    p, model = plant(scene), isoc(scene, '--linear')
    names = [line.split('\t')[0] for line in (model.folder / 'states.tsv').read_text().splitlines()[1:]]
    d = Differences(p, names, geometry)
    table = entries(model.folder)
    changed = change(table)
    assert changed is table or changed != table, 'nothing was planted'
    by_row, by_input = {n: d.slope(i) for i, n in enumerate(names)}, {n: d.slope(put=p.places['u'][n]) for n in p.places['u'] if p.places['u'][n] < p.facts.inputs}
    outputs = {n: len(names) + i for n, i in p.places['y'].items()}
    largest = 0.0 if len(changed) == (len(names) + len(outputs)) * (len(names) + len(by_input)) else np.inf
    for kind, row, column, value in changed:
        found = (by_row if kind in 'AC' else by_input)[column][names.index(row) if kind in 'AB' else outputs[row]]
        largest = max(largest, abs(found - value) / (1 + abs(value)))
    return largest


@pytest.mark.parametrize('number', range(1, 21))
def test_a_linear_model_equals_central_differences_of_its_plant(plant, isoc, number):
    """Every fourth scene is a closed loop."""
    assert off(plant, isoc, number) < 1e-6


def first(table, chosen, factor):
    place = next(i for i, entry in enumerate(table) if chosen(*entry))
    return table[:place] + [(*table[place][:3], factor * table[place][3])] + table[place + 1:]


@pytest.mark.parametrize('number, change', [
    (1, lambda t: first(t, lambda kind, row, column, value: kind == 'B' and value != 0, -1)),
    (1, lambda t: first(t, lambda kind, row, column, value: kind == 'A' and abs(value) > 0.1 and value != 1, 1.00001)),
    (4, lambda t: first(t, lambda kind, row, column, value: (kind, row, column) == ('A', 'j0_speed', 'j0'), 0)),
    (4, lambda t: t[:-1])], ids=['a wrong sign in B', 'an entry of A', 'in a loop no rate by the position', 'a row that is missing'])
def test_a_changed_model_is_found(plant, isoc, number, change):
    assert off(plant, isoc, number, change) >= 1e-6


# --- sines ---


@pytest.fixture(scope='module')
def linear(isoc, program):
    """linear(model, conditions): what isoc makes of the linear model, and the tool with the plant."""
    def make(name, conditions=None):
        place = pathlib.Path(f'models/{name}.scene')
        made = isoc(place, '--real', 'double')
        model = isoc(place, '--linear', *(['--trim', conditions] if conditions else []), folder=made.folder)
        return model, program(made, *TOOL, real='double', by='gcc', flags=['-D_POSIX_C_SOURCE=200809L', '-DISO_UNROLL='])

    return make


def bode(tool, point, pair):
    """The table, and within how many per cent of the model the plant's sines are."""
    done = run(tool, 'bode', point, pair)
    assert re.search('^measured 5 of 5 ', done.errors, re.M), done.errors
    return done.printed, float(re.search('within (.*) % of', done.errors)[1])


@pytest.mark.parametrize('name, conditions, pair, words, most', [
    ('cart_pole', 'pole = 0; input force = 0', 'force to pole', "^unstable: doubles every 0.121 s: hinge of body 'rod'", '1e-5'),
    ('dc_motor_bench', 'speed = 100 rad/s; free volts', 'volts to speed', '^input volts 5.28 V', '2e-5'),
    ('four_bar', 'free motor; crank_angle = 90 deg', 'motor to rocker_angle', '^equilibrium yes', '1e-5'),
    ('quadrotor', 'rest', 'thrust_front to place_x', '^unstable: swings at 0.1268 Hz', '1e-5'),
    ('quarter_car', 'rest', 'road to body', '^kink the rate of strut_speed', '1')])
def test_a_bode_plot_meets_the_sines_that_the_plant_answers(linear, tmp_path, name, conditions, pair, words, most):
    """As tools/linear/README.md has it. A model with a wrong sign in B differs by twice the gain; the measured gains stay. One plant is driven
    until all else has decayed, too."""
    model, tool = linear(name, conditions)
    assert re.search(words, model.printed + model.errors, re.M)
    point = model.folder / 'point.txt'
    table, within = bode(tool, point, pair)
    assert 0 <= within <= float(most) and f'`{pair}` | {most} % |' in README
    if name == 'cart_pole':
        wrong = tmp_path / 'point.txt'
        wrong.write_text(re.sub(r'^(B \S+) (.*)$', lambda m: ' '.join([m[1], *(str(-float(x)) for x in m[2].split())]), point.read_text(), flags=re.M))
        other, apart = bode(tool, wrong, pair)
        gains = [[line.split('\t')[:3] for line in text.splitlines() if line.startswith('plant')] for text in (table, other)]
        assert 199 < apart < 201 and gains[0] == gains[1]


def test_a_plant_that_is_driven_until_all_else_has_decayed_has_the_gain_of_its_model(linear, program, isoc, tmp_path):
    model, tool = linear('dc_motor_bench', 'speed = 100 rad/s; free volts')
    decay = program(isoc(pathlib.Path('models/dc_motor_bench.scene'), '--real', 'double'), 'tests/isoc/linear/decay.c', real='double', by='gcc', flags=['-DISO_UNROLL='])
    table, _ = bode(tool, model.folder / 'point.txt', 'volts to speed')
    point = (model.folder / 'point.txt').read_text()
    for factor, status in ((1, 0), (1.02, 1)):
        (tmp_path / 'bode.tsv').write_text(re.sub(r'^(model\t[^\t]*\t)([^\t]*)', lambda m: f'{m[1]}{float(m[2]) * factor}', table, flags=re.M))
        assert run(decay, tmp_path / 'bode.tsv', 0, 2, 1, given=point).status == status


def test_a_state_that_a_run_reaches_and_the_same_numbers_for_python_and_octave(isoc, linear, tmp_path):
    """With its tunables: after 8.1 s the circuit of the motor is open."""
    _, tool = linear('cart_pole_drive')
    reached = run(tool, 'reach', '8100000000').printed
    assert re.search('^p 2 1 0$', reached, re.M)
    (tmp_path / 'state.txt').write_text(reached)
    model = isoc(pathlib.Path('models/cart_pole_drive.scene'), '--linear', '--state', tmp_path / 'state.txt')
    assert re.search('^point a state of the run$', model.printed, re.M) and re.search('^left_out disc_count', model.printed, re.M)
    table = entries(model.folder)
    assert next(value for kind, row, column, value in table if (kind, row, column) == ('A', 'drive_current', 'rail_speed')) == 0
    spec = importlib.util.spec_from_file_location('linear_model', model.folder / 'linear_model.py')
    there = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(there)
    octave = model.file('linear_model.m')
    sides = {'A': ('state', 'state'), 'B': ('state', 'input'), 'C': ('output', 'state'), 'D': ('output', 'input')}
    for kind, row, column, value in table:
        i, k = (getattr(there, f'{side}_names').index(name) for side, name in zip(sides[kind], (row, column)))
        rows = octave.split(f'\n{kind} = [\n')[1].split('\n];')[0].splitlines()
        assert value == getattr(there, kind)[i][k] == float(rows[i].strip('; ').split(', ')[k])


@pytest.mark.parametrize('conditions, message', [
    ('thrust_front = 1 N', "no equilibrium found: 'air_turn_y_speed' of body 'frame' keeps a rate of 22.* rad/s^2"),
    ('thrust = 1 N', "no input, output or state is called 'thrust'"), ('thrust_front = 1 m', "'thrust_front' is in N; this is in m"),
    ('free place_x', 'only an input can be free'), ('place_z 1 m', 'expected = and a value'), ('rest place_z = 1 m', 'expected ;')])
def test_conditions_that_are_none_are_told(isoc, conditions, message):
    made = isoc(pathlib.Path('models/quadrotor.scene'), '--linear', '--trim', conditions)
    assert made.status == 1 and not made.folder.exists()
    assert re.search(message.replace('^2', r'\^2'), made.errors), made.errors


def test_the_states_of_an_effect_are_rows_of_their_own(isoc):
    model = isoc('''step 1 ms
body b { mass 1 kg }
joint rail prismatic { parent ground; child b; axis x }
effect pull { joint along; state first m = 1 m; state second m = 2 m; rate first = -first * 1 Hz; rate second = -second * 3 Hz
    effort on along = first * 1 N/m + second * 2 N/m }
effect p pull { along rail }
output x = position of rail
''', '--linear')
    cells = {tuple(cell): value for *cell, value in entries(model.folder) if cell[0] == 'A'}
    slopes = {('p_first', 'p_first'): -1, ('p_second', 'p_second'): -3, ('rail_speed', 'p_first'): 1, ('rail_speed', 'p_second'): 2,
              ('rail', 'rail_speed'): 1}
    names = 'rail', 'p_first', 'p_second', 'rail_speed'
    assert cells == {('A', row, column): slopes.get((row, column), 0) for row in names for column in names}
