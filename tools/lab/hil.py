"""isochron hil: the worked example. A cart with its pole on a board, balanced by a controller in another process."""
import argparse
import csv
import math
import pathlib
import shlex

from . import build, link, plot

EXAMPLE = build.ROOT / 'models/hil'


def run(options):
    folder = pathlib.Path('build/hil', options.target, options.real or 'float')
    options = argparse.Namespace(**{**vars(options), 'scene': str(EXAMPLE / 'cart_pole.scene'), 'out': folder, 'xcp': None,
                                    'script': None})
    bench = link.linked(options)
    if not options.controller:
        options.controller = shlex.quote(str(controller(bench).absolute()))
    link.connect(bench, options)
    plot.show(bench.folder, ['counts', 'volts', 'pole'])
    return stood(bench.folder / 'trace.csv')


def controller(bench):
    """The program of the controller, of this machine, with the header that isoc wrote for it."""
    program = bench.folder / 'controller'
    return build.host_program(program, [EXAMPLE / 'controller.c'], ['-I', bench.sources])


def stood(trace):
    """Whether the pole was upright to 2 degrees in the last second of the run, and the cart between its stops."""
    with open(trace) as file:
        rows = [{name: float(cell) for name, cell in row.items()} for row in csv.DictReader(file)]
    last = max(abs(math.degrees(row['pole'])) for row in rows if row['t'] >= rows[-1]['t'] - 1)
    cart = max(abs(row['cart']) for row in rows)
    good = last < 2 and cart < 0.4
    print(f'{"stood" if good else "fell"}: pole within {last:.2f} deg of upright in the last second (limit 2 deg), '
          f'cart within {cart:.3f} m (stops at 0.4 m)')
    return 0 if good else 1
