"""`isochron flags`: the cost of a step with each optimisation of the compiler: rk4 and bdf4 of each model. On the
Cortex-M4F instructions, by the trace of QEMU, and the cycles that they mean at most; on the host instructions, by
callgrind. The last row has the geometric means relative to -O2. PORT_OPTIMISE of port/TARGET/port.mk is chosen from it,
on the Cortex-M4F by cycles: -O2, or the least of those that take a twentieth less over all models."""
import math
import pathlib
import subprocess
import types

from lab import build, table
from lab.build import Wrong
from lab.cycles import traced
from lab.machine import path_of

LEVELS = ['-O1', '-O2', '-Os', '-O3']


def heads(title, columns):
    return [title, *(level + (', cycles' if column else '') for level in LEVELS for column in range(columns))]


def means(rows, columns):
    """Relative to -O2: of each column of the rows, which begin with a name."""
    of_o2 = LEVELS.index('-O2') * columns
    ratios = [[math.log(value / row[of_o2 + i % columns]) for i, value in enumerate(row)] for _, *row in rows]
    return ['relative to -O2', *(f'{math.exp(sum(column) / len(rows)):.3f}' for column in zip(*ratios))]


def cost(port, folder, level):
    """What a step of the plant in the folder takes, in a program of its own: instructions, and cycles where they are
    known."""
    program = folder / f'program{port.suffix}'
    objects = [build.ROOT / path for path in port.facts['OBJECTS'].split()]
    build.call([*port.compile, level, '-c', folder / 'plant.c', '-o', folder / 'plant.o'], cwd=build.ROOT)
    build.call([*port.link, folder / 'plant.o', *objects, *port.libraries.split(), '-o', program], cwd=build.ROOT)
    if port.clock == 'ns':
        return [build.counted('step', [program, 1])[0]]
    plant = types.SimpleNamespace(port=port, program=program)
    return [int(line.split()[1]) for line in
            traced(plant, 1, ['count', path_of('cortex-m4f'), 'LISTING', 'step']).splitlines()]


def run(options):
    target, real = options.target or 'host', options.real or 'float'
    if target not in ('host', 'cortex-m4f'):
        raise Wrong('flags is of the host or the cortex-m4f; --target cannot be another')
    scenes = [pathlib.Path(path) for path in options.models.split()] if options.models else \
        sorted(build.ROOT.glob('models/*.scene'))
    for scene in scenes:
        if not scene.exists():
            raise Wrong(f'--models: there is no scene {scene}')
    columns, rows = 1 + (target != 'host'), []
    # The objects that programs share are those of any plant.
    port = build.plant(scenes[0], folder='build/flags', target=target, real=real).port
    folder = pathlib.Path('build/flags/plant').absolute()

    def measured():
        for method in 'rk4', 'bdf4':
            for scene in scenes:
                # Not every scene can be run by every method.
                if subprocess.run([build.tools('isoc'), scene, '-o', folder, '--method', method, '--real', real],
                                  capture_output=True).returncode == 0:
                    numbers = [number for level in LEVELS for number in cost(port, folder, level)]
                    rows.append([f'{scene.stem}, {method}', *numbers])
                    yield rows[-1]
        yield means(rows, columns)
    table.show(heads(f'{target}, {real}', columns), measured())
