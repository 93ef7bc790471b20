"""What is counted of plants by their firmware on the Cortex-M4F in float."""
import pathlib

from lab import build, size, stack
from lab.build import Wrong
from lab.forced import with_text

FOLDER = pathlib.Path('build/cost')


def one(run, key):
    """The one number that the summary of a run has for the key: with steps that differ it has two."""
    words = run.summary.get(key, '').split()
    if len(words) != 1:
        raise Wrong(f'{run.folder}/summary.txt has not one {key}')
    return int(words[0])


def tick(run):
    """The most instructions from the time that a tick is due until its outputs are published: 25 in a microsecond, less
    the margin."""
    if 'margin' not in run.summary:
        raise Wrong(f'{run.folder}/summary.txt has no margin')
    return round(float(run.summary['step'].split()[0]) * 25e6 - float(run.summary['margin'].split()[0]))


def longest_step(run):
    """With its restart, of which there is one number."""
    words = run.summary['execution'].split(), run.summary.get('restart_execution', '').split()
    if not words[1]:
        raise Wrong(f'{run.folder}/summary.txt has no restart_execution')
    return max(int(words[0][2]), int(words[1][0]))


def operations(said, line):
    """The additions, multiplications, divisions and sines of this line of isoc."""
    words = said[line].split()
    return [int(words[words.index(name) + 1]) for name in ('add', 'mul', 'div', 'sincos')]


class Counts:
    """A plant in build/cost/FOLDER, of a scene that is a path, or a text of this name, after a run. `change` makes
    another text of plant.c."""

    def __init__(self, folder, scene, method=None, step=None, seconds=0.05, change=None, name='pendulum'):
        folder = FOLDER / folder
        if isinstance(scene, str):
            folder.mkdir(parents=True, exist_ok=True)
            (folder / f'{name}.scene').write_text(scene)
            scene = folder / f'{name}.scene'
        kind = 'none' if change else 'run'
        self.plant = build.plant(scene, kind, folder, method=method, step=step, target='cortex-m4f')
        self.said, program = self.plant.said, self.plant
        if change:
            program = with_text(self.plant, 'forced', change((folder / 'plant.c').read_text()))
        self.program, self.run = program, program.run(seconds)

    step = property(lambda self: one(self.run, 'instructions_per_step'))
    tick = property(lambda self: tick(self.run))
    longest_step = property(lambda self: longest_step(self.run))
    sizes = property(lambda self: size.of_program(self.program))
    stack = property(lambda self: stack.depth(stack.of_plant(self.program)))
    operations = property(lambda self: operations(self.plant.facts, 'derivative'))
    states = property(lambda self: int(self.plant.facts['states']))

    def lines(self, word):
        """The words behind this one, of each line of isoc that begins with it."""
        return [line.split()[1:] for line in self.said.splitlines() if line.split()[:1] == [word]]

    @property
    def plant_text(self):
        """The bytes of code and tables of the plant alone."""
        return int(build.call([self.program.port.size, self.program.folder / 'plant.o']).splitlines()[1].split()[0])
