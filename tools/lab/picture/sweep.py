"""The results of a sweep over the values that it varies, a panel for each result."""
import re

from lab.draw import Picture, quoted

PANEL, BINS, CURVES, ENOUGH = 260, 30, 8, 5
COLOURS = '#0067a5', '#d1590a', '#3c8d2f', '#8b3a9e', '#b8860b', '#1a9e9e', '#a03050', '#555555'
NUMBER = re.compile(r'[-+]?[0-9.]+(e[-+]?[0-9]+)?$')


class Column:
    def __init__(self, name, unit, sort, texts):
        self.name, self.sort, self.texts = name, sort, texts
        self.label = name if unit == '1' else f'{name}, {unit}'
        self.count = len(set(texts))
        self.is_number = all(map(NUMBER.match, texts))
        self.values = list(map(float, texts)) if self.is_number else []


def sweep(scene, is_random, about, head, rows):
    """Of `about`, {name: (unit, set or result)}, and the table of a sweep, whose last column is `ok` of runs that did
    not fail: of random values the histogram of each result. Else a map in colours, where two numbers alone vary with at
    least five values each; else a curve over the number with most values, for each combination of the others, the first
    eight of them. Nothing where no number varies or no result is a number."""
    rows = [row for row in rows if row[-1] == 'ok']
    columns = [Column(name, *about[name], [row[i] for row in rows]) for i, name in enumerate(head[:-1])]
    results = [c for c in columns if c.sort == 'result' and c.is_number and c.name != 'hash' and c.count > 1]
    varied = [c for c in columns if c.sort == 'set' and c.count > 1]
    numbers = [c for c in varied if c.is_number]
    across = max(numbers, key=lambda c: c.count, default=None)
    if len(rows) < 2 or not results or not (is_random or across):
        return None
    along = next((c for c in reversed(numbers) if c is not across), None)
    is_map = (len(varied) == 2 and along and across.count >= ENOUGH and along.count >= ENOUGH
              and len(rows) == across.count * along.count)
    p = Picture(900, 40 + PANEL * len(results))
    p.put(f"set multiplot layout {len(results)},1 title {quoted(f'{scene}: {len(rows)} runs')} noenhanced")
    for i, result in enumerate(results):
        if is_random:
            put_histogram(p, i, result)
        elif is_map:
            put_map(p, i, across, along, result)
        else:
            put_lines(p, across, [c for c in varied if c is not across], result)
    p.put('unset multiplot')
    return p


def put_lines(p, across, others, result):
    curves = {}
    for run, value in enumerate(result.texts):
        # The values of all other columns that vary, as they stand in the legend.
        name = ', '.join(f'{c.name} {c.texts[run]}' for c in others)
        if name in curves or len(curves) < CURVES:
            curves.setdefault(name, []).append((across.texts[run], value))
    for (name, points), colour in zip(curves.items(), COLOURS):
        p.curve(points, f"with linespoints linewidth 1.4 pointtype 7 pointsize 0.35 linecolor rgb '{colour}'", name)
    p.put_range('x', min(across.values), max(across.values))
    p.put_range('y', min(result.values), max(result.values))
    p.put(f'set xlabel {quoted(across.label)} noenhanced')
    p.put_head(result.label)
    p.put('set key ' + ('on outside right center noenhanced samplen 1.5' if others else 'off'))
    p.put_curves()


def put_histogram(p, i, result):
    least, most = min(result.values), max(result.values)
    width, runs = (most - least) / BINS, [0] * BINS
    for value in result.values:
        runs[min(BINS - 1, int((value - least) / width))] += 1
    p.block(f'bars_{i}', [(least + (bin + 0.5) * width, count, width) for bin, count in enumerate(runs)])
    p.put_range('x', least, most)
    p.put_range('y', 0, max(runs))
    p.put(f"set yrange [0:*]\nset boxwidth\nset xlabel {quoted(result.label)} noenhanced\nset ylabel 'runs'",
          f"plot $bars_{i} using 1:2:3 with boxes fill solid 0.5 linecolor rgb '{COLOURS[0]}'")


def put_map(p, i, across, along, result):
    p.block(f'map_{i}', zip(across.texts, along.texts, result.texts))
    p.put_range('x', min(across.values), max(across.values))
    p.put_range('y', min(along.values), max(along.values))
    p.put("set palette defined (0 '#0b2a5b', 1 '#2f7fb8', 2 '#b9dbe8', 3 '#f6d58a', 4 '#b3430a')\nset colorbox",
          f'set xlabel {quoted(across.label)} noenhanced\nset ylabel {quoted(along.label)} noenhanced',
          f'set cblabel {quoted(result.label)} noenhanced', f'plot $map_{i} using 1:2:3 with image pixels')
