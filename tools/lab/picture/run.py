"""Pictures of a run, or of two: all outputs, the path of a point, execution times, one run over the other."""
import math

from lab.build import Wrong
from lab.draw import COLOURS, Picture, quoted

WIDTH, HEAD, PANEL, GAP, FOOT = 900, 60, 118, 34, 36 # in pixels: above, of, between and below the panels
CURVES = 300 # stretches of a curve
LAST_BITS = 2 ** -20 # of a float, as a part of it


class Panels(Picture):
    """Panels over time, one above the other."""

    def __init__(self, count):
        super().__init__(WIDTH, HEAD + PANEL * count + FOOT)
        self.count = count
        self.put('set multiplot')

    def put_signals(self, i, head, least, most):
        """Panel i from above, with this text and range, of the curves that were added."""
        top = HEAD + PANEL * i
        self.put_range('y', least, most)
        self.put_place(0.09, 0.975, 1 - top / self.height, 1 - (top + PANEL - GAP) / self.height)
        self.put_head(head)
        self.put_time(i == self.count - 1)
        self.put_curves()


def trace(run, outputs=()):
    """All outputs of a run over time, or those of these names, a panel for each group."""
    groups = run.groups
    if outputs:
        called = {group.stem: group for group in groups}
        for name in outputs:
            if name not in called:
                raise Wrong(f"plot: no output is called '{name}'")
        groups = [called[name] for name in outputs]
    p = Panels(len(groups))
    p.put(f"set label 2 {quoted(run.title())} noenhanced at screen 0.09, {1 - 22 / p.height:.5f} left font ',14'",
          f'set xrange [0:{run.most[0]:.9g}]')
    for i, group in enumerate(groups):
        first = group.columns[0]
        p.put('set key on at graph 1, 1.02 right bottom horizontal samplen 1.5' if len(group.columns) > 1
              else 'set key off')
        for column, colour, letter in zip(group.columns, COLOURS,
                                          'wxyz'[-len(group.columns) if len(group.columns) > 1 else 1:]):
            p.curve(run.curve(column, CURVES), f"with lines linewidth 1.2 linecolor rgb '{colour}'", letter)
        least, most = min(run.least[c] for c in group.columns), max(run.most[c] for c in group.columns)
        if run.said('real') == 'float' and most - least <= LAST_BITS * max(-least, most):
            most = least # a constant: what it is rounded to would be all that the panel shows
        p.put_signals(i, run.label(first, group.stem), least, most)
        p.put('unset label 2')
    p.put('unset multiplot')
    return p


def path(run):
    """The way of the first point that is shown, in the plane in which it moves most: a square panel, and on its right
    one with the change of the energy, if there is one."""
    left, side, top = 80, 300, 56 # in pixels
    height = top + side + 64
    point = next((g for g in run.groups if len(g.columns) == 3 and run.units[g.columns[0]] in ('m', '')), None)
    energy = next((g for g in run.groups if run.units[g.columns[0]] == 'J' or g.stem == 'energy'), None)
    if point is None:
        return None
    p = Picture(900 if energy else left + side + 20, height)
    p.put('set multiplot', f"set label 1 {quoted(run.title())} noenhanced at screen {left / p.width:.5f}, "
                           f"{1 - 24 / height:.5f} left font ',13'")

    def extent(column):
        return run.most[column] - run.least[column]

    still = min(reversed(point.columns), key=extent)
    plane = [column for column in point.columns if column != still]
    every = math.ceil(len(run.values[0]) / 1600)
    p.block('plane', zip(*(run.texts[column][::every] for column in plane)))
    for axis, column in zip('xy', plane):
        middle, half = (run.least[column] + run.most[column]) / 2, max(map(extent, plane)) / 2
        p.put_range(axis, middle - half, middle + half)
        p.put(f'set {axis}label {quoted(run.label(column, run.names[column]))} noenhanced')
    p.put_place(left / p.width, (left + side) / p.width, 1 - top / height, 1 - (top + side) / height)
    p.put(f"plot $plane with lines linewidth 0.8 linecolor rgb '{COLOURS[0]}'", 'unset label 1')
    if energy:
        column = energy.columns[0]
        start = run.values[column][0]
        p.block(f'column{column}', run.curve(column, 400, start))
        p.put(f'set xrange [0:{run.most[0]:.9g}]', 'set xtics autofreq')
        p.put_range('y', run.least[column] - start, run.most[column] - start)
        p.put("set xlabel 't, s'", f"set ylabel {quoted(run.label(column, 'change of ' + energy.stem))} noenhanced")
        p.put_place(0.55, 0.975, 1 - top / height, 1 - (top + side) / height)
        p.put(f"plot $column{column} with lines linewidth 0.8 linecolor rgb '{COLOURS[1]}'")
    p.put('unset multiplot')
    return p


def histogram(run):
    """The execution times of steps, from 0 to the period, in the bins of the summary: lines `histogram 0 to 31250 ns:
    9999`, and of the last bin `histogram from 968750 ns: 1`. Nothing where the scene asks for no histogram."""
    bins, below_one = 32, 0.5 # where the bars begin: a bin of one tick has a height too
    lines = [line for line in run.summary if line[0] == 'histogram']
    if not lines:
        return None
    ticks = {}
    for line in lines:
        is_last = line[1] == 'from'
        width = float(line[2]) / (bins - 1) if is_last else float(line[3]) - float(line[1])
        ticks[int(float(line[2 if is_last else 1]) / width + 0.5)] = line[-1]
    measure = lines[-1][-2].rstrip(':')
    if measure == 'ns':
        width, measure = width * 1e-3, 'us'
    its = [(bin * width, bin * width + width, ticks[bin]) for bin in range(bins) if int(ticks.get(bin, 0))]
    p = Picture(720, 360)
    p.block('bars', [((start + end) / 2, high, start, end, below_one, high) for start, end, high in its])
    p.block('tops', [row for start, end, high in its for row in ((start, high), (end, high), ())])
    p.put('set logscale y')
    p.put_decades('y', below_one, 2 * max(map(int, ticks.values())))
    p.put_range('x', 0, bins * width)
    p.put(f'set xrange [0:{bins * width:.9g}]',
          f"set xlabel 'execution of a step, {measure}, to the end of the period; the last bin is open'",
          "set ylabel 'ticks'",
          f'set title {quoted(run.title())} noenhanced',
          f"plot $bars using 1:2:3:4:5:6 with boxxyerror fill solid 0.5 noborder linecolor rgb '{COLOURS[0]}', $tops "
          f"with lines linewidth 1.6 linecolor rgb '{COLOURS[0]}'")
    return p


def compare(runs, shared):
    """The outputs that two runs have in common, [(column, column)], a panel for each, one run over the other."""
    p = Panels(len(shared))
    p.put(f'set key on at screen 0.975, {1 - 8 / p.height:.5f} right top horizontal samplen 1.5 noenhanced',
          f'set xrange [0:{max(run.most[0] for run in runs):.9g}]')
    for i, columns in enumerate(shared):
        for run, column, width, colour in zip(runs, columns, ('2.2', '1'), COLOURS):
            p.curve(run.curve(column, CURVES), f"with lines linewidth {width} linecolor rgb '{colour}'", run.name)
        p.put_signals(i, runs[0].label(columns[0], runs[0].names[columns[0]]),
                      min(run.least[c] for run, c in zip(runs, columns)),
                      max(run.most[c] for run, c in zip(runs, columns)))
        p.put('set key off')
    p.put('unset multiplot')
    return p
