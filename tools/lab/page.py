"""The page of a report: its tables, with what they say in words, and its pictures. Each number in a text is made of a
cell of a table, and names it: data-cell has the file, the line and the column (tests/tools/lab/cells.py)."""
import base64
import html

from lab import table
from lab.build import ROOT

# What each part says, by its function below, and its words.
SECTIONS = (
    ('Error over cost and step', 'errors', 'report', 'work_precision',
     'The error of the state at the end, as a 2-norm over all states in SI units, for every method, step and number '
     'type. {resting}'),
    ('Error over cycles', 'errors', 'cycles', 'cycles',
     'The same over the cycles of a step on <code>cortex-m4f</code>: the most by its published timings. For this '
     'machine there are none: above, all costs are instructions.'),
    ('In a loop', None, 'loop', 'loop', 'Inputs change at every tick, as a held staircase or as samples of a smooth '
                                        'signal.'),
    ('How the error grows', 'growth', 'growth', 'growth', ''),
    ('The error of a step', 'local_error', 'local_error', 'local_error',
     'What the method tells of it with <code>checked yes</code>, in double, and what it is against a reference that '
     'begins at the same state.'),
    ('Energy and balance', 'account', 'account', 'account',
     'Of a run in float. The balance is the power that the energy does not explain.'),
    ('Singular positions', 'nearness', 'nearness', None, ''),
    ('Nearness and violation', 'singular', 'singular', 'singular',
     'A pivot of the closures falls to nearly nothing at a singular position: the least of all, over the largest that '
     'the same has in this run; how much one changes in a step, which says whether the step is short enough to see '
     'it; and how far the loops come apart.'),
    ('Stability', 'regions', 'regions', 'regions',
     'A method keeps stable what lies to the left of its curve, or within it: the growth of its own step is one '
     'there. The points are the step times the eigenvalues at the start and at the end; some may lie outside of the '
     'picture. Of <code>adams</code> the step is that of a sub-step; <code>bdf4</code> and <code>rosenbrock</code> '
     'know fast decays only as the Jacobian at the start of a step has them.'),
    ('The dearest tick', 'tick', 'tick', None, 'Its parts by published timings of the core.'),
    ('What each effect costs and changes', None, 'effects', 'effects', ''))
HEAD = """<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{name}: report</title>
<style>
{style}</style>
</head>
<body>
<header><h1>{name}</h1><p id="about">report of its methods; every number is of a table on this page</p></header>
<main class="report">
"""


def page(folder, name, resting, has_no_loop):
    """The page of the tables and pictures that are in the folder, with motion/show.html if it is there."""
    parts = [HEAD.format(name=name, style=''.join((ROOT / 'tools' / file).read_text()
                                                  for file in ('show/page.css', 'lab/page.css')))]
    motion = folder / 'motion/show.html'
    if motion.exists():
        text = motion.read_text().replace('&', '&amp;').replace('"', '&quot;')
        parts.append(f'<h2>The mechanism</h2>\n<iframe title="The mechanism in motion" srcdoc="{text}"></iframe>\n')
    for title, words, file, picture, about in SECTIONS:
        if file == 'loop' and has_no_loop:
            parts.append('<p>In a loop nothing is measured: two methods do not agree on what is right.</p>\n')
        path = folder / f'{file}.tsv'
        if path.exists():
            drawn = folder / f'{picture}.svg'
            parts += [f'<h2>{title}</h2>\n', about and f'<p>{about.format(resting=resting)}</p>\n',
                      *Section(path).text(words, title, drawn if picture and drawn.exists() else None)]
    return ''.join(parts) + '</main></body></html>\n'


class Section:
    """Of a table; rows and columns have numbers from 1 on, row 1 the names."""

    def __init__(self, path):
        self.file, self.cells = path.name, table.read(path)
        self.last = len(self.cells)

    def cell(self, row, column):
        return self.cells[row - 1][column - 1]

    def value(self, row, column):
        return float(self.cell(row, column))

    def number(self, row, column):
        """A cell in short."""
        size = abs(self.value(row, column))
        text = f'{self.value(row, column):{".0f" if 100 <= size < 1e7 else ".3g"}}'
        return f"<data value='{self.cell(row, column)}' data-cell='{self.file}:{row}:{column}'>{text}</data>"

    def extreme(self, column, choose, of=None):
        """The first row where a column has its least or its largest value; of those that begin with `of`."""
        rows = [row for row in range(2, self.last + 1) if of in (None, self.cell(row, 1))]
        return choose(rows, key=lambda row: self.value(row, column))

    def text(self, words, title, picture):
        if words:
            yield from getattr(self, words)()
        if picture:
            yield (f'<figure><img alt="{title}" '
                   f'src="data:image/svg+xml;base64,{base64.b64encode(picture.read_bytes()).decode()}"></figure>\n')
        yield f"<details><summary>{self.file}, {self.last} lines</summary>\n<table data-file='{self.file}'>\n"
        for row, cells in enumerate(self.cells):
            tag = 'td' if row else 'th'
            yield '<tr>' + ''.join(f'<{tag}>{html.escape(cell, quote=False)}</{tag}>' for cell in cells) + '</tr>\n'
        yield '</table></details>\n'

    def errors(self):
        """Of each kind the least error and its place, and the cheapest that has at most a thousand times it."""
        unit = 'cycles' if 'cycles' in self.file else 'instructions'
        kinds = {}
        for row in range(2, self.last + 1):
            if self.cell(row, 5) != 'inf':
                kinds.setdefault(self.cell(row, 1), []).append(row)
        yield '<ul>\n'
        for kind, rows in kinds.items():
            above = [row for row in rows if self.value(row, 5) > 0]
            if not above:
                continue
            best = min(above, key=lambda row: self.value(row, 5))
            cheap = min((row for row in rows if self.value(row, 5) <= 1000 * self.value(best, 5)),
                        key=lambda row: self.value(row, 8))
            yield (f'<li><b>{kind}</b>: no error is below {self.number(best, 5)}: {self.cell(best, 2)}, steps of '
                   f'{self.number(best, 3)} s, {self.number(best, 8)} {unit} per second. Of those within a factor of a '
                   f'thousand the cheapest is {self.cell(cheap, 2)} with steps of {self.number(cheap, 3)} s: error '
                   f'{self.number(cheap, 5)}, {self.number(cheap, 8)} {unit} per second.</li>\n')
        yield '</ul>\n'

    def growth(self):
        """The last row of each kind."""
        last = {self.cell(row, 1): row for row in range(2, self.last + 1)}
        said = ', '.join(f"{'lost' if self.cell(row, 5) == 'inf' else self.number(row, 5)} in {kind}"
                         for kind, row in last.items())
        yield (f'<p>{self.cell(2, 2)} with a step of {self.number(2, 3)} s; the error after '
               f'{self.number(self.last, 4)} s is {said}.</p>\n')

    def local_error(self):
        """The row with the largest error, and that with the middle one of the ratios."""
        most = self.extreme(3, max)
        ratios = sorted((self.value(row, 4), row) for row in range(2, self.last + 1) if self.cell(row, 4) != '-')
        yield (f'<p>{self.cell(2, 6)} with a step of {self.number(2, 5)} s: the largest error of a step is '
               f'{self.number(most, 3)}, after {self.number(most, 1)} s, and the method tells {self.number(most, 2)} '
               'there.')
        if ratios:
            middle = self.number(ratios[len(ratios) // 2][1], 4)
            yield f' In half of the steps it tells less than {middle} times the error.'
        yield '</p>\n'

    def nearness(self):
        if self.value(2, 2) > 0:
            yield (f'<p>{self.number(2, 2)} of {self.number(2, 1)} ticks are near a singular position of the closures, '
                   f'from {self.number(2, 3)} s in <b>{html.escape(self.cell(2, 4))}</b>: there the step is too long '
                   'for the motion, and energy can be lost or gained.</p>\n')
        else:
            yield (f'<p>Of {self.number(2, 1)} ticks {self.number(2, 2)} are near a singular position of the '
                   'closures.</p>\n')

    def singular(self):
        """Where the least pivot is, and the largest change and violation."""
        least, change, apart = self.extreme(2, min), self.extreme(3, max), self.extreme(4, max)
        yield (f'<p>The least pivot is {self.number(least, 2)} of its largest, at {self.number(least, 1)} s; the '
               f'largest change in a step is by a factor of {self.number(change, 3)}, at {self.number(change, 1)} s; '
               f'the largest violation is {self.number(apart, 4)}, at {self.number(apart, 1)} s.</p>\n')

    def account(self):
        yield '<ul>\n'
        for row in range(2, self.last + 1):
            unit = self.cell(row, 2) and ', ' + self.cell(row, 2)
            start, end, least, most = (self.number(row, column) for column in range(3, 7))
            yield (f'<li><b>{self.cell(row, 1)}</b>{unit}: {start} at the start, {end} at the end, between {least} and '
                   f'{most}.</li>\n')
        yield '</ul>\n'

    def regions(self):
        """The eigenvalues that are farthest to the left, to the right and up."""
        left, right, up = (self.extreme(column, choose, 'eigenvalue')
                           for column, choose in ((2, min), (2, max), (3, max)))
        yield (f'<p>The fastest decay times the step is {self.number(left, 2)}, the fastest growth '
               f'{self.number(right, 2)}, the fastest oscillation {self.number(up, 3)}.</p>\n')

    def tick(self):
        """A bar for each target: the parts of a tick by their share of its cycles."""
        total = {self.cell(row, 1): row for row in range(2, self.last + 1) if self.cell(row, 2) == 'tick'}
        for target, whole in total.items():
            yield (f'<p><b>{target}</b>: a tick takes at most {self.number(whole, 5)} cycles, {self.number(whole, 6)} '
                   f'us.</p>\n'
                   "<div class='bar'>")
            for row in range(2, self.last + 1):
                part, most = self.cell(row, 2), self.value(row, 5)
                if self.cell(row, 1) == target and part not in ('tick', 'interrupt') and most:
                    share = 100 * most / self.value(whole, 5)
                    yield (f"<span class='{part}' style='flex-grow:{share:.4g}' title='{part}: {self.cell(row, 5)} "
                           f"cycles'>{part if share > 9 else ''}</span>")
            yield '</div>\n'
        parts = 'loop', 'inputs', 'checks', 'step', 'finish', 'outputs', 'tell', 'port'
        yield "<p class='key'>" + ' '.join(f"<i class='{part}'></i>{part}" for part in parts) + '</p>\n'
