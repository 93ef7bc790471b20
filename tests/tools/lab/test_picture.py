"""Pictures show what they are drawn of, read back through their labels; no text in them, nor in those of models/, is
cut off or lies on another one. A wrong label, a point that was moved or left out and a text beyond the edge are
found."""
import math
import re

import pytest

import reports
from harness.project import ROOT

GALLERY = ROOT / 'models/pictures'
# Files whose texts are those of graphviz, or of a still.
OTHERS = re.compile('class="graph"|class=\'still\'')


def report(least, *methods):
    """Rows of a report of these methods, over ranges that begin and end between powers of ten, or span less than two of
    them."""
    rows = []
    for k, kind in enumerate(('float', 'compensated', 'double'), 1):
        for m, method in enumerate(methods, 1):
            for i in range(5):
                error = 3 / (1 + m * 1.7 ** i) ** (3 if k == 3 else 1) + k * 1e-6 * i
                rows.append([kind, method, f'{0.004 / 2 ** i:.9g}', str(1250 * 2 ** i), f'{error:.3e}', '-',
                             str(100 + 31 * m),
                             f'{least * (1 + m / 3) * 2 ** i:.6g}', '-'])
    return [*rows, ['float', 'diverged', '0.004', '1250', 'inf', '-', '10', str(least), '-']]


def picture_of(rows):
    from lab.methods import known_methods
    from lab.picture.work_precision import work_precision
    return work_precision('NAME', 5, rows, known_methods())


@pytest.fixture(scope='module')
def rows():
    return report(48250, 'euler', 'rk4', 'abm4', 'abm4_pec', 'adams', 'unheard_of')


MANY = 'euler heun rk4 ab4 semi_implicit abm4 abm4_pec abm4_pecece bdf4 rosenbrock adams'.split()


@pytest.mark.parametrize('least, methods', [
    # Two methods that look alike would be found as one with the name of the other.
    (300, [*MANY, *(f'unheard_of_{i:02}' for i in range(1, 21))]),
    *((least, ['euler', 'rk4', 'abm4', 'abm4_pec', 'adams', 'unheard_of']) for least in (300, 1.9e4, 48250))])
def test_a_report_shows_its_table_and_its_fronts(shows, drawn, least, methods):
    rows = report(least, *methods)
    assert not shows(drawn(picture_of(rows)), (reports.points_of(rows), 'all'))


def looks(svg):
    """Of each mark of a method: where it is from above, and its colour."""
    marks = re.findall(r"<use [^>]*translate\([^,]*,([0-9.]+)\)[^>]* color='(#[0-9a-f]*)'", svg.read_text())
    return [(float(y), colour) for y, colour in marks]


def is_pale(svg, points):
    """Whether in the panels over the cost the points of the Pareto fronts have the looks of the panels over the step,
    and all others do not."""
    points = [row for row in points if 'instructions' in row[0]]
    fronts = sum(row[1] == 'Pareto front' for row in points)
    upper = [colour for y, colour in looks(svg) if y < 320]
    lower = {colour for y, colour in looks(svg) if 320 <= y < 610}
    best = sum(colour in lower for colour in upper)
    return fronts > 0 and best == fronts and len(upper) - best == len(points) - fronts


def test_points_off_the_fronts_are_pale(drawn, rows, monkeypatch):
    from lab.picture import looks as chosen
    points = list(reports.points_of(rows))
    assert is_pale(drawn(picture_of(rows)), points)
    monkeypatch.setattr(chosen, 'pale', lambda colour: colour)
    assert not is_pale(drawn(picture_of(rows)), points), 'found: points off the front that are as dark'


def test_texts_of_a_report(drawn, rows):
    text = drawn(picture_of(rows)).read_text()
    for said in 'euler, 4 ms', 'Pareto front', 'unheard_of':
        assert f'>{said}<' in text


def test_nothing_is_drawn_where_no_method_errs(rows):
    assert picture_of([[*row[:4], '0.000e+00', *row[5:]] for row in rows]) is None


@pytest.fixture
def drift():
    """A picture of drift, and its points."""
    from lab.picture.curves import violation
    none = [(f'{3 * i}', f'{2.2e-5 * 1.2 ** i:.6g}') for i in range(1, 51)]
    projection = [(f'{3 * i}', f'{3e-8 * (2 + math.sin(i)):.6g}') for i in range(1, 51)]
    points = [('|t, s', name, *row) for name, rows in (('none', none), ('projection', projection)) for row in rows]
    points += [('|t, s', 'projection', at, '1.0151e-06') for at in (0, 150)]
    return violation('NAME', {'none': (none, 'inf'), 'projection': (projection, '1.0151e-06')}), points


def test_a_picture_of_drift(shows, drawn, drift):
    picture, points = drift
    assert not shows(drawn(picture), (points, 'all'))


@pytest.mark.parametrize('file', sorted(GALLERY.glob('*.svg')), ids=lambda file: file.stem)
def test_texts_of_the_gallery(shows, file):
    if not OTHERS.search(file.read_text()):
        assert not shows(file)


def errors_of_bench():
    """The errors in core/methods.md, of the double pendulum, as points of its work-precision picture."""
    table = re.search(r'^\| method .* error, 2 ms .*\n\|.*\n((\|.*\n)*)', (ROOT / 'core/methods.md').read_text(), re.M)
    for line in table[1].splitlines():
        method, _, _, two, one = [cell.strip() for cell in line.strip('|').split('|')][:5]
        if two != '-':
            yield 'double|step, ms', method, 2, two
            yield 'double|step, ms', method, 1, one


def test_errors_of_the_gallery(shows):
    points = list(errors_of_bench())
    svg = GALLERY / 'double_pendulum_work_precision.svg'
    assert len(points) >= 20 and not shows(svg, (points, 'covered'))
    panel, method, at, error = points[2]
    points[2] = panel, method, at, f'{1.02 * float(error):.3e}'
    assert shows(svg, (points, 'covered')), 'found: an error that is not in the picture'


def test_bounds_of_the_gallery(shows):
    rows = re.findall(r'^\| ([a-z]+) \| [\d.]+ \| \S+ \| ([\d.e-]+) \|', (ROOT / 'models/drift.md').read_text(), re.M)
    points = [('|t, s', name, at, bound) for name, bound in rows for at in (0, 600)]
    assert len(points) == 6 and not shows(GALLERY / 'four_bar_violation.svg', (points, 'covered'))


def first(pattern, by):
    return lambda text: re.sub(pattern, by, text, count=1, flags=re.M)


def without_third_circle(svg):
    lines, seen = [], 0
    for line in svg.splitlines():
        seen += bool(re.match('<use.*gpPt6', line))
        if not (re.match('<use.*gpPt6', line) and seen == 3):
            lines.append(line)
    return '\n'.join(lines) + '\n'


@pytest.mark.parametrize('change', [
    first('>-2</', '>-3</'), first(r'(<use.*translate\()([0-9.]+)', lambda m: f'{m[1]}{float(m[2]) + 0.2:.6g}'),
    without_third_circle, lambda svg: svg.replace('>rk4<', '>rk5<')],
    ids=['a wrong label', 'a point moved by a fifth of a pixel', 'a point that is not drawn',
         'a wrong name in the legend'])
def test_what_is_wrong_in_a_drawing_is_found(shows, drawn, rows, change):
    svg = drawn(picture_of(rows))
    text = svg.read_text()
    assert change(text) != text
    svg.write_text(change(text))
    assert shows(svg, (reports.points_of(rows), 'all'))


def test_wrong_points_are_found(shows, drawn, rows):
    svg, points = drawn(picture_of(rows)), list(reports.points_of(rows))
    assert shows(svg, (points[:2] + points[3:], 'all')), 'a point that is not in the table'
    # Gnuplot's own tics of a logarithmic axis, labelled as the decade below.
    text = re.sub(r"^set xtics.*10\^.*", "set xtics 10\nset format x '10^{%T}'", picture_of(rows).text(), flags=re.M)
    assert shows(drawn(text), (points, 'all')), 'an axis labelled as the decade below'


@pytest.mark.parametrize('label, is_wrong', [
    ("'so far to the right' at screen 0.95, 0.9", True), ("'here' at graph 0.5, 1.05", True),
                                             ("'there' at screen 0.075, 0.9", False)])
def test_texts_beyond_the_edge_and_on_others(shows, drawn, drift, label, is_wrong):
    text = re.sub('^set xlabel.*', lambda line: f'{line[0]}\nset label {label}', drift[0].text(), flags=re.M)
    assert bool(shows(drawn(text))) == is_wrong
