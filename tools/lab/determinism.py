"""`isochron determinism`: the hash of so many ticks, and the least and the most that a step takes, of scenes with
methods on targets: a line for each as it is measured, then a table of a row for a scene with a method and a column for
a target, and all of it in build/determinism/REAL.tsv. The status is 1 if a hash is another than that of the host, or a
step takes no single number."""
import collections
import os
import pathlib
import re
import subprocess
import sys

from lab import build, table
from lab.build import ROOT, Wrong
from lab.kept import kept

FOLDER = pathlib.Path('build/determinism')
PART = 500000  # a timer of 24 bits makes a longer tick of several parts, each with an interrupt
HEAD = 'scene method target ticks hash right least most unit tick'.split()
# Hash, least and most of a step, its unit, and whether a tick of the board is shorter than a step. Without a hash there
# is a word in its place: `failed`; `too_large` for the target; `refused` there.
Cell = collections.namedtuple('Cell', 'hash least most unit tick', defaults=('-', '-', '-', ''))


def measured(scene, method, real, target, ticks, step):
    # A tick of a board is long, so that most steps end before its interrupt comes.
    on, variables = ('host', {'PORT_CC': 'clang'}) if target == 'clang' else (target, {'PORT_CYCLE_NS': '1'})
    why = ''
    with build.overheard() as said:
        try:
            plant = build.plant(scene, folder=FOLDER / 'run', method=method, real=real, target=on, variables=variables)
            summary = plant.run(f'{ticks * step:.9f}').summary
        except Wrong as wrong:
            said.seek(0)
            why = f'{said.read()}{wrong}'
    if why:
        if re.search('--real double is refused|double is not IEEE', why):
            return Cell('refused')
        if re.search('will not fit|overflowed by|overflow in conversion|larger than maximum', why):
            return Cell('too_large')
        raise Wrong('\n'.join(why.splitlines()[-3:]))
    execution = summary.get('execution', '').split()
    if 'hash' not in summary:
        raise Wrong('the run has no hash')
    if not execution or execution[3] == 'ns':
        return Cell(summary['hash'])
    return Cell(summary['hash'], execution[0], execution[2], execution[3],
                'longer' if summary.get('margin', '').startswith('-') else '')


def told(cell, right, method):
    """What the table shows, and whether it is wrong: `=` has the bits of the host, `N` too, with N instructions or
    cycles on every step; `N-M` takes from N to M, which only the sub-steps of adams may; `N+` takes N and an interrupt
    of the timer or more, since it is longer than a tick of the board; OTHER has other bits."""
    if not re.fullmatch('[0-9a-f]{16}', cell.hash):
        return cell.hash.replace('_', ' '), cell.hash == 'failed'
    if cell.hash != right:
        return 'OTHER', True
    if cell.least == '-':
        return '=', False
    if cell.least == cell.most:
        return cell.least, False
    if cell.tick == 'longer' or int(cell.most) > PART:
        return f'{cell.least}+', False
    return f'{cell.least}-{cell.most}', method != 'adams'


def run(options):
    real, ticks = options.real or 'float', int(options.ticks)
    isoc = build.tools('isoc')
    scenes = (options.models or ' '.join(map(str, sorted((ROOT / 'models').glob('*.scene'))))).split()
    methods = (options.methods or ' '.join(build.methods())).split()
    targets = (options.on
               or ' '.join(['host', 'clang', *(t for t in build.targets() if t not in ('host', 'posix'))])).split()
    for scene in scenes:
        if not os.path.isfile(scene):
            raise Wrong(f'there is no scene {scene}')
    FOLDER.mkdir(parents=True, exist_ok=True)
    rows, hashes, cells, wrong, ticks_of = [HEAD], {}, collections.defaultdict(dict), 0, {}
    # Each target with all scenes and methods, so that what they share is compiled once.
    for target in targets:
        # The simulator of the AVR takes a thousand times as long as the others.
        ticks_of[target] = max(1, ticks // 1000) if target == 'atmega1284p' else ticks
        for scene in scenes:
            name = pathlib.Path(scene).stem
            for method in methods:
                made = subprocess.run([isoc, scene, '-o', FOLDER / 'plant', '--method', method, '--real', real],
                                      capture_output=True, text=True)
                if made.returncode:
                    print(f'{name} {method}: isoc refuses it', file=sys.stderr)
                    continue
                step = float(re.search(r'^step (\S+) s$', made.stdout, re.M)[1])

                def look(on):
                    # A sweep goes on where it was ended.
                    source = (FOLDER / 'plant/plant.c').read_text()
                    facts = 'determinism', scene, source, method, real, on, ticks_of[target]
                    try:
                        return kept(lambda: measured(scene, method, real, on, ticks_of[target], step), *facts)
                    except Wrong as wrong:
                        print(wrong, file=sys.stderr)
                        return Cell('failed')

                right, cell = look('host').hash, look(target)
                rows.append([name, method, target, ticks_of[target], cell.hash, right, *cell[1:]])
                print(f'{target:<12} {name:<16} {method:<12} {" ".join(cell)}', file=sys.stderr)
                cells[f'{name} {method}'][target], is_wrong = told(cell, right, method)
                wrong += is_wrong
                if target == 'host':
                    hashes[f'{name} {method}'] = cell.hash
        table.write(FOLDER / f'{real}.tsv', rows)
    columns = [target for target in targets if any(target in row for row in cells.values())]
    width = max(map(len, cells), default=0)
    wide = {target: max([len(target)] + [len(row.get(target, '')) for row in cells.values()]) for target in columns}
    for name, row in [('', dict(zip(columns, columns))), *cells.items()]:
        right = 'hash' if not name else hashes.get(name, '-')
        print(f'{name:<{width}}  {right:<16}'
              + ''.join(f'  {row.get(target, ""):>{wide[target]}}' for target in columns))
    fewer = ''.join(f', {ticks_of[target]} on {target}' for target in columns if ticks_of[target] < ticks)
    print(f'{ticks} ticks{fewer}; wrong: {wrong}')
    return wrong > 0
