"""isochron plot: a panel for every output, with the unit that isoc gives it, in svg and in png, for the models; the
pictures, read back through their labels, show the rows of the trace, and nothing fast is lost when the points are made
fewer."""
import csv
import pathlib
import re

import pytest

from harness.project import ROOT

SCENES = sorted(ROOT.glob('models/*.scene')) + [ROOT / 'models/oscillator.c', ROOT / 'tests/isoc/scene/units.scene']


def cells(path):
    with open(path) as file:
        return list(csv.reader(file))


def trace_points(folder):
    """All that its trace.svg may show, every row of the trace by panel and curve; and of each curve the least and the
    greatest."""
    (_, units), (names, *rows) = cells(folder / 'units.csv'), cells(folder / 'trace.csv')
    points, extremes = [], []
    for column, name in enumerate(names[1:], 1):
        stem = name[:-2]
        is_vector = all(f'{stem}_{letter}' in names for letter in 'xyz')
        unit = '' if units[column] in ('', '1') else f', {units[column]}'
        panel, curve = f'{stem if is_vector else name}{unit}|t, s', name[-1] if is_vector else ''
        its = [(panel, curve, row[0], row[column]) for row in rows]
        points += its
        extremes += [choose(its, key=lambda row: float(row[3])) for choose in (min, max)]
    return points, extremes


def is_true(shows, folder):
    points, extremes = trace_points(folder)
    return not shows(folder / 'trace.svg', (points, 'drawn'), (extremes, 'covered'))


@pytest.fixture
def plotted(laboratory):
    """plotted(scene, ...): the folder of a run of a second, with what is drawn of it. Without optimisation a run has
    the same bits, and is compiled sooner."""
    from lab import build, plot

    def call(scene, seconds='1', outputs='', script=None):
        run = build.plant(scene, folder=pathlib.Path('plot', scene.stem), flags='-O0').run(seconds, script)
        plot.drawn(run.folder, outputs.split(',') if outputs else (), png=False)
        return run.folder
    return call


@pytest.mark.parametrize('scene', SCENES, ids=lambda scene: scene.stem)
def test_a_panel_for_every_output(plotted, shows, scene):
    # A second; of the squeezer, which has a hundred thousand rows in that, a tenth of it.
    folder = plotted(scene, '0.1' if scene.stem == 'squeezer' else '1')
    assert is_true(shows, folder)
    if (folder / 'path.svg').exists():
        assert not shows(folder / 'path.svg')
    assert not (folder / 'histogram.svg').exists()


def test_the_path_and_the_change_of_the_energy(plotted, shows):
    folder = plotted(ROOT / 'models/double_pendulum.scene')
    names, *rows = cells(folder / 'trace.csv')
    x, y, energy = map(names.index, ('tip_x', 'tip_y', 'energy'))
    start = float(rows[0][energy])
    points = [row for cell in rows for row in (('double_pendulum: rk4, step 1 ms, float|tip_x, m', '', cell[x],
                                                cell[y]),
                                               ('|t, s', '', cell[0], float(cell[energy]) - start))]
    assert not shows(folder / 'path.svg', (points, 'drawn'))


def test_the_histogram(plotted, shows, tmp_path):
    """Of a scene that asks for it, 40 of whose ticks a script makes long: the bins follow from the script."""
    scene, script = tmp_path / 'timed.scene', tmp_path / 'script'
    scene.write_text((ROOT / 'models/pendulum.scene').read_text() + 'histogram\n')
    script.write_text(''.join(f'slow {20 * i} {i * i}us\n' for i in range(1, 41)))
    ticks = {0: 960}
    for i in range(1, 41):
        bin = min(31, i * i * 1000 // 31250)
        ticks[bin] = ticks.get(bin, 0) + 1
    points = [('|execution of a step, us, to the end of the period; the last bin is open', '', (bin + k) * 31.25, count)
              for bin, count in ticks.items() for k in (0, 1)]
    folder = plotted(scene, script=script)
    assert not shows(folder / 'histogram.svg', (points, 'all'))
    points[2] = (*points[2][:3], points[2][3] + 1)
    assert shows(folder / 'histogram.svg', (points, 'all')), 'found: another height'


def texts(svg):
    return [re.sub('<[^>]*>', '', text) for text in re.findall('<text>.*</text>', svg.read_text())]


def test_outputs(plotted, shows, isochron):
    tree = ROOT / 'models/tree.scene'
    folder = plotted(tree)
    assert {'tree: rk4, step 0.5 ms, float', 'rail_position, m', 'rotor_turns', 'needle_rate, rad/s',
            'hinge_acceleration, rad/s^2'} <= set(texts(folder / 'trace.svg'))
    drawing = (folder / 'trace.svg').read_text()
    for pattern, by in ('needle_rate, rad', 'needle_rate, m'), ('>y<', '>z<'), (r'>0\.4<', '>0.5<'):
        (folder / 'trace.svg').write_text(re.sub(pattern, by, drawing))
        assert not is_true(shows, folder), f'found: {by} in place of {pattern}'
    plotted(tree, outputs='rail_position,needle_rate')
    said = texts(folder / 'trace.svg')
    assert {'rail_position, m', 'needle_rate, rad/s'} <= set(said) and not any(text.startswith('hinge')
                                                                               for text in said)
    done = isochron('plot', tree, '--seconds', '0.01', '--outputs', 'rail_position,needle_rate')
    assert done.status == 0 and 'warning' not in done.errors
    assert [pathlib.Path(path).suffix for path in done.printed.split()] == ['.svg', '.png'] * 2
    done = isochron('plot', tree, '--seconds', '0.01', '--outputs', 'rail_position,rail')
    assert done.status == 1 and "plot: no output is called 'rail'" in done.errors


UNITS = '''t s
position_of_a_slide m
position_of_a_hinge rad
point_x m
point_y m
point_z m
point_along m
speed_of_a_slide m/s
speed_of_a_hinge rad/s
acceleration_of_a_slide m/s^2
acceleration_of_a_hinge rad/s^2
velocity_x m/s
velocity_y m/s
velocity_z m/s
turns 1
orientation_w 1
orientation_x 1
orientation_y 1
orientation_z 1
spin_x rad/s
spin_y rad/s
spin_z rad/s
x_axis_x 1
x_axis_y 1
x_axis_z 1
y_axis 1
z_axis 1
specific_force_x m/s^2
specific_force_y m/s^2
specific_force_z m/s^2
inertia kg*m^2
force_x N
force_y N
force_z N
force_along N
moment_x N*m
moment_y N*m
moment_z N*m
effort_of_a_gear_on_a_slide N
effort_of_a_gear_on_a_hinge N*m
effort_of_a_motion_of_a_hinge N*m
effort_of_a_motion_of_a_slide N
energy J
event_loss J
power W
balance W
local_error mixed
residual mixed
violation m or rad
violation_rate m/s or rad/s
violation_acceleration m/s^2 or rad/s^2'''


def test_every_kind_of_output_has_its_unit(plotted):
    scene = ROOT / 'tests/isoc/scene/units.scene'
    rows = (ROOT / 'tools/isoc/scene/quantities.h').read_text().splitlines()
    kinds = {found[1] for line in rows if 'OF_EFFECT' not in line
             if (found := re.search(r'ROW\(QUANTITY_[A-Z_]*, "([a-z_]+)"', line))}
    assert kinds == set(re.findall(r'^output [a-z_]* = ([a-z_]*)', scene.read_text(),
                                   re.M)), 'units.scene has every kind'
    folder = plotted(scene, '0.01')
    names, units = cells(folder / 'units.csv')
    assert [f'{name} {unit}' for name, unit in zip(names, units)] == UNITS.splitlines()
    folder = plotted(ROOT / 'models/oscillator.c', '0.01')
    assert cells(folder / 'units.csv') == [['t', 'position', 'speed', 'energy'], ['s', 'm', 'm/s', 'J']]
    assert not (folder / 'path.svg').exists(), 'no path without a point'


def test_a_spike_in_one_row_of_many_is_drawn(laboratory, tmp_path):
    from lab import trace
    from lab.picture.run import trace as picture
    (tmp_path / 'summary.txt').write_text('scene spike\nmethod rk4\nstep 0.001\nreal float\n')
    (tmp_path / 'units.csv').write_text('t,a\ns,\n')
    (tmp_path / 'trace.csv').write_text('t,a\n' + ''.join(f'{i / 1000},{7.25 if i == 4567 else 0}\n'
                                                          for i in range(1, 10001)))
    lines = picture(trace.Run(tmp_path)).text().splitlines()
    assert '4.567 7.25' in lines and sum(bool(re.fullmatch('[0-9.]+ [-0-9.]+', line)) for line in lines) < 1000


def test_without_gnuplot(isochron, tmp_path):
    for tool in 'cc gcc as ld make sh awk sed tr cut mkdir cat cmp grep dirname uname python3'.split():
        for folder in '/usr/bin', '/bin':
            if (pathlib.Path(folder) / tool).exists() and not (tmp_path / tool).is_symlink():
                (tmp_path / tool).symlink_to(pathlib.Path(folder) / tool)
    done = isochron('plot', ROOT / 'models/pendulum.scene', PATH=str(tmp_path))
    assert done.status == 1 and 'gnuplot is missing. Install it with: apt-get install gnuplot-nox' in done.errors
