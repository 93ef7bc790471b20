"""Tables of one number and of two, written in the scene and in a file: values against numpy between the points and beyond them, smooth
ones, units of a file's head, and what is refused."""
import random

import numpy as np
import pytest

MOVES = '''step 1 ms
body b {{ mass 1 kg }}
joint j prismatic {{ parent ground; child b; axis x; start -5 m; speed 10 m/s }}
joint k prismatic {{ parent ground; child c; axis x; start 4 m; speed -7 m/s }}
body c {{ mass 1 kg }}
output x = position of j
output y = position of k
{}
'''


def numbers(r, count, least, most):
    """So many numbers that increase."""
    return np.round(np.sort(np.array(r.sample(range(1, 1000), count)) / 1000) * (most - least) + least, 3)


def pchip(x, y, at):
    """The monotone cubic of Fritsch and Butland, by its four basis polynomials, and the lines of its ends' slopes beyond them."""
    h, d = np.diff(x), np.diff(y) / np.diff(x)
    slope = np.zeros(len(x))
    for i in range(1, len(x) - 1):
        if d[i - 1] * d[i] > 0:
            a, b = 2 * h[i] + h[i - 1], h[i] + 2 * h[i - 1]
            slope[i] = (a + b) / (a / d[i - 1] + b / d[i])
    for i, j, of in ((0, 1, slice(None, 2)), (-1, -2, slice(None, -3, -1))):
        first, second = d[of]
        m = ((2 * h[i] + h[j]) * first - h[i] * second) / (h[i] + h[j])
        slope[i] = 0 if m * first <= 0 else 3 * first if first * second <= 0 and abs(m) > 3 * abs(first) else m
    i = np.clip(np.searchsorted(x, at) - 1, 0, len(h) - 1)
    t = (np.clip(at, x[0], x[-1]) - x[i]) / h[i]
    inside = ((1 + 2 * t) * (1 - t)**2 * y[i] + t**2 * (3 - 2 * t) * y[i + 1]
              + h[i] * (t * (1 - t)**2 * slope[i] + t**2 * (t - 1) * slope[i + 1]))
    return inside, inside + slope[0] * np.minimum(at - x[0], 0) + slope[-1] * np.maximum(at - x[-1], 0)


def lines(x, y, at):
    """Straight lines; and those that go on beyond the ends."""
    first, last = (y[1] - y[0]) / (x[1] - x[0]), (y[-1] - y[-2]) / (x[-1] - x[-2])
    held = np.interp(at, x, y)
    return held, held + first * np.minimum(at - x[0], 0) + last * np.maximum(at - x[-1], 0)


def bilinear(x, y, z, at, up, goes_on):
    def cell(places, value):
        i = np.clip(np.searchsorted(places, value) - 1, 0, len(places) - 2)
        t = (value - places[i]) / (places[i + 1] - places[i])
        return i, t if goes_on else np.clip(t, 0, 1)
    (i, s), (j, t) = cell(x, at), cell(y, up)
    return (1 - t) * ((1 - s) * z[j, i] + s * z[j, i + 1]) + t * ((1 - s) * z[j + 1, i] + s * z[j + 1, i + 1])


def close(real, points):
    """Every point adds a rounding of numbers up to 10, and beyond the ends of some tens."""
    return 40 * points * (2.0**-24 if real == 'float' else 2.0**-53)


@pytest.mark.seeds(6)
@pytest.mark.parametrize('real', ['float', 'double'])
def test_of_one_number(plant, tmp_path, seed, real):
    r = random.Random(seed)
    x = numbers(r, r.randint(2 + seed % 2, 12), -3, 3)
    y = np.round(np.array([r.uniform(-10, 10) for _ in x]), 3)
    (tmp_path / 'map.csv').write_text('# measured\nplace [m], other, force [kN]\n'
                                      + ''.join(f'{a}; 7; {b}\n' for a, b in zip(x, y)))
    file, written = '"map.csv" column 3', ', '.join(f'{a} m: {b} kN' for a, b in zip(x, y))
    of_tables = ''.join(f'output {name}{i} = table(position of j, {table}{options}) / 1 kN\n'
                        for i, table in enumerate((file, written))
                        for name, options in (('held', ''), ('on', ', beyond linear'), ('curve', ', smooth'),
                                              ('curve_on', ', smooth, beyond linear')))
    scene = tmp_path / 'map.scene'
    scene.write_text(MOVES.format(of_tables))
    rows = plant(scene, real=real).outputs(1000)
    at = rows.x.astype(float)
    (held, on), (curve, curve_on) = lines(x, y, at), pchip(x, y, at) if len(x) > 2 else lines(x, y, at)
    steepest = np.abs(np.diff(y) / np.diff(x)).max() * 3
    for name, want in (('held', held), ('on', on), ('curve', curve), ('curve_on', curve_on)):
        for i in (0, 1):
            got = getattr(rows, f'{name}{i}').astype(float)
            np.testing.assert_allclose(got, want, atol=close(real, len(x)) * (1 + steepest), err_msg=f'{name}{i}')
    # Between two points a smooth table stays between them.
    assert curve.min() >= y.min() - 1e-9 and curve.max() <= y.max() + 1e-9


@pytest.mark.seeds(4)
@pytest.mark.parametrize('real', ['float', 'double'])
def test_of_two_numbers(plant, tmp_path, seed, real):
    r = random.Random(seed)
    x, y = numbers(r, r.randint(2, 6), -3, 3), numbers(r, r.randint(2, 6), -2, 2)
    z = np.round(np.array([[r.uniform(-10, 10) for _ in x] for _ in y]), 3)
    (tmp_path / 'map.csv').write_text('place [m], height [m], pull [kN]\n, ' + ', '.join(map(str, x)) + '\n'
                                      + ''.join(f'{b}, ' + ', '.join(map(str, row)) + '\n' for b, row in zip(y, z)))
    written = '; '.join(f'{b} m: ' + ', '.join(f'{c} kN' for c in row) for b, row in zip(y, z))
    written = f'; {", ".join(f"{a} m" for a in x)}; {written}'
    of_tables = ''.join(f'output {name}{i} = table(position of j, position of k{table}{options}) / 1 kN\n'
                        for i, table in enumerate((', "map.csv"', written))
                        for name, options in (('held', ''), ('on', ', beyond linear' if i == 0 else '; beyond linear')))
    scene = tmp_path / 'map.scene'
    scene.write_text(MOVES.format(of_tables))
    rows = plant(scene, real=real).outputs(1000)
    at, up = rows.x.astype(float), rows.y.astype(float)
    for name, goes_on in (('held', False), ('on', True)):
        want = bilinear(x, y, z, at, up, goes_on)
        for i in (0, 1):
            bound = close(real, len(x) * len(y)) * (1 + np.abs(want).max()) / min(np.diff(x).min(), np.diff(y).min())
            np.testing.assert_allclose(getattr(rows, f'{name}{i}').astype(float), want, atol=bound, err_msg=f'{name}{i}')


CURVE = MOVES.format('output f = table(position of j, -3 m: 1, -1 m: 4, 0.5 m: 3, 3 m: -2, smooth)')


def test_a_smooth_table_has_no_corner(plant):
    """Its second differences: a corner is one of the size of the slope times a step, 1e-2 of it, a curve of the square."""
    def roughness(scene):
        f = plant(scene).outputs(1000).f
        return np.abs(np.diff(f, 2))[220:780].max()  # between the ends
    assert roughness(CURVE) < 1e-3
    assert roughness(CURVE.replace(', smooth', '')) > 1e-2  # the control


def test_another_value_is_found(plant):
    """The control: a plant whose first stretch rises by more."""
    changed = plant(CURVE, change=lambda text: text.replace('iso_min(', 'R(1.001) * iso_min(', 1)).outputs(1000).f
    want = pchip(np.array([-3, -1, 0.5, 3]), np.array([1.0, 4, 3, -2]), np.linspace(-5, 5, 1001))[0]
    np.testing.assert_allclose(plant(CURVE).outputs(1000).f, want, atol=1e-9)
    assert np.abs(changed - want).max() > 1e-3


def test_beyond_error_ends_the_run(plant):
    """A force of no number: the guard holds the plant where it was."""
    scene = '''step 1 ms
body b { mass 1 kg }
joint j prismatic { parent ground; child b; axis x; start 0 m; speed 1 m/s }
effect pull { joint along; effort on along = table(position of along, 0 m: 1 N, 0.1 m: 1 N%s) }
effect e pull { along j }
output x = position of j
'''
    with pytest.raises(AssertionError, match='the guard ended it at tick 95'):  # t + t^2 / 2 = 0.1
        plant(scene % ', beyond error').outputs(400)
    for beyond in ('', ', beyond held', ', beyond linear'):  # the controls
        assert plant(scene % beyond).outputs(400).x[-1] > 0.4


@pytest.mark.parametrize('table, says', [
    ('table(x, 0: 1, 1: 2, beyond far)', 'expected held, linear or error'),
    ('table(3, 0: 1, 1: 2, beyond error)', 'the table is from 0 to 1, and this is 3'),
    ('table(x, 0: unsure, 1: 2, smooth)', 'the values of a smooth table are constants'),
    ('table(x, x; 0, 1; 0: 1, 2; 1: 3, 4; smooth)', 'a smooth table is of one quantity'),
    ('table(x, "none.csv")', "cannot read '"),
    ('table(x, "map.csv" column 1)', 'the number of a column, from 2 on'),
    ('table(x, "map.csv" column 4)', 'one for each column'),
    ('table(x, "map.csv")', 'map.csv:4:1: error: the places of a table must increase'),
    ('table(x, x, "map.csv")', 'the first line of a table of two numbers names both'),
    ('table(x, "word.csv")', 'word.csv:2:4: error: expected a number'),
    ('table(x, "unit.csv")', 'unit.csv:1:8: error: expected a unit'),
    ('table(x, "long.csv")', 'at most 1000 points')])
def test_refused(isoc, tmp_path, table, says):
    (tmp_path / 'map.csv').write_text('a, b\n1, 2\n2, 3\n2, 4\n')
    (tmp_path / 'word.csv').write_text('a, b\n1, two\n')
    (tmp_path / 'unit.csv').write_text('place [furlong], b\n1, 2\n')
    (tmp_path / 'long.csv').write_text(''.join(f'{i}, 1\n' for i in range(1001)))
    scene = tmp_path / 'bad.scene'
    scene.write_text(MOVES.format(f'tunable unsure = 2\nsignal x = position of j / 1 m\noutput z = {table}'))
    made = isoc(scene)
    assert made.refused and says in made.errors, made.errors
