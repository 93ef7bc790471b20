"""`isochron compare A B`: two runs that --keep kept, one over the other, and their differences."""
import math
import pathlib

from lab import build, draw, trace
from lab.picture import run as picture


def shared_outputs(a, b):
    """Their common outputs, as pairs of columns."""
    shared = [(c, b.names.index(name, 1)) for c, name in enumerate(a.names) if c and name in b.names[1:]]
    for one, other in shared:
        if a.units[one] != b.units[other]:
            raise build.Wrong(f"compare: {a.names[one]} is in '{a.units[one]}' in {a.name}, and in '{b.units[other]}' "
                              f"in {b.name}")
    if not shared:
        raise build.Wrong(f'compare: {a.name} and {b.name} have no output in common')
    return shared


def shared_instants(a, b):
    """The rows of their common times. Times are ticks times a step, rounded: the same where they differ by less than a
    thousandth of the shorter step."""
    every = [run.values[0][1] if len(run.values[0]) > 1 else math.inf for run in (a, b)]
    near, instants, other = 1e-3 * min(every), [], 0
    for one, time in enumerate(a.values[0]):
        while other < len(b.values[0]) - 1 and b.values[0][other] < time - near:
            other += 1
        if abs(b.values[0][other] - time) < near:
            instants.append((one, other))
    if len(instants) < 2:
        raise build.Wrong(f'compare: {a.name} has a row every {every[0]:g} s and {b.name} every {every[1]:g} s: they '
                          'have no time in common but the start; run both with one --step, or a multiple of it')
    return instants


def differences(a, b, shared, instants):
    """A table: the root of the mean square and the largest."""
    yield f'{a.name} - {b.name} at {len(instants)} times, from 0 to {a.values[0][instants[-1][0]]:g} s'
    yield '{:<24} {:<8} {:>14} {:>14} {:>10}'.format('output', 'unit', 'rms', 'largest', 'at, s')
    for one, other in shared:
        apart = [a.values[one][i] - b.values[other][k] for i, k in instants]
        most = max(range(len(apart)), key=lambda i: abs(apart[i]))
        at = a.values[0][instants[most][0]] if apart[most] else 0
        rms = math.sqrt(sum(x * x for x in apart) / len(apart))
        yield f'{a.names[one]:<24} {a.units[one]:<8} {rms:14.6g} {apart[most]:14.6g} {at:10g}'


def run(options):
    folders = [pathlib.Path('build/runs', name) for name in options.words]
    for folder in folders:
        if not (folder / 'trace.csv').exists():
            raise build.Wrong(f'there is no run {folder.name}; isochron run SCENE --keep {folder.name} keeps one')
    a, b = map(trace.Run, folders)
    shared = shared_outputs(a, b)
    for line in differences(a, b, shared, shared_instants(a, b)):
        print(line)
    folder = pathlib.Path('build/compare')
    folder.mkdir(parents=True, exist_ok=True)
    for file in draw.draw({folder / f'{a.name}-{b.name}': picture.compare((a, b), shared)}):
        print(file)
