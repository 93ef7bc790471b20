"""The errors and the costs of methods on one scene, for `isochron report` and `isochron bench`.

Every method is built in four kinds: float; compensated, in float with compensated sums; double; and reference, in
double with compensated sums. There the inputs are held. For a loop of a scene with inputs they are smooth in
smooth_float, smooth and smooth_reference. A program of a kind and method stands in FOLDER/KIND-METHOD/; it is
tools/measure/drive.c, which takes any step, or any tolerance of adams.
"""
import concurrent.futures
import functools
import hashlib
import math
import os
import pathlib
import re
import subprocess
import sys
import threading

from lab import build, cycles
from lab.machine import machine
from lab.scene import edited, elsewhere, with_values

REFERENCE_METHODS = 'rk4', 'abm4_pecece'
KINDS = 'float', 'compensated', 'double', 'reference', 'smooth_float', 'smooth', 'smooth_reference'
INFINITE = math.inf # an error that is infinite, or no number


class Subject:
    """A scene under measurement: its programs, and the reference that they are compared with.

    step             the scene's, s
    inputs           their number in a loop
    coarsest         the number of steps four times as long that make the time nearest to the one asked for
    time             which they make, s, as text
    fixed            the methods of a fixed step
    resting          the reason why inputs are others than at the start, for a reader of the result
    """

    def __init__(self, what, folder, options):
        self.what, self.folder, self.options = what, folder, options
        self.scene = pathlib.Path(options.scene)
        self.name, self.is_scene = self.scene.stem, self.scene.suffix != '.c'
        self.methods = options.methods.split() if options.methods else [
            method for method in known_methods() if self.is_scene or method != 'adams']
        self.fixed = [method for method in self.methods if method != 'adams']
        self.told, self.made, self.lock = set(), set(), threading.Lock()
        self.drives, self.plants, self.environment, self.resting = {}, {}, dict(os.environ), ''
        if options.recorded:
            self.environment['RECORDED'] = options.recorded
        self.prepare()
        for method in REFERENCE_METHODS:
            self.drive('reference', method, 'the reference')
        self.step_text, _, inputs = self.run('reference', 'rk4', 'about')[0]
        self.step, self.inputs = float(self.step_text), int(inputs) if self.is_scene else 0
        self.coarsest = max(1, int(build.nanoseconds(options.seconds) / (4e9 * self.step) + 0.5))
        self.time = f'{4 * self.coarsest * self.step:.17g}'
        # The tick of a method that chooses its steps: the longest part of the time that is at most ten of the long
        # steps, and no more than isoc allows, 1 s.
        steps = next(n for n in range(40, 0, -1) if n == 1 or 4 * self.coarsest % n == 0 and n * self.step <= 1)
        self.tick = f'{steps * self.step:.9g}s'
        self.rest()
        self.reference([self.time])

    # --- The scene, once for each kind ---

    def source(self, kind):
        return self.folder / kind / self.scene.name

    def prepare(self):
        """Values of effects that follow from the method and its step are in all kinds those of the scene's own: else
        each method would have other equations, and none of them a reference."""
        if self.is_scene:
            self.own = self.isoc(self.scene, 'own', *self.own_step()).stdout
            text = with_values(elsewhere(self.scene), self.own)
        for kind in KINDS:
            self.source(kind).parent.mkdir(parents=True, exist_ok=True)
            if self.is_scene:
                is_compensated = kind == 'compensated' or kind.endswith('reference')
                self.source(kind).write_text(edited(text, {'compensated': 'yes' if is_compensated else 'no'}))
            else: # a plant in C takes its method from core/runtime/handwritten.h
                self.source(kind).write_text(self.scene.read_text())

    def own_step(self):
        return ['--step', self.options.step] if self.options.step else []

    def isoc(self, source, folder, *options):
        return subprocess.run([build.tools('isoc'), source, '-o', self.folder / folder, *options], capture_output=True,
                              text=True)

    def tell(self, messages, source):
        """Shows messages of isoc about a kind of the scene, each warning once, with its place in the scene."""
        messages = messages.replace(f'{source}:', f'{self.scene}:')
        for text in re.split(r'(?m)^(?=\S*:\d+:\d+: )', messages):
            with self.lock:
                if text.strip() and text not in self.told:
                    self.told.add(text)
                    sys.stderr.write(text)

    def fail(self, text):
        raise build.Wrong(f'{self.what}: {text}')

    # --- Programs ---

    def program(self, kind, method, folder, flags=(), tolerance='1e-6', is_told=True):
        """The program drive of a method in a folder, its plant compiled with these flags as well; None if it cannot be
        built. Adams chooses its steps itself, by the tolerance, within the tick."""
        folder, source = self.folder / folder, self.source(kind)
        folder.mkdir(parents=True, exist_ok=True)
        real = 'float' if kind.endswith('float') or kind == 'compensated' else 'double'
        flags = [*flags, *build.REAL_FLAGS[real]]
        step = ['--step', self.tick, '--tolerance', tolerance] if method == 'adams' else self.own_step()
        if not self.is_scene and method == 'adams':
            return None # whose sub-steps only isoc writes
        if self.is_scene:
            made = self.isoc(source, folder.name, '--method', method, '--inputs', reading(kind), '--real', real, *step)
            if is_told:
                self.tell(made.stderr, source)
            if made.returncode:
                return None
            source = folder / 'plant.c'
        else:
            flags += build.plant_flags({'method': method, 'step': self.options.step,
                                        'compensated': kind in ('compensated', 'reference')})
        return build.host_program(folder / 'drive', [source, *self.objects(real)], flags)

    def objects(self, real):
        """What each program is linked with, compiled once."""
        with self.lock:
            made = [self.folder / f'{name}_{real}.o' for name in ('drive', 'file')]
            for path, source in zip(made, ('measure/drive.c', 'file/file.c')):
                if path not in self.made:
                    build.host_program(path, [build.ROOT / 'tools' / source], ['-c', *build.REAL_FLAGS[real]], ())
                    self.made.add(path)
        return made

    def drive(self, kind, method, what=None):
        """The program that takes any step, or any tolerance."""
        if (kind, method) not in self.drives:
            program = self.program(kind, method, f'{kind}-{method}', any_step(method))
            if program is None:
                self.fail(f'{what} cannot be built for {self.scene}' if what else
                          f'{method} cannot be built for {self.scene} in {kind}; --methods chooses others')
            self.drives[kind, method] = program
        return self.drives[kind, method]

    def run(self, kind, method, *words, given=None):
        """What the program prints: the words of each line."""
        done = subprocess.run([self.drive(kind, method), *map(str, words)], env=self.environment, input=given,
                              stdout=subprocess.PIPE, text=True)
        if done.returncode:
            self.fail(f'{method} in {kind} does not run')
        return [line.split() for line in done.stdout.splitlines()]

    # --- Costs ---

    def instructions_m4f(self, kind, method, tolerance='1e-6'):
        """Of a step on the Cortex-M4F, and the summary. Where steps differ, as the first ones of bdf4 do, that which is
        nearer to the mean of fifty; of adams the mean of all sub-steps, with those that were repeated."""
        is_adams = method == 'adams'
        choices = dict(step=self.tick, tolerance=tolerance) if is_adams else dict(step=self.options.step)
        if self.inputs:
            choices['inputs'] = reading(kind)
        if not self.is_scene:
            choices['compensated'] = kind == 'compensated'
        folder = self.folder / f'{kind}-{method}' / ('m4f' + (tolerance if is_adams else ''))
        plant = self.plants[kind, method] = build.plant(
            self.source(kind), folder=folder, method=method, target='cortex-m4f', **choices)
        said = plant.run(f'{float(self.time) if is_adams else 50 * self.step:.9f}').summary
        least, mean, most = map(float, said['execution'].split()[:3])
        if 'substeps' in said:
            mean *= int(said['ticks']) / int(said['substeps'])
            return f'{mean:.0f}', said
        return f'{least if mean - least < most - mean else most:.0f}', said

    def cycles_m4f(self, kind, method):
        """Of a step without a restart, by published timings, the most of them, of the plant whose instructions were
        counted; None where it does not run so."""
        plant = self.plants[kind, method]
        try:
            return cycles.dearest(plant, machine('cortex-m4f').core, cycles.ticks_together(plant)).parts['step'][2]
        except build.Wrong:
            return None

    def instructions_host(self, kind, method, tolerance='1e-6'):
        """Of a step on this machine, in a kind of double; of adams the mean of all in the time."""
        is_adams = method == 'adams'
        program = self.program(kind, method, f'count-{kind}-{method}' + (tolerance if is_adams else ''), (), tolerance)
        words = [self.time, tolerance] if is_adams else ['count', '100']
        count, printed = build.counted('steps', [program, *words], self.environment)
        return f'{count / int(printed.split()[0]):.0f}'

    def instructions(self, kind, method, tolerance='1e-6'):
        if kind == 'double':
            return self.instructions_host(kind, method, tolerance)
        return self.instructions_m4f(kind, method, tolerance)[0]

    def each(self, measure, jobs):
        """{job: measure(*job)} of jobs that begin with a kind and a method, some at once."""
        total, done = len(jobs), []

        def one(job):
            result = measure(*job)
            with self.lock:
                done.append(job)
                print(f'{self.what}: {len(done)} of {total}: {job[1]} in {job[0]}', file=sys.stderr)
            return result

        pool = concurrent.futures.ThreadPoolExecutor(len(os.sched_getaffinity(0)))
        try:
            return dict(zip(jobs, pool.map(one, jobs)))
        finally:
            pool.shutdown(cancel_futures=True)

    # --- The reference ---

    def rests(self):
        return self.run('reference', 'rk4', 'rests', self.time, 4 * self.coarsest) == [['yes']]

    def rest(self):
        """A scene that rests with the inputs of its start has those with which its functions of time are largest, if it
        moves with these, and the reference can follow."""
        if not self.rests():
            return
        self.resting = 'The scene rests, and no method errs.'
        if self.inputs:
            self.environment['STEADY'] = 'yes'
            why = 'The scene rests with the inputs that it has at its start'
            if self.rests():
                self.resting = why + ', and with the largest of their functions: no method errs.'
            elif self.agreed([self.time]):
                self.resting = ('With the inputs that it has at its start the scene rests: each keeps the largest '
                                'value of its function of time, or one SI unit.')
                print(f'{self.what}: {self.resting}', file=sys.stderr)
                return
            else:
                self.resting = (why + ', and no method errs; with the largest of their functions two methods do not '
                                      'agree on what is right.')
            del self.environment['STEADY']
        print(f'{self.what}: {self.resting}', file=sys.stderr)

    def agreed(self, times, kind='reference', mode=None):
        """{time: (apart, state)} at which the two methods agree, or nothing, and why, in `unlike`. The step begins with
        1/64 of the coarsest and is halved until they agree to 1e-12, at most five times; then 1e-9 will do: where an
        effort has a kink, no method of order four comes so far.

        What was computed is kept in build/report/references, by the programs that compute it and their arguments."""
        self.unlike = ''
        programs = [self.drive(kind, method) for method in REFERENCE_METHODS]
        key = hashlib.sha256(b''.join(program.read_bytes() for program in programs))
        key.update(repr((mode, self.coarsest, self.environment.get('STEADY'))).encode())
        if self.options.recorded:
            key.update(pathlib.Path(self.options.recorded).read_bytes())
        file = pathlib.Path('build/report/references') / key.hexdigest()[:24]
        kept = dict(parted(line) for line in file.read_text().splitlines()) if file.exists() else {}
        unknown, steps, found, apart = [time for time in times if time not in kept], 64 * self.coarsest, {}, {}
        for halved in range(6):
            if not unknown:
                break
            states = []
            for method in REFERENCE_METHODS:
                pairs = [word for time in unknown for word in (steps, time)]
                words = [mode, *unknown, steps] if mode else ['pairs', *pairs]
                states.append([list(map(float, line[2:])) for line in self.run(kind, method, *words)])
            tolerance = 1e-12 if halved < 5 else 1e-9
            for time, state, other in zip(unknown, *states):
                if agree(state, other, tolerance):
                    found[time] = f'{distance(state, other):.3g}', state
                else:
                    apart[time] = distance(state, other)
            unknown = [time for time in unknown if time not in found]
            steps *= 2
        if unknown:
            at = float(unknown[0])
            self.unlike = (f'there is no reference for {self.name} after {unknown[0]} s: at steps of '
                           f'{at / (steps // 2):.3g} s rk4 and abm4_pecece still differ by {apart[unknown[0]]:.3g}.\n'
                           'A motion that is chaotic, or stiff, is known for a short time only: try --seconds '
                           f'{at / 4:.6g}')
            return {}
        if found:
            file.parent.mkdir(parents=True, exist_ok=True)
            kept.update(found)
            lines = (' '.join([time, off, *map(repr, state)]) for time, (off, state) in kept.items())
            build.write(file, '\n'.join(lines) + '\n')
        return {time: kept[time] for time in times}

    def reference(self, times, kind='reference', mode=None):
        """{time: (apart, state)}; it is an error if there is none."""
        known = self.agreed(list(dict.fromkeys(times)), kind, mode)
        if self.unlike:
            self.fail(self.unlike)
        return known

    def loop_references(self):
        """Of the two readings of inputs that change at every tick; where inputs are recorded there is no continuous
        signal, and the second is empty."""
        restarted = self.agreed([self.time], 'reference', 'restarted')
        if self.unlike or self.options.recorded:
            return restarted, {}
        for method in REFERENCE_METHODS:
            self.drive('smooth_reference', method, 'the reference of smooth inputs')
        return restarted, self.agreed([self.time], 'smooth_reference', 'smooth')


def any_step(method):
    """Flags with which a plant takes any step. Step.h includes the methods before the plant can say that it has one
    alone."""
    return ['-include', f'core/methods/{method}.h', f'-DISO_METHOD_LIST(X,r)=X(r,ISO_{method.upper()},{method})',
            '-include', 'tools/measure/step.h', '-O1'] # a run has the same bits, and is compiled sooner


@functools.cache
def known_methods():
    """Of isoc's table {method: [order, evaluations, Jacobians, solutions, vectors kept, with a check]}."""
    rows = [line.strip('| ').split(' | ') for line in build.call([build.tools('isoc'), '--methods']).splitlines()]
    return {row[0]: row[1:] for row in rows[2:]}


def reading(kind):
    """Of the inputs of a scene."""
    return 'smooth' if kind.startswith('smooth') else 'held'


def parted(line):
    time, apart, *state = line.split()
    return time, (apart, list(map(float, state)))


def distance(a, b):
    """The 2-norm of the difference of two states."""
    off = math.hypot(*(x - y for x, y in zip(a, b)))
    return off if off < 1e150 else INFINITE


def agree(state, other, tolerance):
    """Whether two states are the same to a part of their size."""
    return distance(state, other) < INFINITE and distance(state, other) <= tolerance * (1 + math.hypot(*state))


def error_of(reference, time, state):
    """The error of a state, words of drive, at a time."""
    return distance(list(map(float, state)), reference[time][1])


# --- The table of a report ---

HEAD = 'kind method step_s steps error order instructions_per_step instructions_per_second tolerance'.split()


def errors(reference, measured):
    """Its rows: of each (kind, method, instructions of a step, tolerance of adams or `-`, line of drive). The order is
    that to which the error fell from the line before, in the step or, where steps vary, in the tolerance; `-` where the
    line before has the same, and unless both errors are well above the uncertainty of the reference."""
    rows, last = [], None
    for kind, method, cost, tolerance, (steps, time, *state) in measured:
        step = float(time) / int(steps)
        fine = step if tolerance == '-' else float(tolerance)
        error, order = error_of(reference, time, state), '-'
        if last and last[:2] == (kind, method) and error < INFINITE and last[2] < INFINITE and fine != last[3] and \
                error > 10 * float(reference[time][0]):
            order = f'{math.log(last[2] / error) / math.log(last[3] / fine):.2f}'
        rows.append([kind, method, f'{step:.9g}', steps, f'{error:.3e}' if error < INFINITE else 'inf', order, cost,
                     f'{int(cost) / step:.6g}', tolerance])
        last = kind, method, error, fine
    return rows


def as_text(rows):
    """The table as lines of text: the methods of a kind each in a row, at each step the error, over the cost and over
    the step; those of adams, whose steps vary, apart."""
    fixed, varied = ([row for row in rows if (row[8] == '-') == is_fixed] for is_fixed in (True, False))

    def nearest(step):
        # A float's step differs from a double's in its last digits only.
        return next((known for known in steps if abs(step / known - 1) < 0.001), None)

    steps = []
    for row in fixed:
        if not nearest(float(row[2])):
            steps.append(float(row[2]))

    def millions(row):
        return f'{float(row[7]) / 1e6:.4g}'

    def short(row):
        return row[4] if row[4] == 'inf' else f'{float(row[4]):.1e}'

    def tables(over_cost):
        last = None
        for kind, method in dict.fromkeys((row[0], row[1]) for row in fixed):
            its = {nearest(float(row[2])): row for row in fixed if row[:2] == [kind, method]}
            if kind != last:
                last = kind
                yield ''
                yield title(kind) if over_cost else kind
                names = ''.join(f" {f'{step * 1000:.4g} ms':>15}" for step in steps)
                yield f"{'':16} {'a step' if over_cost else '':>8}{names}"
            cells = ('-' if step not in its else f'{millions(its[step])} {short(its[step]):>7}' if over_cost else
                     f'{its[step][4]:>9} {its[step][5]:>5}' for step in steps)
            cost = next(iter(its.values()))[6] if over_cost else ''
            yield f'  {method:<14} {cost:>8}' + ''.join(f' {cell:>15}' for cell in cells)

    if fixed:
        yield ('Error over instructions: the instructions of a step, then at each step millions of them in a second of '
               'the\n'
               "plant's time and the error")
        yield from tables(True)
        yield '\nError over the step, with the order observed from the step before'
        yield from tables(False)
    line = '  {:<14} {:>9} {:>12} {:>12} {:>12} {:>9} {:>6}'
    if varied:
        yield (('\n' if fixed else '') + 'adams, whose steps vary: their mean, the instructions of one, millions of '
                                         'them in '
               "a second of\nthe plant's time, the error, and its order in the tolerance\n")
        yield line.format('', 'tolerance', 'a step', 'instructions', 'millions', 'error', 'order')
    for row in varied:
        yield line.format(row[0], row[8], f'{float(row[2]) * 1000:.4g} ms', row[6], millions(row), short(row), row[5])


def title(kind):
    name = {'held': 'held inputs, double', 'smooth': 'smooth inputs, double',
            'compensated': 'float with compensated sums'}
    return name.get(kind, kind) + ', instructions of ' + ('the Cortex-M4F' if kind in ('float', 'compensated')
                                                          else 'this machine')
