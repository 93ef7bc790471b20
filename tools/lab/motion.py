"""Motions of a scene in this process: the exact one, and those of methods in float against it (lab/choose.py)."""
import dataclasses
import hashlib
import math
import os
import pathlib
import re
import shutil
import subprocess
import tempfile

from lab import build
from lab.build import ROOT, Wrong
from lab.kept import kept
from lab.rig import Plant, np
from lab.scene import edited, elsewhere

# The rows that are made at once: all that a plant keeps is copied in each.
CHUNK = 10000
REFERENCE_TICKS = 4_000_000  # with more a reference takes minutes


class Refused(Exception):
    """isoc refuses the scene, with these words."""


@dataclasses.dataclass
class Bound:
    """How far an output may be from the exact motion: `value` in SI units, of which `scale` has so many as `unit`."""
    value: float
    unit: str
    scale: float
    output: str
    columns: list
    is_angle: bool

    def told(self, error):
        return f'{error * self.scale:.2g}' + (f' {self.unit}' if self.unit else '')

    def of_output(self, error):
        return f'{self.told(error)} of {self.output}'


def library(folder, real, quick):
    """The plant in a folder as a library of this process. Where a program runs for less time than a compiler optimises,
    tcc is the one to take, in a tenth of the time; it changes no bit (tests/promises/same_bits.t)."""
    double = ['-DISO_REAL_DOUBLE'] if real == 'double' else []
    made = tempfile.mkstemp('.so', dir=folder)[1]
    if quick and shutil.which('tcc'):
        command = ['tcc', '-include', ROOT / 'tools/lab/tcc.h']
    else:
        command = [*os.environ.get('CC', 'cc').split(), '-O1' if quick else '-O2', '-fPIC',
                   *(ROOT / 'tools/build/numerics').read_text().split(), *os.environ.get('CFLAGS', '').split()]
    try:
        if subprocess.run([*command, '-std=c11', f'-I{ROOT}', f'-I{folder}', *double, '-shared',
                           ROOT / 'tools/lab/rig.c', '-o', made]).returncode:
            raise Wrong(f'{folder}/plant.c cannot be compiled')
        return Plant(made)
    finally:
        os.unlink(made)


def signed_random(state):
    """A number of Steele, Lea, Flood (2014), Fast splittable pseudorandom number generators, and its sign."""
    mask = (1 << 64) - 1
    while True:
        state = state + 0x9E3779B97F4A7C15 & mask
        z = (state ^ state >> 30) * 0xBF58476D1CE4E5B9 & mask
        z = (z ^ z >> 27) * 0x94D049BB133111EB & mask
        yield -1 if z >> 63 == 0 else 1


def errors_of(rows, reference, bounds):
    """For each bound how far off its output is in each row: the length of the difference. Angles may be turns apart."""
    count, column, errors = min(len(rows), len(reference)), 0, []
    difference = rows[:count] - reference[:count]
    for bound in bounds:
        of = difference[:, column:column + len(bound.columns)]
        column += len(bound.columns)
        if bound.is_angle:
            of = np.where(np.abs(of) > 6, np.remainder(of + math.pi, 2 * math.pi) - math.pi, of)
        errors.append(np.sqrt((of * of).sum(axis=1)))
    return errors


def largest(errors, bounds, part=1):
    """The largest error, in parts of its bound."""
    return max(np.fmax.reduce(of) / (bound.value * part) for of, bound in zip(errors, bounds))


def rows_within(errors, bounds, part=1):
    """How many rows from the first on keep this part of every bound."""
    kept_by = len(errors[0])
    for of, bound in zip(errors, bounds):
        beyond = np.flatnonzero(of > bound.value * part)
        kept_by = min(kept_by, beyond[0] if len(beyond) else kept_by)
    return int(kept_by)


class Motions:
    """The motions of a scene with what was asked for of it: `options` are those of the command."""

    def __init__(self, options, folder):
        self.options, self.folder, self.name = options, folder, pathlib.Path(options.scene).stem
        self.base = elsewhere(pathlib.Path(options.scene))
        self.recorded = None
        self.settings = [word for name in ('set', 'without') if getattr(options, name)
                         for word in (f'--{name}', getattr(options, name))]
        read = subprocess.run([build.tools('isoc'), options.scene, '--files'], capture_output=True,
                              text=True).stdout.splitlines()
        included = [pathlib.Path(path).read_bytes() for path in read[1:] if os.path.exists(path)]
        self.facts = self.base, included, self.settings, options.inputs

    def compiled(self, folder, text, *words):
        """isoc makes the plant of this text in a folder; its summary."""
        folder.mkdir(parents=True, exist_ok=True)
        scene = folder / f'{self.name}.scene'
        scene.write_text(text)
        done = subprocess.run([build.tools('isoc'), scene, '-o', folder, *self.settings, *words], capture_output=True,
                              text=True)
        if done.returncode:
            first = re.search(r'error: (.*)', done.stderr)
            raise Refused(first[1] if first else done.stderr)
        return done.stdout

    def record(self, path):
        """Takes inputs from a file: a line for each step of the scene, with a number for each input, and blanks or
        commas between them."""
        try:
            self.recorded = np.array([line.replace(',', ' ').split() for line in open(path) if line.strip()], float)
        except ValueError:
            self.recorded = np.empty((0, 0))
        self.facts += self.recorded.tobytes(),

    def text(self, statements):
        return edited(self.base, statements)

    def bounded(self, asked):
        """The Bounds of `asked`, a list of (value, output); reads period, inputs and what is not of every tick."""
        folder = self.folder / 'bounded'
        outputs = ''.join(f'output choose_bound_{i} = {value}\n' for i, (value, _) in enumerate(asked))
        summary = self.compiled(folder, f'{self.base}\n{outputs}', '--method', 'rk4', '--real', 'double',
                                *(['--step', self.options.step] if self.options.step else []))
        source = (folder / 'plant.c').read_text()
        plant = library(folder, 'double', True)
        plant.start()
        self.period, self.inputs = plant.facts.period_ns, plant.facts.inputs
        self.every = math.lcm(*(int(n) for n in re.findall(r'(?:output_every_|is_due_)(\d+)', source)))
        is_smooth = self.options.inputs == 'smooth' or (not self.options.inputs and 'ISO_SMOOTH' in source)
        self.reading = 'smooth' if is_smooth and not self.options.recorded else 'held'
        units = dict(zip(plant.names, plant.facts.output_units.decode().split(',')))
        values = dict(zip(plant.names, plant.now['y'][0]))
        self.bounds = [bound_of(f'choose_bound_{i}', *of, units, values) for i, of in enumerate(asked)]
        self.columns = [column for bound in self.bounds for column in bound.columns]
        return summary

    def outputs(self, plant, ticks, every, stride, seed=0):
        """The rows of the bounded outputs of a run, until the guard ends it. Recorded inputs have a line for each step
        of the scene, of which a tick is `stride`. With a seed each state at the start is another, as far off as
        rounding to float may put it, and a start of 0 a little."""
        plant.start()
        if seed:
            x = plant.now['x'][0]
            size = np.maximum(np.abs(x.astype(float)), 2.0 ** -10)
            x += (size * [sign for _, sign in zip(x, signed_random(seed))] * 2.0 ** -24).astype(x.dtype)
            plant.library.rig_output()
        made = np.empty((ticks // every + 1, len(self.columns)))
        for first in range(0, ticks, CHUNK * every):
            count = min(CHUNK * every, ticks - first)
            given = None
            if self.recorded is not None:
                given = self.recorded[(np.arange(first, first + count) * stride // every) % len(self.recorded)]
            rows, ended = plant.go(count, every, given, first)
            place = first // every
            made[place:place + len(rows)] = rows['y'][:, self.columns]
            if ended < count:
                return made[:place + len(rows)]
        return made

    def reference(self, n, rows, seed=0):
        """Rows of rk4 in double with compensated sums, of n steps in a step of the scene. Smooth inputs are sampled at
        each of them."""
        if self.reading == 'smooth':
            every, substeps, inputs = n, None, 'smooth'
        else:
            every, substeps, inputs = 1, str(n), self.options.inputs

        def make():
            folder = self.folder / f'reference-{n}'
            try:
                self.compiled(folder, self.text({'substeps': substeps, 'compensated': 'yes'}), '--method', 'rk4',
                              '--real', 'double',
                              '--step', f'{self.period // every}ns', *(['--inputs', inputs] if inputs else []))
            except Refused as refused:
                raise Wrong(f'the reference cannot be built for {self.options.scene}: {refused}')
            return self.outputs(library(folder, 'double', False), rows * every, every, 1, seed)

        return kept(make, self.facts, self.bounds_known(), 'reference', n, rows, seed)

    def bounds_known(self):
        return self.period, self.reading, self.columns

    def judge(self, say):
        """Makes the exact motion, `exact`, and finds for how many `rows` one can judge, which it tells. From the first
        row on in which a start as far off as rounding to float puts it makes an error as large as the bound, no method
        in float can keep it; an eighth is left to the steps."""
        every, steps = self.every, []
        for n in range(2, min(1000, self.period // 1000) + 1):
            if self.period % n == 0 and (not steps or n >= 2 * steps[-1]):
                steps.append(n)
        if len(steps) < 2:
            raise Wrong(f'the step of {step_of(self.period)} is too short for a reference')
        steps = steps if len(steps) == 2 else steps[1:]
        first = self.reference(steps[0], self.rows)
        if len(first) <= self.rows:
            self.rows = (len(first) - 1) // every * every
            say(f'The motion ends at the guard after {self.seconds(self.rows)} s: judged up to there.')
            if self.rows < 8 * every:
                raise Wrong('the scene does not run for 8 steps; '
                                 f'isochron run {self.options.scene} says why')
        near = far = self.rows
        for seed in 1, 2, 3:
            moved = errors_of(self.reference(steps[0], self.rows, seed), first, self.bounds)
            near, far = min(near, rows_within(moved, self.bounds, 1 / 8)), min(far, rows_within(moved, self.bounds))
        if far < self.rows and far // 2 // every < 8:
            # The time does not matter: the tries decide.
            moved = errors_of(self.reference(steps[0], self.rows, 1), first, self.bounds)
            say(f'Rounding of the start to float may alone make {largest(moved, self.bounds):.2g} times the bound.')
        elif far < self.rows:
            fold = (float(self.seconds(far)) - float(self.seconds(near))) / math.log(8)
            near = max(near, far // 2)
            say(f'From {self.seconds(far)} s on no method in float can keep the bound: the rounding of the start to '
                f'float, 6e-8 of it, grows to the\nbound; in the end it grows by a factor of e in {fold:.2g} s. '
                f'Judged up to {self.seconds(near)} s.')
            self.rows = near
        self.rows = self.rows // every * every
        self.agree(first, steps[1:], say)

    def agree(self, exact, steps, say):
        """Refines the reference until it differs from the one before by less than a fiftieth of the bounds."""
        for n in steps:
            finer = self.reference(n, self.rows)
            apart = errors_of(finer, exact, self.bounds)
            exact, agreed, known = finer, rows_within(apart, self.bounds, 1 / 50), f'{largest(apart, self.bounds):.1g}'
            if agreed >= self.rows or self.rows * n >= REFERENCE_TICKS:
                break
        # A tenth of the bound will do, or most of the time.
        if agreed < self.rows and float(known) > 0.1:
            if agreed < max(self.rows // 2, 8 * self.every):
                raise Wrong(f'the exact motion is not known: {n} steps in {step_of(self.period)} or half as '
                                 f'many differ by {known} times the bound.\nTake a larger --error or a '
                            'shorter --seconds')
            self.rows = agreed // self.every * self.every
            say(f'The exact motion is known to a fiftieth of the bound up to {self.seconds(self.rows)} s: judged up '
                'to there.')
            known = '0.02'
        self.exact, self.digest = exact, hashlib.sha256(exact.tobytes()).hexdigest()
        say(f'Reference: rk4 in double, {n} steps in {step_of(self.period)}, inputs {self.reading}; twice the steps '
            f'change it by {known} of the bound.')

    def seconds(self, rows):
        return f'{rows * self.period * 1e-9:.4g}'

    def errors(self, method, compensated, k, n):
        """The largest error of each bound, of a method in float, with a tick of k steps of the scene, and n steps in a
        tick; or why there is none."""
        def make():
            with tempfile.TemporaryDirectory(dir=self.folder) as folder:
                folder = pathlib.Path(folder)
                self.compiled(folder, self.text(statements_of(n, compensated, method)), '--method',
                              method.partition('-')[0],
                              '--real', 'float', '--step', f'{self.period * k}ns',
                              *(['--inputs', self.options.inputs] if self.options.inputs else []))
                rows = self.outputs(library(folder, 'float', True), self.rows // k, self.every, k * self.every)
            if len(rows) <= self.rows // k // self.every:
                return 'ends early'
            errors = [float(np.fmax.reduce(of)) for of in errors_of(rows, self.exact[::k * self.every], self.bounds)]
            return errors if all(map(math.isfinite, errors)) else 'not finite'

        try:
            return kept(make, self.facts, self.bounds_known(), self.digest, self.rows, method, compensated, k, n)
        except Refused as refused:
            return f'refused: {refused}'


def bound_of(name, value, output, units, values):
    """A Bound, from the plant that has its value as an output of that name, beside all others."""
    names = list(units)
    columns = [names.index(output)] if output in units else [
        names.index(output + end) for end in ('_w', '_x', '_y', '_z') if output + end in units]
    if not columns:
        there = []
        for other in names:
            base = re.sub('_[wxyz]$', '', other)
            base = base if base + '_x' in units and base + '_y' in units else other
            if not other.startswith('choose_bound_') and base not in there:
                there.append(base)
        raise Wrong(f"--error: '{value} of {output}': there is no output {output}; the scene has: "
                         + ' '.join(there))
    asked, unit = units[name], units[names[columns[0]]]
    same = {'J': 'N*m', 'W': 'V*A', 'N*m/s': 'V*A'}
    if same.get(asked, asked) != same.get(unit, unit) and (asked, unit) != ('rad', '1'):
        of = 'a number without unit' if asked == '1' else asked
        raise Wrong(f"--error: '{value} of {output}': {of} is no unit of {output}, which is in {unit}")
    number = re.match(r'[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?', value)
    si = float(f'{values[name]:.9g}')
    return Bound(si, value[number.end():].strip(), float(number[0]) / si, output, columns, unit == 'rad')


def step_of(ns):
    """As a scene has it."""
    return f'{ns / 1e6:.9g} ms' if ns >= 1e6 else f'{ns / 1e3:.9g} us' if ns >= 1e3 else f'{ns} ns'


def statements_of(n, compensated, method):
    """Of a plant with so many steps in a tick. A METHOD is a word of isoc; that of adams has its tolerance behind it:
    adams-1e-06."""
    compensated = 'yes' if compensated else 'no'
    if method.startswith('adams-'):
        return {'method': 'adams', 'substeps': str(n), 'compensated': compensated, 'tolerance': method[6:]}
    return {'substeps': str(n) if n > 1 else None, 'compensated': compensated, 'tolerance': None}
