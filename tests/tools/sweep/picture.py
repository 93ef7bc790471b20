# Reads the histograms or the maps of a sweep's picture, and compares them with its table.
#
#     picture.py bars|map SVG TABLE X Y RESULT...    a panel for each result; X and Y: the columns of a map, else -
#
# Axes are measured by their tics. A point and the two tics that it is measured by are each a hundredth of a pixel off.
import re
import sys

PIXEL = 0.011
BINS = 30
TIC = re.compile(r"<path stroke='#555555' d='M([\d.]+),([\d.]+) L([\d.]+),([\d.]+)'/>\s*<g transform=[^>]*>\s*<text>(?:<tspan>)?([-+\d.e]+)<")
CELL = re.compile(r"<polygon fill = '#(\w{6})'[^>]*points = '([^']*)'")


class Axis:
    """Pixels of values, by the outermost tics."""

    def __init__(self, tics):
        (self.value, self.pixel), (value, pixel) = min(tics), max(tics)
        self.slope = (pixel - self.pixel) / (value - self.value)
        self.whole = value - self.value

    def at(self, value):
        return self.pixel + (value - self.value) * self.slope

    def off(self, value):
        s = (value - self.value) / self.whole
        return PIXEL * (1 + abs(s) + abs(1 - s))


def tics(text):
    """Of x, y and the colours: values and pixels."""
    found = {"x": [], "y": [], "colour": []}
    for x, y, x_end, y_end, label in TIC.findall(text):
        axis = "x" if x == x_end else "y" if float(x_end) < float(x) else "colour"
        found[axis].append((float(label), float(x if axis == "x" else y)))
    return found


def cells(text):
    """Colours with the least and the largest x and y."""
    found = []
    for colour, corners in CELL.findall(text):
        xs, ys = zip(*(map(float, corner.split(",")) for corner in corners.split()))
        found.append((tuple(bytes.fromhex(colour)), min(xs), max(xs), min(ys), max(ys)))
    return found


def panels(svg):
    """Of each the text before its plot, the plot, and what follows."""
    pieces = re.split(r"""(<g id="gnuplot_plot_1\w+" >.*?)(?=<path stroke='#555555')""", svg, flags=re.S)
    return [(pieces[i - 1], pieces[i], pieces[i + 1]) for i in range(1, len(pieces), 2)]


def bars_wrong(before, body, values):
    axes = tics(before)
    x, y = Axis(axes["x"]), Axis(axes["y"])
    least, width = min(values), (max(values) - min(values)) / BINS
    counts = [0] * BINS
    for value in values:
        counts[min(BINS - 1, int((value - least) / width))] += 1
    drawn = sorted(cell[1:] for cell in cells(body) if cell[4] - cell[3] > 2 * PIXEL)
    expected = [(least + i * width, least + (i + 1) * width, n) for i, n in enumerate(counts) if n > 0]
    if len(drawn) != len(expected):
        return f"{len(drawn)} bars, not {len(expected)}"
    for (left, right, top, bottom), (a, b, n) in zip(drawn, expected):
        # A box is drawn to the next hundredth, on each side.
        far = max(abs(left - x.at(a)) - x.off(a), abs(right - x.at(b)) - x.off(b), abs(top - y.at(n)) - y.off(n), abs(bottom - y.at(0)) - y.off(0))
        if far > 2 * PIXEL:
            return f"the bar of {n} runs from {a:.6g} to {b:.6g} is {far:.3f} pixels off"
    return ""


def map_wrong(before, body, after, rows):
    axes, scale = tics(before), Axis(tics(after)["colour"])
    x, y = Axis(axes["x"]), Axis(axes["y"])
    drawn, bar = cells(body), cells(after)
    if len(drawn) != len(rows) or len(bar) < 64:
        return f"{len(drawn)} cells and {len(bar)} colours, of {len(rows)} runs"
    for a, b, value in rows:
        inside = [cell for cell in drawn if cell[1] <= x.at(a) <= cell[2] and cell[3] <= y.at(b) <= cell[4]]
        if len(inside) != 1:
            return f"{len(inside)} cells at {a}, {b}"
        # The colour lies between those of the bar beside the value; each is rounded to a whole number.
        high = bar[0][4] - bar[0][3]
        near = [cell[0] for cell in bar if cell[3] - high <= scale.at(value) <= cell[4] + high]
        for channel, part in enumerate(inside[0][0]):
            if not min(c[channel] for c in near) - 1 <= part <= max(c[channel] for c in near) + 1:
                return f"the colour at {a}, {b} is not that of {value}"
    return ""


def main():
    kind, svg_path, table_path, across, along, *results = sys.argv[1:]
    with open(svg_path) as file:
        drawn = panels(file.read())
    with open(table_path) as file:
        head, *lines = (line.rstrip("\n").split("\t") for line in file)
    rows = [dict(zip(head, line)) for line in lines if line[-1] == "ok"]
    wrong = "" if len(drawn) == len(results) else f"{len(drawn)} panels, not {len(results)}"
    for (before, body, after), result in zip(drawn, results):
        values = [float(row[result]) for row in rows]
        if kind == "bars":
            wrong = wrong or bars_wrong(before, body, values)
        else:
            wrong = wrong or map_wrong(before, body, after, [(float(r[across]), float(r[along]), v) for r, v in zip(rows, values)])
    sys.exit(wrong or 0)


main()
