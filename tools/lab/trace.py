"""The outputs of a run: the table that build/trace writes, with their units, in groups that share a panel."""
import collections
import math

from lab.build import Wrong

# An output, the x, y, z of a vector, or the w, x, y, z of a quaternion: the name without _x of a component, its
# columns.
Group = collections.namedtuple('Group', 'stem columns')


class Run:
    """Of a folder: trace.csv, units.csv and summary.txt. Column 0 is the time; a unit is empty where none is known."""

    def __init__(self, folder):
        self.name = folder.name
        try:
            self.summary = [line.split() for line in (folder / 'summary.txt').read_text().splitlines() if line]
            units = (folder / 'units.csv').read_text().splitlines()
            head, *lines = (folder / 'trace.csv').read_text().splitlines()
        except OSError as error:
            raise Wrong(f'plot: {error.filename} cannot be read')
        if not lines:
            raise Wrong(f"plot: {folder / 'trace.csv'} has no row")
        self.names = head.split(',')
        self.units = ((units + ['', ''])[1].split(',') + [''] * len(self.names))[:len(self.names)]
        self.texts = list(zip(*(line.split(',') for line in lines))) # [columns][rows], as they stand there
        self.values = [list(map(float, column)) for column in self.texts]
        self.least, self.most = list(map(min, self.values)), list(map(max, self.values))
        self.groups = list(self._groups())

    def said(self, word):
        """What the summary says of it."""
        return next((line[1] for line in self.summary if line[0] == word), '')

    def title(self):
        scene, method, step, real = map(self.said, ('scene', 'method', 'step', 'real'))
        return f'{scene}: {method}, step {1000 * float(step):.6g} ms, {real}'

    def label(self, column, text):
        """A name with the unit of the column, as `hinge_angle, rad`; a pure number has none."""
        return text if self.units[column] in ('', '1') else f'{text}, {self.units[column]}'

    def _groups(self):
        column = 1
        while column < len(self.names):
            stem = self.names[column][:-2]
            for letters in 'wxyz', 'xyz', '':
                if stem and letters and self.names[column:column + len(letters)] == [f'{stem}_{letter}'
                                                                                     for letter in letters]:
                    break
            yield Group(stem if letters else self.names[column], range(column, column + (len(letters) or 1)))
            column += len(letters) or 1

    def curve(self, column, stretches, zero=0.0):
        """Points over time: of each of so many stretches of the rows the least and the greatest value, in their order,
        so that nothing fast is lost; less `zero`."""
        values, points = self.values[column], []
        every = math.ceil(len(values) / stretches)
        for first in range(0, len(values), every):
            part = values[first:first + every]
            for row in sorted({part.index(min(part)), part.index(max(part))}):
                points.append((self.texts[0][first + row], part[row] - zero))
        return points
