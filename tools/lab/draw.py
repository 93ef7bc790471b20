"""Pictures by gnuplot: its commands, and what draws them as svg and png.

A picture is made of panels: curves are added to one, then put there. A point of a curve is a row of cells, texts as
they stand in a table or numbers; an empty row ends a line.
"""
import math
import os
import pathlib
import re

from lab.build import call, need, write

COLOURS = '#0067a5', '#d1590a', '#3c8d2f', '#8c8c8c'
STYLE = """set border 3 linewidth 0.8 linecolor rgb '#555555'
set tics nomirror out scale 0.6 textcolor rgb '#333333'
set grid linetype 1 linecolor rgb '#d4d4d4' linewidth 0.7
set format '%g'
set key off"""


def decade_below(x):
    """The power of ten at or below a number; a logarithm can be off by one there."""
    return int(f'{x:.17e}'.split('e')[1])


def decade_above(x):
    below = decade_below(x)
    return below + (power_of_ten(below) < x)


def power_of_ten(n):
    return float(f'1e{n}')


def quoted(text):
    return "'" + text.replace("'", "''") + "'"


def cell(value):
    return value if isinstance(value, str) else f'{value:.9g}'


def drawable(text):
    """Whether a cell of a table is a number that a logarithmic axis has."""
    return 0 < float(text) < math.inf


class Picture:
    """The commands of a picture of this size, in pixels."""

    def __init__(self, width, height):
        self.width, self.height, self.lines, self.curves, self.blocks = width, height, [STYLE], [], 0

    def put(self, *lines):
        self.lines += lines

    def text(self):
        return f'# size {self.width} {self.height:g}\n' + '\n'.join(self.lines) + '\n'

    def block(self, name, rows):
        """Data for `plot $NAME`."""
        self.put(f'${name} << END', *(' '.join(map(cell, row)) for row in rows), 'END')

    def curve(self, rows, style, title=''):
        """Adds a curve to the panel; the title stands in the legend. Nothing where there is no point."""
        if rows:
            self.blocks += 1
            self.block(f'curve_{self.blocks}', rows)
            self.curves.append(f'$curve_{self.blocks} {style} ' + (f'title {quoted(title)}' if title else 'notitle'))

    def put_curves(self):
        self.put('plot ' + ', '.join(self.curves))
        self.curves = []

    def put_title(self, text):
        """A title above the picture, and on its right a legend."""
        self.put(f'set title {quoted(text)} noenhanced', 'set key on outside right center noenhanced samplen 2')

    def put_head(self, text):
        """A text above a panel."""
        self.put(f"set label 1 {quoted(text)} noenhanced at graph 0, 1 offset 0, 0.6 left font ',11'")

    def put_time(self, is_last):
        """The axis of time that several panels share: its labels stand below the last one."""
        self.put("set xlabel 't, s'\nset format x '%g'" if is_last else "unset xlabel\nset format x ''")

    def put_place(self, left, right, top, bottom):
        """The place of a panel, as fractions of the picture from its left and lower edges."""
        self.put(*(f'set {side}margin at screen {at:.5f}' for side, at in zip('lrtb', (left, right, top, bottom))))

    def put_range(self, axis, least, most):
        """A linear axis over these values with some air, and two to five tics at multiples of 1, 2 or 5 times a power
        of ten, labelled with as many digits as they need."""
        air = 0.06 * (most - least) or (0.1 * abs(least) if least else 1)
        half = (most - least + 2 * air) / 2
        tic = power_of_ten(decade_below(half))
        tic *= 5 if half >= 5 * tic else 2 if half >= 2 * tic else 1
        first, last = math.ceil((least - air) / tic), math.floor((most + air) / tic)
        digits = max(6, 1 + decade_below(tic * max(1, abs(first), abs(last))) - decade_below(tic))
        tics = ', '.join(f"'{i * tic:.{digits}g}' {i * tic:.12g}" for i in range(first, last + 1))
        self.put(f'set {axis}range [{least - air:.9g}:{most + air:.9g}]', f'set {axis}tics ({tics})')

    def put_whole_decades(self, values):
        """A logarithmic axis y over whole decades."""
        self.put_decades('y', power_of_ten(decade_below(min(values))), power_of_ten(decade_above(max(values))))

    def put_decades(self, axis, least, most, labels=True):
        """A logarithmic axis. Labels stand at powers of ten, so many decades apart that there are at most six; over
        less than two decades at 2 and 5 times such a power as well. Gnuplot, with tics given by a factor alone, begins
        with the end of the axis and labels it as the decade below."""
        first, last = decade_above(least), decade_below(most)
        apart = 1 + int((last - first) / 6)
        tics = []
        for power in range(first - 1, last + 1):
            for times in '125' if last - first < 2 else '1':
                text = f'{times}e{power}'
                if least <= float(text) <= most and power % apart == 0:
                    label = '' if not labels else f'10^{{{power}}}' if times == '1' else text
                    tics.append(f"'{label}' {text}")
        self.put(f'set {axis}range [{least:.4g}:{most:.4g}]', f'set {axis}tics ({", ".join(tics)})')


def draw(pictures, png=True):
    """Draws pictures, of {path without ending: Picture or None}, by one gnuplot, which looks for its fonts once.
    Returns the files, each svg with its png behind it, which are there when they are whole. Where there is None, old
    ones are removed."""
    commands, names = [], []
    for path, picture in pictures.items():
        name = str(path)
        for ending in '.svg', '.png', '.gnuplot':
            pathlib.Path(name + ending).unlink(missing_ok=True)
        if picture is None:
            continue
        names.append(name)
        pathlib.Path(name + '.gnuplot').write_text(picture.text())
        size = f'size {picture.width},{picture.height:g}'
        for ending, terminal in (('.svg', f"svg {size} font 'sans-serif,11' background rgb 'white'"),
                                 ('.png', f"pngcairo {size} font 'sans-serif,9'"))[:1 + png]:
            commands += ['-e', f"set terminal {terminal}; set output {quoted(name + ending + '.drawn')}",
                         name + '.gnuplot',
                         '-e', 'reset session']
    if names:
        need(['gnuplot'], 'apt-get install gnuplot-nox')
        call(['gnuplot', *commands])
    for name in names:
        raw = pathlib.Path(name + '.svg.drawn')
        write(name + '.svg', compact(raw.read_text()))
        raw.unlink()
        if png:
            os.replace(name + '.png.drawn', name + '.png')
    return [pathlib.Path(name + ending) for name in names for ending in ('.svg', '.png')[:1 + png]]


NOISE = re.compile(r'<title>gnuplot_plot_[^<]*</title>|<text></text>| stroke-linecap="butt" stroke-linejoin="miter"'
                   r'| class="gridline" ')


def compact(drawing):
    """A drawing of gnuplot without text of no effect: names of curves, blanks, empty groups, and a group that begins
    like the one that has just ended; colours as #rrggbb."""
    kept, opened = [], [] # (text, of an end the begin of its group); begins of groups
    for line in drawing.splitlines():
        line = NOISE.sub('', line).replace('<tspan font-family="sans-serif" >', '<tspan>')
        line = re.sub(r'rgb\( *(\d+) *, *(\d+) *, *(\d+)\)',
                      lambda rgb: '#%02x%02x%02x' % tuple(map(int, rgb.groups())), line)
        if '<text>' not in line: # texts keep their blanks
            line = re.sub('  +', ' ', line).replace(" '/>", "'/>")
        for text in re.split('(?=<g[ >]|</g>)', line):
            text = text.strip(' \t')
            if text == '</g>':
                begin = opened.pop()
                if kept[-1][0] == begin:
                    kept.pop()
                else:
                    kept.append((text, begin))
            elif re.match('<g[ >]', text):
                opened.append(text)
                if kept[-1][1] == text:
                    kept.pop()
                else:
                    kept.append((text, None))
            elif text:
                kept.append((text, None))
    return ''.join(text + '\n' for text, _ in kept)
