"""`isochron cost SCENE`: the cost of each effect of a scene, and its influence: the scene is built and run with all of
them, without each, and without any."""
import math
import pathlib
import re

from lab import build, counts, draw, size, table
from lab.build import Wrong
from lab.cycles import period_of, traced
from lab.machine import path_of
from lab.picture.effects import effects as picture

HEADS = {'add': 'add', 'mul': 'mul', 'div': 'div', 'sincos': 'sincos', 'step': 'instructions of a step',
         'tick': 'of a tick', 'text': 'bytes of text', 'memory': 'of memory', 'states': 'states',
         'memories': 'memories'}
KEYS = list(HEADS)


class Changes:
    """What an effect changes of each output: of its values with the effect less those without, over the ticks of both
    runs, the root of the mean square and the largest. An output that is not there without the effect has none. A run
    that the guard stopped has an end, in s."""

    def __init__(self, whole, without):
        """Of the rows of two traces, each with the names of its columns first."""
        self.rms, self.largest, self.part, self.of, self.end = {}, {}, 0, '', None
        pairs = list(zip(numbers(whole), numbers(without)))
        for i, name in enumerate(whole[0]):
            if i == 0 or name not in without[0] or not pairs:
                continue
            j = without[0].index(name)
            differences = [a[i] - b[j] for a, b in pairs]
            square = sum(d * d for d in differences)
            self.rms[name] = math.sqrt(square / len(pairs))
            self.largest[name] = max(map(abs, differences))
            # The part that the change is of the output itself, with the effect or without, whichever is larger.
            if square > 0:
                part = math.sqrt(square / max(sum(a[i] * a[i] for a, _ in pairs), sum(b[j] * b[j] for _, b in pairs)))
                if part > self.part:
                    self.part, self.of = part, name
        if len(whole) > len(without) and pairs:
            self.end = pairs[-1][1][0]

    def told(self, output):
        return f'{self.rms[output]:.3g}; {self.largest[output]:.3g}' if output in self.rms else 'gone'


def numbers(trace):
    return [list(map(float, row)) for row in trace[1:]]


def signed(counts):
    return [f'{counts[key]:+d}' for key in KEYS]


def show(effects, counts, units):
    """Prints the two tables: costs, and changes of every output. `effects` is a list of (name, kind, Changes); `counts`
    has a dictionary for each name, which for an effect is what it adds, and for base, sum and whole."""
    align = 'l' + 'r' * (len(KEYS) + 2) + 'l'
    rows = []
    for name, kind, changes in effects:
        of, unit = changes.of, units.get(changes.of, '')
        indent = '&nbsp;&nbsp;' * name.count('.')
        change = ['0', '0', '']
        if of:
            change = [f'{changes.rms[of]:.3g}', f'{changes.largest[of]:.3g}', f'{of}, {unit}' if unit else of]
        rows.append([f'{indent}{name}, {kind}', *signed(counts[name]), *change])
    rows.append(['base, without any', *(counts['.base'][key] for key in KEYS), '', '', ''])
    rows.append(['sum of the effects', *signed(counts['.sum']), '', '', ''])
    rows.append(['whole', *(counts['.whole'][key] for key in KEYS), '', '', ''])
    table.show(['effect', *HEADS.values(), 'change, rms', 'largest', 'of'], rows, align)
    print()
    table.show(['change, rms; largest', 'unit', *(name for name, _, _ in effects)],
               [[output, unit, *(changes.told(output) for _, _, changes in effects)] for output, unit in units.items()],
               'll' + 'r' * len(effects))
    for name, _, changes in effects:
        if changes.end:
            print(f'\nWithout {name} the guard stops the run at {changes.end:.9g} s; the changes are until then.')


def rows_of(effects, counts, outputs):
    """The table for programs: a line for each effect, then base, sum and whole; a missing change is empty."""
    yield ['effect', 'kind', *KEYS, 'part', 'of',
           *(f'{name}_{what}' for name in outputs for what in ('rms', 'largest'))]
    for name, kind, changes in effects:
        yield [name, kind, *(counts[name][key] for key in KEYS), f'{changes.part:.9g}', changes.of,
               *(f'{of[output]:.9g}' if output in of else ''
                 for output in outputs for of in (changes.rms, changes.largest))]
    for name in 'base', 'sum', 'whole':
        yield ['', name, *(counts['.' + name][key] for key in KEYS)]


def counted(plant, seconds):
    """What is counted of a plant, by KEYS, and the rows of its trace. On the host one tick is counted by callgrind. A
    run that the guard stops has a trace up to there."""
    done = plant.run(seconds, check=False)
    if plant.target == 'host':
        of = [build.counted(function, [plant.program, 1])[0] for function in ('step', f'iso_loop_tick_{plant.real}')]
    else:
        of = [counts.one(done, 'instructions_per_step'), counts.tick(done)]
    sizes = size.of_program(plant)
    values = [*counts.operations(plant.facts, 'step'), *of, sizes.text, sizes.data_bss,
              *(int(plant.facts.get(key, 0)) for key in ('states', 'memories'))]
    return dict(zip(KEYS, values)), table.read(done.trace, ',')


MOST_TRACED = 1000  # ticks


def tell_rates(plant):
    """Where the scene has rates: the operations of each behind the step, and of the row with the most. On the Cortex-M4F
    the instructions of the dearest tick too, and their mean, over all rows until all rates are due together again."""
    rates = [(fact[5:], counts.operations(plant.facts, fact)) for fact in plant.facts if fact.startswith('rows_every_')]
    if not rates:
        return
    heads = ['add', 'mul', 'div', 'sincos']
    row = plant.facts['dearest_row'].split()[0]
    table.show(['rows', *heads], [*((rate.replace('_', ' '), *of) for rate, of in rates),
                                  (f'dearest, {row}', *counts.operations(plant.facts, 'dearest_row'))])
    if plant.target == 'cortex-m4f':
        together = math.lcm(*(int(re.match(r'every_(\d+)', rate)[1]) for rate, _ in rates))
        ticks = min(together, MOST_TRACED)
        lines = traced(plant, ticks * period_of(plant), ['count', '--range', path_of('cortex-m4f'), 'LISTING',
                                                         'iso_loop_tick_float', 'tick_interrupt'])
        told = {line.split()[0]: int(line.split()[1]) for line in lines.splitlines()}
        some = '' if ticks == together else ' of the first'
        print(f'\nticks {told["least"]} to {told["most"]} instructions, the dearest in row {told["longest"]}; mean '
              f'{told["mean"]},{some} {ticks} rows')
    print()


def run(options):
    listed = [line.split() for line in build.call([build.tools('isoc'), options.scene, '--effects']).splitlines()]
    if not listed:
        raise Wrong(f'{options.scene} has no effect (effect NAME KIND {{ ... }}); isochron cost without a scene prints '
                    'the tables of all models')
    folder = build.outputs('cost', options.scene)
    runs = folder / f'{options.target}-{options.real or "float"}'

    def of(place, without):
        return counted(build.plant(options, folder=runs / place, without=without), options.seconds or 10)
    tell_rates(build.plant(options, folder=runs / 'whole'))
    of_whole, whole = of('whole', None)
    # A part of an effect, EFFECT.PART, has a row below that of the effect, whose cost has the part's.
    whole_effects = [name for name, _ in listed if '.' not in name]
    effects, table_of = [], {'.whole': of_whole, '.base': of('base', '; '.join(whole_effects))[0]}
    for name, kind in listed:
        without, trace = of(f'without-{name}', name)
        table_of[name] = {key: of_whole[key] - without[key] for key in KEYS}
        effects.append((name, kind, Changes(whole, trace)))
    table_of['.sum'] = {key: sum(table_of[name][key] for name in whole_effects) for key in KEYS}
    units = table.read(runs / 'whole/units.csv', ',')
    units = {name: '' if unit == '1' else unit for name, unit in zip(units[0][1:], units[1][1:])}
    rows = list(rows_of(effects, table_of, list(units)))
    table.write(folder / 'effects.tsv', rows)
    show(effects, table_of, units)
    print(f'\n{folder}/effects.tsv')
    name = pathlib.Path(options.scene).stem
    for path in draw.draw({folder / 'effects': picture(name, options.target, rows[0], rows[1:])}):
        print(path)
