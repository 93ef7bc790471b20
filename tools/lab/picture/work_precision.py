"""Error over cost and over the step for every method, of a report's table: a pair of panels for each kind, and a
legend. An error above 100 means nothing, and is not drawn. Over the cost the points off the Pareto front are pale."""
import collections
import math

from lab.draw import Picture, quoted
from lab.picture import looks

# In pixels. The legend has room for so many rows of methods; a picture with more of them is as much higher.
WIDTH, HEIGHT, LEGEND, LEGEND_ROWS, LEGEND_COLUMNS, ROW, COLUMN = 960, 760, 100, 4, 5, 16, 150
FRONT = "with lines linewidth 6 linecolor rgb '#f0d060'"
FAMILIES = 'one step', 'multistep', 'stiff', 'varying step', 'others'
KINDS = {'float': 'float', 'compensated': 'float, compensated sums', 'double': 'double', 'cycles_float': 'float',
         'cycles_compensated': 'float, compensated sums', 'held': 'held inputs, double',
         'smooth': 'smooth inputs, double'}
Point = collections.namedtuple('Point', 'kind method step error cost cells')


def family(method):
    """Of a row of isoc's methods: order, evaluations, Jacobians, solutions, vectors kept; None if isoc has it not."""
    if method is None:
        return 4
    return 3 if 'sub-step' in method[1] else 2 if int(method[2]) else 1 if int(method[4]) else 0


def front(points):
    """The points that no other betters in error and in cost, the cheapest first."""
    found = []
    for point in sorted(points, key=lambda point: (point.cost, point.error)):
        if not found or point.error < found[-1].error:
            found.append(point)
    return found


class WorkPrecision(Picture):
    def __init__(self, scene, time, rows, known):
        points = [Point(row[0], row[1], 1000 * float(row[2]), float(row[4]), float(row[7]),
                        (row[7], row[4], f'{1000 * float(row[2]):.9g}')) for row in rows if 0 < float(row[4]) <= 100]
        self.points, self.time = points, time
        self.methods = list(dict.fromkeys(row[1] for row in rows))
        self.families = [[m for m in self.methods if family(known.get(m)) == f] for f in range(len(FAMILIES))]
        self.rows_of = [math.ceil(len(its) / LEGEND_COLUMNS) for its in self.families]
        self.more = ROW * max(0, sum(self.rows_of) - LEGEND_ROWS)
        super().__init__(WIDTH, HEIGHT + self.more)
        self.look, self.best, self.pale = {}, {}, {}
        order = list(known)
        for i, method in enumerate(self.methods):
            colour, mark = looks.mark(method, order.index(method) if method in known else len(order) + i)
            self.best[method] = f"with points pointsize 0.7 pointtype {mark} linecolor rgb '{colour}'"
            self.look[method], self.pale[method] = (
                f"with linespoints linewidth 1.1 pointsize 0.55 pointtype {mark} linecolor rgb '{shade}'"
                for shade in (colour, looks.pale(colour)))
        if points:
            self.steps, self.errors, self.costs = ([getattr(p, name) for p in points]
                                                   for name in ('step', 'error', 'cost'))
            # The longest step of methods whose steps are fixed.
            fixed = {(row[0], row[1], row[2], row[4]) for row in rows if row[8] == '-'}
            self.longest = max((1000 * float(step) for _, _, step, error in fixed if 0 < float(error) <= 100),
                               default=max(self.steps))
            self.put('set multiplot\nset logscale xy\nset mxtics 1\nset mytics 1',
                     f"set label 4 {quoted(scene + ': error over cost')} noenhanced at screen 0.075, "
                     f"{1 - 30 / self.height:.5f} left font ',14'")
            kinds = [kind for kind in KINDS if any(point.kind == kind for point in points)]
            for place, kind in enumerate(kinds):
                self.put_kind(kind, place, len(kinds))
            self.put_legend()
            self.put('unset multiplot')

    def put_kind(self, kind, place, places):
        """The two panels of a kind, one above the other."""
        width = 0.91 / places
        left = 0.075 + place * width
        right = left + width - 0.025
        what = 'cycles' if kind.startswith('cycles') else 'instructions'
        on = 'host' if 'double' in KINDS[kind] else 'Cortex-M4F'
        label = '' if place else f'error after {self.time} s'
        self.put(f"set label 1 '{KINDS[kind]}' at graph 0, 1 offset 0, 0.8 left font ',12'",
                 f"set xlabel '{what} per second, {on}'", f"set ylabel '{label}' offset 1, 0")
        self.put_decades('y', min(self.errors) / 30, max(self.errors) * 30, not place)
        self.put_decades('x', min(self.costs) / 1.5, max(self.costs) * 1.5)
        self.put_place(left, right, 1 - 80 / self.height, 1 - 310 / self.height)
        its = {method: [p for p in self.points if p.kind == kind and p.method == method] for method in self.methods}
        self.put_costs(its)
        self.put('unset label 2\nunset label 3\nunset label 4')
        self.put_step_axis()
        self.put_place(left, right, 1 - 395 / self.height, 1 - 600 / self.height)
        for method, points in its.items():
            self.curve([point.cells for point in points], 'using 3:2 ' + self.look[method])
        self.put_curves()

    def put_costs(self, its):
        """The panel over the cost: the front, every point in pale, and those on the front; and labels at its ends."""
        best = front([point for points in its.values() for point in points])
        self.put_end(best[0], 2, 'graph 0.955')
        self.put_end(best[-1], 3, f'first {best[-1].cells[1]} offset 0, -0.9')
        self.curve([point.cells[:2] for point in best], FRONT)
        for method, points in its.items():
            self.curve([point.cells for point in points], 'using 1:2 ' + self.pale[method])
        for method in its:
            self.curve([point.cells[:2] for point in best if point.method == method], self.best[method])
        self.put_curves()

    def put_end(self, point, label, where):
        """Names an end of the front: the cheapest at the upper edge of the panel, the most exact below its point."""
        left = math.log(point.cost / min(self.costs)) < math.log(max(self.costs) / min(self.costs)) / 2
        self.put(f"set label {label} '{point.method}, {point.step:.3g} ms' noenhanced at first {point.cost:.9g}, "
                 f"{where} {'left' if left else 'right'} font ',10' front")

    def put_step_axis(self):
        """Labels at the steps of fixed methods, and beyond these by factors of two; every other one has a text."""
        at, tics = self.longest, []
        while 2 * at <= 1.25 * max(self.steps):
            at *= 2
        while at >= 0.8 * min(self.steps):
            text = '' if len(tics) % 2 else f'{at:.4g}'
            tics.append(f"'{text}' {at:.4g}")
            at /= 2
        self.put(f'set xrange [{min(self.steps) * 0.8:.4g}:{max(self.steps) * 1.25:.4g}]',
                 f"set xtics ({', '.join(tics)})",
                 "set xlabel 'step, ms'")

    def put_legend(self):
        """The names of the methods in a panel of its own below the others: each family begins a row."""
        self.put('unset border\nunset tics\nunset grid\nunset xlabel\nunset ylabel\nunset logscale\nunset label',
                 f'set xrange [0:{WIDTH}]\nset yrange [{LEGEND + self.more}:0]')
        self.put_place(0, 1, (LEGEND + self.more) / self.height, 0)
        labels = ["'Pareto front' at 122, 12 left",
                  "'no other point has a smaller error and a smaller cost; what is off it is pale' at 232, 12 left"]
        places, row = {}, 0
        for f, methods in enumerate(self.families):
            for n, method in enumerate(methods):
                x, y = 220 + COLUMN * (n % LEGEND_COLUMNS), 30 + ROW * (row + n // LEGEND_COLUMNS)
                if n == 0:
                    labels.append(f"'{FAMILIES[f]}:' at 85, {y} left")
                labels.append(f"'{method}' noenhanced at {x + 12}, {y} left")
                places[method] = x, y
            row += self.rows_of[f]
        self.put(*(f'set label {i} {label}' for i, label in enumerate(labels, 10)))
        self.curve([(85, 12), (115, 12)], FRONT)
        for method in self.methods:
            x, y = places[method]
            self.curve([(x - 20, y), (x - 7, y)], self.pale[method])
            self.curve([(x - 7, y), (x + 6, y)], self.look[method])
        self.put_curves()


def work_precision(scene, time, rows, known):
    """Rows of report.tsv, and isoc's methods, {name: cells of their row} (lab.build.methods)."""
    p = WorkPrecision(scene, time, rows, known)
    return p if p.points else None
