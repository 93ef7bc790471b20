"""`isochron drift`: how far the closed loops of a scene come apart with every stabilisation, each alone, in float.

Everything stands in build/drift/NAME/: violation.svg and .png, the picture; STABILISATION.scene, and beside it the
measurements.
"""
import pathlib
import re
import subprocess
import sys

from lab import build, draw, table
from lab.picture.curves import violation
from lab.scene import elsewhere

STABILISATIONS = 'none', 'baumgarte', 'projection', 'lagrangian'
MEASURE = build.ROOT / 'tools/measure'
PARTS = 200 # of the time: points of a line in the picture


def stabilised(path, words):
    """The text of a scene with this stabilisation in place of its own, and with the outputs that drift.c needs."""
    outputs = ''.join(f'output drift_{name} = {what}\n' for name, what in (
        ('violation', 'violation'), ('rate', 'violation_rate'), ('energy', 'energy')))
    return without_stabilisation(elsewhere(path)) + f'\nstabilisation {words}\n{outputs}'


def without_stabilisation(text):
    """The text without this statement, and its braces if it has any."""
    kept, inside = [], False
    for line in text.splitlines():
        begins = re.match(' *stabilisation ', line)
        if not begins and not inside:
            kept.append(line)
        inside = (begins or inside) and '}' not in line and (not begins or '{' in line)
    return '\n'.join(kept) + '\n'


def measure(path, folder, name, seconds, parts, step=None, words=None):
    """The output of tools/measure/drift.c in float, a list of its lines as words, for the scene with the stabilisation
    `words`, by default `name`; the truncation is its violation in double. None if the scene is refused, for which isoc
    says why in NAME.said."""
    source, truncation = folder / f'{name}.scene', '0'
    source.write_text(stabilised(path, words or name))
    for real in 'double', 'float':
        made = folder / f'{name}-{real}'
        done = subprocess.run([build.tools('isoc'), source, '-o', made, '--real', real,
                               *(['--step', step] if step else [])],
                              capture_output=True, text=True)
        (folder / f'{name}.said').write_text(done.stdout + done.stderr)
        if done.returncode:
            return None
        program = build.host_program(made / 'drift', [made / 'plant.c', MEASURE / 'drift.c'], build.REAL_FLAGS[real])
        lines = [line.split() for line in build.call([program, seconds, parts, name.partition('-')[0],
                                                      truncation]).splitlines()]
        truncation = dict(line[:2] for line in lines)['violation']
    return lines


def order(path, folder, seconds=1):
    """That of the scene's method in the first second, with its step, a half and a quarter of it; `-` where these are
    too short."""
    said = build.call([build.tools('isoc'), path, '-o', folder / 'order', '--real', 'double'])
    step = round(float(re.search(r'^step (\S+) s$', said, re.M)[1]) * 1e9)
    if step % 4 or step < 4000:
        return '-'
    made = folder / 'order'
    for part, name in (1, 'coarse'), (2, 'middle'), (4, 'fine'):
        build.call([build.tools('isoc'), path, '-o', made, '--real', 'double', '--name', name, '--step',
                    f'{step // part}ns'])
    program = build.host_program(made / 'order', [MEASURE / 'order.c',
                                                  *(made / f'{name}.c' for name in ('coarse', 'middle', 'fine'))],
                                 ['-I', made, *build.REAL_FLAGS['double']])
    return build.call([program, str(seconds)]).split()[1]


def run(options):
    path, folder = pathlib.Path(options.scene), build.outputs('drift', options.scene, options)
    seconds, measured = f'{build.nanoseconds(options.seconds) / 1e9:.9g}', {}

    def row(name):
        with build.progress(f'runs {path} with {name}'):
            lines = measure(path, folder, name, seconds, str(PARTS), options.step)
        source, said = folder / f'{name}.scene', folder / f'{name}.said'
        if lines is None:
            print(said.read_text().splitlines()[0], file=sys.stderr)
            return [name, '-', 'refused', '-', '-', '-']
        value = {line[0]: line[1] for line in lines}
        measured[name] = [tuple(line[1:]) for line in lines if line[0] == 'part'], value['bound']
        cost = build.plant(source, folder=folder / f'{name}-m4f', target='cortex-m4f', step=options.step).run(0.05)
        is_torn = float(value['end']) < float(seconds)
        apart = [f"torn after {value['end']} s", '-', '-'] if is_torn else [
            value['violation'], '-' if value['bound'] == 'inf' else value['bound'], value['energy']]
        return [name, order(source, folder), *apart, cost.summary['instructions_per_step']]

    table.show(['stabilisation', 'order', 'largest violation', 'bound', 'change of energy', 'instructions of a step'],
               map(row, STABILISATIONS))
    if not measured:
        raise build.Wrong(f'there is nothing to measure in {path}')
    print()
    for file in draw.draw({folder / 'violation': violation(path.stem, measured)}):
        print(file)
