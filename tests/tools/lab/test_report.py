"""isochron report and bench: the tables are whole, errors fall with the methods' orders, what runs with any step or
tolerance is what isochron run runs, a reference that two methods do not agree on is refused. Wrong references and
tables are seen."""
import math
import re
import subprocess
import types

import pytest

import cells
import reports
from harness.project import ROOT

METHODS = 'euler heun rk4 rosenbrock adams'.split()
PENDULUM = ROOT / 'models/double_pendulum.scene'


def rows_of(folder, name):
    return [line.split('\t') for line in (folder / f'{name}.tsv').read_text().splitlines()][1:]


made = {}


@pytest.fixture
def report(laboratory, isochron):
    """report(scene, ...): a report, made once: its folder, what it printed and said, and its rows."""
    def call(scene, *words, **environment):
        key = scene, words
        if key not in made:
            done = isochron('report', scene, *words, **environment)
            assert done.status == 0, done.errors[-2000:]
            folder = laboratory / 'build/report' / (scene.stem if ROOT / 'models' in scene.parents else
                                                    re.search(r'build/report/(.*)/report.html', done.printed)[1])
            made[key] = types.SimpleNamespace(folder=folder, printed=done.printed, errors=done.errors,
                                              rows=rows_of(folder, 'report'))
        return made[key]
    return call


@pytest.fixture
def pendulum(report):
    """One target is as good as several."""
    return report(PENDULUM, '--methods', ' '.join(METHODS), TICK_TARGETS='cortex-m4f')


@pytest.fixture
def of_methods(laboratory):
    from lab.methods import known_methods
    return {method: row[0] for method, row in known_methods().items()}


def driven(folder, program, *words, **environment):
    """The steps and the states of what a program of a report prints."""
    done = subprocess.run([folder / program / 'drive', *map(str, words)], capture_output=True, text=True,
                          env=environment)
    assert done.returncode == 0, done.stderr
    return [(line.split()[0], list(map(float, line.split()[2:]))) for line in done.stdout.splitlines()]


# --- The table ---

def is_whole(rows):
    """A line for each kind, method and step, each with an error above zero, and instructions per second that are those
    of a step over the step; compensated sums take more of them than plain ones."""
    costs = {(kind, method): int(cost) for kind, method, _, _, _, _, cost, _, _ in rows}
    keys = [(kind, method) for kind in ('float', 'compensated', 'double') for method in METHODS]
    return (sorted((row[0], row[1]) for row in rows) == sorted(keys * 6)
            and all(float(row[4]) > 0 and abs(float(row[7]) * float(row[2]) / int(row[6]) - 1) < 0.001 for row in rows)
            and all(costs['compensated', method] > costs['float', method] for method in METHODS))


def is_ordered(rows, of_methods):
    """In double the last two orders observed of every method are those of isoc's table, within 0.1. The error is C h^p
    (1 + D h): an observed order is p + D h / (2 ln 2), with D at most 200 / s (euler, from its orders 1.24 at 2 ms to
    1.03 at 0.125 ms) at most 0.07 off at 0.25 ms. All lie a hundred times above what the reference is sure of, or are
    not told."""
    for method in METHODS[:-1]:
        told = [float(row[5]) for row in rows if row[:2] == ['double', method] and row[5] != '-']
        if len(told) < 2 or any(abs(order - float(of_methods[method])) > 0.1 for order in told[-2:]):
            return False
    return True


def is_adapted(rows):
    """With every smaller tolerance adams makes more steps, and in double its error falls with tolerance^(4/5), but for
    the scatter that tests/core/methods/adams derives: steps are powers of two, an error of order four is within 2^5."""
    for kind in 'float', 'compensated', 'double':
        its = [row for row in rows if row[:2] == [kind, 'adams']]
        if len(its) != 6 or any(int(a[3]) >= int(b[3]) or float(a[8]) <= float(b[8]) for a, b in zip(its, its[1:])):
            return False
    tolerances = math.log(float(its[0][8]) / float(its[-1][8]))
    return abs(math.log(float(its[0][4]) / float(its[-1][4])) / tolerances - 4 / 5) <= 5 * math.log(2) / tolerances


def test_the_table(pendulum, of_methods):
    assert is_whole(pendulum.rows) and is_ordered(pendulum.rows, of_methods) and is_adapted(pendulum.rows)


def changed(rows, which, column, value):
    return [[*row[:column], value, *row[column + 1:]] if which(row) else row for row in rows]


@pytest.mark.parametrize('change', [
    lambda rows: rows[:18] + rows[19:], lambda rows: [row for row in rows if row[1] != 'heun'],
    lambda rows: changed(rows, lambda row: row[0] == 'double' and row[8] == '1e-13', 4, '1e-7'),
    lambda rows: changed(rows, lambda row: row[0] == 'float' and row[8] == '1e-5', 8, '1e-3')],
    ids=['a row left out', 'a method left out', 'an error of adams that does not fall', 'a tolerance in a wrong place'])
def test_found_a_wrong_table(pendulum, of_methods, change):
    rows = change(pendulum.rows)
    assert not (is_whole(rows) and is_ordered(rows, of_methods) and is_adapted(rows))


def test_found_a_wrong_order_or_a_wrong_reference(pendulum, of_methods):
    from lab.methods import errors
    assert not is_ordered(pendulum.rows, {**of_methods, 'rk4': '3'})
    counts = [1250 * 2 ** i for i in range(6)]
    lines = subprocess.run([pendulum.folder / 'double-rk4/drive', '5', *map(str, counts)], capture_output=True,
                           text=True).stdout
    measured = [('double', 'rk4', '100', '-', line.split()) for line in lines.splitlines()]
    exact = driven(pendulum.folder, 'reference-rk4', 5, 80000)[0][1]
    right, wrong = ([row[5] for row in errors({'5': ('1e-13', state)}, measured)]
                    for state in (exact, [exact[0] + 1e-8, *exact[1:]]))
    assert abs(float(right[3]) - 4) < 0.1 and abs(float(wrong[3]) - 4) > 0.1
    with pytest.raises(KeyError):
        errors({'9': ('1e-13', exact)}, measured)


def test_two_states_agree(laboratory):
    from lab.methods import agree
    assert agree([1, 2], [1.000000000001, 2], 1e-12)
    assert not agree([1, 2], [1.00000000001, 2], 1e-12)
    assert not agree([1, math.nan], [1, math.nan], 1e-12) and not agree([math.inf], [math.inf], 1e-12)


# --- What is printed, and the page ---

def test_progress_and_files(pendulum):
    assert sorted(map(int, re.findall(r'^report: (\d+) of 15: \w+ in \w+$', pendulum.errors, re.M))) == list(range(1,
                                                                                                                   16))
    for name in 'report.html', 'report.txt', 'report.tsv', 'work_precision.svg', 'work_precision.png':
        assert f'\nbuild/report/double_pendulum/{name}\n' in pendulum.printed
        assert (pendulum.folder / name).stat().st_size
    assert pendulum.printed.startswith((pendulum.folder / 'report.txt').read_text())
    kept = list((pendulum.folder.parent / 'references').iterdir())
    assert any(len(file.read_text().splitlines()) > 1 for file in kept), 'references are kept'


def test_a_warning_of_many_kinds_is_told_once(laboratory, capfd):
    from lab.methods import Subject
    import threading
    subject = types.SimpleNamespace(scene='models/a.scene', told=set(), lock=threading.Lock())
    for kind in 'one', 'two':
        for word in 'first', 'second', 'first':
            Subject.tell(subject, f'DIR/{kind}/a.scene:3:1: warning: {word}\n    text\n    ^\n', f'DIR/{kind}/a.scene')
    assert capfd.readouterr().err == ''.join(f'models/a.scene:3:1: warning: {word}\n    text\n    ^\n'
                                             for word in ('first', 'second'))


def test_every_number_of_the_page_is_a_cell(pendulum):
    page = (pendulum.folder / 'report.html').read_text()
    assert not cells.faults(page, pendulum.folder)
    for part in 'report cycles growth local_error account tick regions'.split():
        assert f"<table data-file='{part}.tsv'>" in page and f"data-cell='{part}.tsv:" in page
    assert page.count('srcdoc="<!doctype html>') == 1 and page.count('src="data:image/svg+xml;base64') == 6
    assert len(re.findall('no error is below .*[0-9]</data> instructions per second', page)) == 3
    assert len(re.findall('the cheapest is .*[0-9]</data> cycles per second', page)) == 2


def test_found_a_wrong_page(pendulum, tmp_path):
    page = (pendulum.folder / 'report.html').read_text()
    for pattern, by in (r"(data-cell='tick[^>]*>)[0-9.]*", r'\g<1>1234'), ('(<h2>The dearest tick)',
                                                                           r'<p>It takes 12 us.</p>\1'):
        wrong = re.sub(pattern, by, page, count=1)
        assert wrong != page and cells.faults(wrong, pendulum.folder)
    for file in pendulum.folder.glob('*.tsv'):
        (tmp_path / file.name).write_text(file.read_text().replace('e-0', 'e-1') if file.name == 'growth.tsv'
                                          else file.read_text())
    assert cells.faults(page, tmp_path), 'a table that is not that of the page'


# --- The parts of the page ---

def is_estimated(rows):
    """The error of a step of rk4 is told within the factor of tests/core/methods/estimate."""
    return len(rows) >= 60 and all(0.2 <= float(told) / float(error) <= 5 for _, told, error, *_ in rows)


def test_pictures_show_their_tables(pendulum, shows):
    folder = pendulum.folder
    growth = [('|t, s', row[0], row[3], row[4]) for row in rows_of(folder, 'growth') if float(row[4]) > 0]
    assert not shows(folder / 'growth.svg', (growth, 'all'))
    regions = [('|real part of the eigenvalue times the step', *row[:3]) for row in rows_of(folder, 'regions')]
    assert not shows(folder / 'regions.svg', (regions, 'drawn'))
    errors = rows_of(folder, 'local_error')
    assert not shows(folder / 'local_error.svg', ([('|t, s', name, row[0], row[c]) for row in errors
                                                   for c, name in ((1, 'told'), (2, 'true'))], 'all'))
    assert is_estimated(errors) and not is_estimated(changed(errors, lambda row: row is errors[30], 1,
                                                             str(30 * float(errors[30][1]))))
    drawing = (folder / 'work_precision.svg').read_text()
    assert len(drawing) < 100000 and not shows(folder / 'work_precision.svg', (reports.points_of(pendulum.rows), 'all'))
    for text in *METHODS, 'double_pendulum: error over cost', 'float, compensated sums', 'step, ms':
        assert text in drawing


def test_each_step_has_its_cycles(pendulum, shows):
    """Once to four times its instructions."""
    instructions = {('cycles_' + row[0], *row[1:3]): int(row[6]) for row in pendulum.rows if row[1] != 'adams'}
    rows = rows_of(pendulum.folder, 'cycles')
    assert len(rows) == 48
    assert all(instructions[tuple(row[:3])] <= float(row[6]) < 4 * instructions[tuple(row[:3])] for row in rows)
    assert not shows(pendulum.folder / 'cycles.svg', (reports.points_of(rows), 'all'))


def test_growth_and_regions(pendulum, of_methods):
    at_step = {row[0]: row[4] for row in pendulum.rows if row[1] == 'rk4' and 0.00099 < float(row[2]) < 0.00101}
    assert {row[0]: row[4] for row in rows_of(pendulum.folder,
                                              'growth')} == at_step, 'the end of the growth is the error of the table'
    regions = rows_of(pendulum.folder, 'regions')
    edge = {method: min(float(row[1]) for row in regions if row[0] == method and abs(float(row[2])) < 1e-3)
            for method in ('rk4', 'ab4')}
    assert abs(edge['rk4'] + 2.785) < 1e-3 and abs(edge['ab4'] + 0.3) < 1e-4
    assert {row[0] for row in regions} - {'eigenvalue'} == set(of_methods)


@pytest.mark.parametrize('row, said', [
    (('5000', '0', '-', '-'), "Of <data value='5000'.*<data value='0'"),
    (('5000', '12', '0.5', 'follower_pin'), "<data value='12' .*<data value='5000' .*<data value='0.5' "
                                            ".*<b>follower_pin</b>")])
def test_ticks_near_a_singular_position(laboratory, tmp_path, row, said):
    from lab import table
    from lab.page import page
    table.write(tmp_path / 'nearness.tsv', [('ticks', 'near', 'first_s', 'closure'), row])
    text = page(tmp_path, 'four_bar', '', False)
    assert re.search(said, text) and not cells.faults(text, tmp_path)


def test_a_parallelogram_that_is_stretched(report, shows):
    """Within a second: the least pivot there, and the violation that its account has."""
    of = report(ROOT / 'models/parallelogram.scene', '--methods', 'rk4', '--seconds', '1',
                REPORT_PARTS='account nearness').folder
    account = {row[0]: row for row in rows_of(of, 'account')}
    rows = [list(map(float, row)) for row in rows_of(of, 'singular')]
    least = min(rows, key=lambda row: row[1])
    assert len(rows) >= 300 and least[1] < 1e-4 and 0.55 < least[0] < 0.65 and max(row[2] for row in rows) > 10
    assert max(row[3] for row in rows) == float(account['violation'][5]) > 0
    assert not shows(of / 'singular.svg') and not cells.faults((of / 'report.html').read_text(), of)


# --- The programs are those of isochron run ---

def is_state(said, state, unit):
    """A number of a summary is the shortest decimal that reads back: within half a unit in the last place."""
    printed = list(map(float, said['state'].split()))
    return len(printed) == len(state) == 4 and all(abs(a - b) <= unit / 2 * abs(b) for a, b in zip(printed, state))


@pytest.mark.parametrize('real, unit', [('double', 2.3e-16), ('float', 1.2e-7)])
def test_any_step_is_that_of_a_run(pendulum, isochron, real, unit):
    said = isochron('run', PENDULUM, '--real', real, '--seconds', '5').said
    assert is_state(said, driven(pendulum.folder, f'{real}-rk4', 5, 5000)[0][1], unit)


def test_any_tolerance_is_that_of_a_run(pendulum, isochron):
    said = isochron('run', PENDULUM, '--target', 'cortex-m4f', '--method', 'adams', '--step', '40ms', '--tolerance',
                    '1e-6', '--seconds',
                    '5').said
    (steps, state), = driven(pendulum.folder, 'float-adams', 5, '1e-6')
    assert steps == said['substeps'] and is_state(said, state, 1.2e-7)
    row, = (row for row in pendulum.rows if row[:2] == ['float', 'adams'] and row[8] == '1e-6')
    assert abs(float(row[7]) * 5 / (float(said['execution'].split()[1]) * int(said['ticks'])) - 1) < 0.001


@pytest.mark.parametrize('words', [('--step', '4ms', '--seconds', '0.1'), ('--step', '125us', '--seconds', '0.05')])
def test_instructions_do_not_depend_on_the_step(pendulum, isochron, words):
    said = isochron('run', PENDULUM, '--target', 'cortex-m4f', '--method', 'heun', *words).said
    assert {row[6] for row in pendulum.rows if row[:2] == ['float', 'heun']} == {said['instructions_per_step']}


# --- Other scenes ---

@pytest.mark.parametrize('words, told', [
    ((PENDULUM, '--methods', 'rk4', '--seconds', '40', '--step', '8ms'), 'no reference for double_pendulum after 40 s'),
    (('absent.scene',), 'there is no scene absent.scene'),
    ((ROOT / 'models/oscillator.c', '--methods', 'adams'), 'adams cannot be built')])
def test_refused(isochron, words, told):
    done = isochron('report', *words)
    assert done.status == 1 and told in done.errors and 'Traceback' not in done.errors


def test_a_plant_in_c(report):
    rows = report(ROOT / 'models/oscillator.c', '--methods', 'bdf4', '--step', '2ms', '--seconds', '2').rows
    assert len(rows) == 18 and all(float(row[4]) > 0 for row in rows)


RESTING = '''step 1 ms
input push = table(0 s: 0 N, 0.1 s: 3 N, 1 s: 2 N)
body cart { mass 1 kg; com (0, 0, 0) m }
joint rail prismatic { parent ground; child cart; axis x; drive push; spring 40 N/m }
include "rub.scene"
output place = position of rail
'''


def test_a_scene_that_rests(report, isoc, tmp_path):
    """At rest while its input is 0, and with dry friction, whose creep would be another for each method."""
    (tmp_path / 'resting.scene').write_text(RESTING)
    (tmp_path / 'rub.scene').write_text('effect rub friction { along rail; sliding 0.5 N; static 1 N }\n')
    of = report(tmp_path / 'resting.scene', '--methods', 'rk4', '--seconds', '0.2', REPORT_PARTS='')
    assert 'each keeps the largest value of its function' in (of.folder / 'report.txt').read_text()
    assert 'largest value of its function' in (of.folder / 'report.html').read_text()
    assert len(of.rows) == 18 and all(float(row[4]) > 0 for row in of.rows)
    # The equations are the same for all methods: the creep is written.
    assert 'rub friction { creep ' in (of.folder / 'double/resting.scene').read_text()
    said = isoc(of.folder / 'double/resting.scene', '--method', 'rk4')
    assert said.status == 0 and 'stable' not in said.printed


def test_a_loop(report, tmp_path):
    """The last order observed of each method and reading, to the nearest number; a history makes it one where inputs
    are held."""
    of = report(ROOT / 'models/cart_pole.scene', '--methods', 'rk4 ab4', '--seconds', '1', REPORT_PARTS='').folder
    orders = {(row[0], row[1]): round(float(row[5])) for row in rows_of(of, 'loop') if row[5] != '-'}
    assert orders == {('held', 'ab4'): 1, ('held', 'rk4'): 4, ('smooth', 'ab4'): 4, ('smooth', 'rk4'): 4}
    assert (of / 'loop.svg').exists()
    # Recorded inputs: those at the start are those of no loop; what is no record is refused.
    recorded, frozen = tmp_path / 'recorded', driven(of, 'double-rk4', 1, 1000)
    recorded.write_text('0\n0,\n')
    assert driven(of, 'double-rk4', 'held', 1, 1000, RECORDED=str(recorded)) == frozen
    recorded.write_text('0.5\n-0.5\n')
    assert driven(of, 'double-rk4', 'held', 1, 1000, RECORDED=str(recorded)) != frozen
    recorded.write_text('force 1\n')
    with pytest.raises(AssertionError, match='0 numbers are no lines of 1 inputs'):
        driven(of, 'double-rk4', 'held', 1, 1000, RECORDED=str(recorded))


# --- bench ---

def test_the_largest_step_of_bench_is_the_largest(laboratory, isochron):
    from lab.bench import SAID
    done = isochron('bench', PENDULUM, '--methods', 'rk4 ab4 adams')
    table = {row[0]: row for row in done.rows}
    assert len(re.findall(r'^- \w+.*: (?:yes|no)\.$', done.printed,
                          re.M)) == 1 and f'The fewest instructions for an error of {SAID}: ' in done.printed
    folder = laboratory / 'build/bench/double_pendulum'
    exact = driven(folder, 'reference-rk4', 5, 80000)[0][1]

    def error(method, number):
        return float(f"{math.dist(driven(folder, f'double-{method}', 5, number)[0][1], exact):.3e}") # as in the table

    for method in 'rk4', 'ab4':
        # The table has three digits of the step.
        steps = 5000 / float(table[method][5])
        few, enough = int(steps * 0.995), math.ceil(steps * 1.005)
        fewest = 1 + max(n for n in range(few, enough + 1) if error(method, n) > 1e-6)
        assert f'{5000 / fewest:.3g}' == table[method][5]
    assert table['adams'][1] == '1 to 4' and 2 <= float(table['adams'][2]) < 3 and table['adams'][3:5] == ['-', '-']


def test_what_is_missing_is_named(isochron, tmp_path):
    for command, tool, package in (('report', 'gnuplot', 'gnuplot-nox'), ('report', 'valgrind', 'valgrind'),
                                   ('bench', 'arm-none-eabi-gcc', 'gcc-arm-none-eabi'),
                                   ('bench', 'qemu-system-arm', 'qemu-system-arm')):
        links = tmp_path / tool
        links.mkdir()
        for path in (path for folder in ('/usr/bin', '/bin') for path in type(tmp_path)(folder).iterdir()):
            if path.name != tool and not (links / path.name).is_symlink():
                (links / path.name).symlink_to(path)
        done = isochron(command, PENDULUM, '--methods', 'rk4', PATH=str(links))
        assert done.status == 1 and re.search(f'{tool} is missing.*apt-get install .*{package}', done.errors)
