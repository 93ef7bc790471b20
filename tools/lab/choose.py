"""`isochron choose`: the cheapest method, step, number of steps in a tick and summation of a scene whose errors stay
below bounds, on a chip. All that is made stands in build/choose/FOLDER/."""
import argparse
import concurrent.futures
import dataclasses
import math
import pathlib
import re
import subprocess
import sys
import threading

from lab import build, search
from lab.build import Wrong
from lab.cycles import ticks_of
from lab.kept import kept
from lab.machine import boards, machine
from lab.motion import Motions, Refused, errors_of, statements_of, step_of
from lab.rig import np
from lab.scene import edited

NUMBER = r'[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?'
OF_ANOTHER_CHIP = 'rk4', 'heun', 'rosenbrock'
LEAST_TRIED = 8  # as many of the least errors are counted
ONE_BUILDS = threading.Lock()  # what programs share is made once


@dataclasses.dataclass
class Candidate:
    """A method with its places in the grid, and what it costs: the cheapest of its kind, or why there is none."""
    method: str
    compensated: bool
    k: int = 0
    n: int = 0
    errors: list = None
    ratio: float = math.inf  # the largest error in its bound
    next: float = None       # of one step coarser
    cycles: int = 0
    load: float = math.inf   # %
    why: str = ''            # none: `steps` and `rounding` of the least error; else a text
    unpriced: bool = False   # no cycles are known

    @property
    def found(self):
        return not self.why


class Chip:
    """What the dearest tick of a plant takes of it."""

    def __init__(self, options, machine):
        self.machine, self.hz, self.board = machine, machine.hz, machine.board
        self.how = {name: getattr(options, name) for name in ('target', 'inputs', 'set', 'without')}
        self.how['core'] = machine.core

    def count(self, motions, candidate):
        """Sets cycles and load of a candidate; where they are not known, `why` says it."""
        text = motions.text(statements_of(candidate.n, candidate.compensated, candidate.method))
        ns, method = motions.period * candidate.k, candidate.method.partition('-')[0]
        try:
            cycles = kept(lambda: dearest(motions, text, method, ns, **self.how), motions.facts, text, method, ns,
                          self.how)
        except Wrong as wrong:
            candidate.why, candidate.unpriced = str(wrong), True
        else:
            candidate.cycles, candidate.load = cycles, float(f'{1e11 * cycles / self.hz / ns:.6g}')


class Choice:
    """A request, and the candidates that were found for it."""

    def __init__(self, options, machine, folder, say=print):
        self.options, self.machine, self.folder, self.say = options, machine, folder, say
        self.load = number_of(options.load)
        asked = asked_bounds(options.error)
        motions = self.motions = Motions(options, folder)
        if options.recorded:
            motions.record(options.recorded)
        try:
            summary = self.summary = motions.bounded(asked)
        except Refused as refused:
            raise Wrong(f"--error '{options.error}': {refused}")
        if options.recorded and not motions.inputs:
            raise Wrong(f'--recorded has no effect: {options.scene} has no inputs')
        if options.recorded and motions.recorded.shape[1] != motions.inputs:
            raise Wrong(f'--recorded {options.recorded}: it has no lines of {motions.inputs} numbers, one for each '
                        'input')
        motions.rows = build.nanoseconds(options.seconds) // motions.period // motions.every * motions.every
        if motions.rows // motions.every < 8:
            raise Wrong(f'--seconds is too short: {motions.rows} steps of {step_of(motions.period)} are less than 8 '
                        'rows')
        # A sum or a product takes at least so many cycles: without a unit for them many.
        soft = 1 if machine.core in ('cortex-m4f', 'cortex-m7') else 20
        line = re.search(r'^derivative add (\d+) mul (\d+) div (\d+) sincos (\d+)', summary, re.M)
        add, mul, div, sincos = map(int, line.groups())
        self.each = soft * (add + mul + 14 * div + 20 * sincos)
        # A step that is given is the tick: then no longer one is tried.
        self.longest = 1 if options.step else 1000
        self.chip, self.limit = Chip(options, machine), machine.hz * self.load / 100
        self.costs = costs_of_methods()
        self.tried, self.candidates, self.lock, self.is_over = {}, [], threading.Lock(), False

    # --- The search ---------------------------------------------------------------------------------------------------

    def ratio(self, method, compensated, k, n):
        """The largest error in its bound."""
        if self.is_over:
            raise Wrong('')
        made = self.motions.errors(method, compensated, k, n)
        ratio = math.inf
        if not isinstance(made, str):
            ratio = max(float(f'{error / bound.value:.6g}') for error, bound in zip(made, self.motions.bounds))
        self.tried[method, compensated, k, n] = ratio, made
        return ratio

    def candidate(self, method, compensated, k, n, **more):
        ratio, errors = self.tried[method, compensated, k, n]
        return Candidate(method, compensated, k, n, errors, ratio, **more)

    def priced(self, candidate):
        """The candidate with its cost."""
        if candidate.found:
            self.chip.count(self.motions, candidate)
        return candidate

    def rate(self, candidate):
        """Cycles per second, of one within the load."""
        return candidate.load / 100 * self.machine.hz if candidate.found and candidate.load <= self.load else math.inf

    def of_method(self, method, least):
        """The cheapest without and with compensated sums; `least` cycles per second and more are too dear."""
        if method == 'adams':
            return [self.of_adams(least)]
        plain, place = self.searched(method, False, least, 0, False)
        # Compensated sums add instructions to each step: they pay if they allow a longer one.
        summed, _ = self.searched(method, True, min(least, self.rate(plain)),
                                  *((0, False) if place is None else (place + 1, True)))
        return [plain, summed]

    def searched(self, method, compensated, least, start, only_coarser):
        order, evaluations = self.costs[method]
        motions = self.motions
        grid = search.Grid(motions, self.longest, order, int(least * motions.period * 1e-9 / (evaluations * self.each)),
                           lambda k, n: self.ratio(method, compensated, k, n))
        place = grid.search(start, only_coarser)
        if place is not None:
            longer = grid.ratio(place + 1) if place < grid.coarsest else None
            return self.priced(self.candidate(method, compensated, grid.k(place), grid.n(place), next=longer)), place
        tried = [at for at in grid.tried if grid.tried[at] < math.inf]
        if tried:
            at = min(tried, key=grid.tried.get)
            return self.candidate(method, compensated, grid.k(at), grid.n(at), why=grid.why), None
        why = self.tried[method, compensated, grid.k(start), grid.n(start)][1] if grid.tried else grid.why
        return Candidate(method, compensated, why=why), None

    def of_adams(self, least):
        ticks = [self.priced(Candidate('adams-1e-06', False, 1, n)) for n in (1, 8)]
        for tick in ticks:
            if not tick.found:
                return dataclasses.replace(tick, method='adams')
        one, more = ticks[0].cycles, (ticks[1].cycles - ticks[0].cycles) // 7
        found, tried = search.search_adams(self.motions, self.longest, one, more, least,
                                           lambda method, k, n: self.ratio(method, False, k, n))
        if found:
            return self.priced(self.candidate(found[0], False, *found[1:3]))
        return Candidate('adams', False, why=f'no: {one} cycles for a tick of one sub-step, {more} for each more: ' + (
            'what is cheaper than the best, and within the load, does not keep the bound' if tried else
            'dearer at every tick than the best, or than the load'))

    def search(self, methods, limit):
        """The candidates of the methods. Those that are known to be dear come last: then they need not be tried in
        short steps. For adams only variants are tried that are cheaper than all others. What is known to be too dear
        does not depend on which of several that are tried at once is done first."""
        dear = 'euler', 'semi_implicit'
        phases = [[m for m in methods if m == 'rk4'], [m for m in methods if m not in (*dear, 'rk4', 'adams')],
                  [m for m in methods if m in dear], [m for m in methods if m == 'adams']]
        self.candidates, least, count = [], limit, 0

        def one(method):
            nonlocal count
            made = self.of_method(method, least)
            with self.lock:
                count += 1
                print(f'choose: {count} of {len(methods)}: {method}: {self.progress(made)}', file=sys.stderr,
                      flush=True)
            return made

        with concurrent.futures.ThreadPoolExecutor(build.processors()) as pool:
            try:
                for phase in phases:
                    for made in pool.map(one, phase):
                        self.candidates += made
                    least = min([least, *map(self.rate, self.candidates)])
            except BaseException:
                self.is_over = True
                raise

    def progress(self, made):
        found = [one for one in made if one.found]
        if found:
            best = min(found, key=lambda one: one.load)
            return f'{named(best, self)}: {self.errors_told(best)}, {self.cost_told(best)}'
        return self.reasons(made)[0][1]

    # --- What is told -------------------------------------------------------------------------------------------------

    def cheapest(self, load=None):
        """The cheapest that was found, of at most this load."""
        found = [one for one in self.candidates if one.found and (load is None or one.load <= load)]
        return min(found, key=lambda one: one.load, default=None)

    def errors_told(self, of, alone=False):
        """The errors; `alone`: that of one bound without its output."""
        bounds = self.motions.bounds
        if alone and len(bounds) == 1:
            return bounds[0].told(of.errors[0])
        return ', '.join(bound.of_output(error) for bound, error in zip(bounds, of.errors))

    def cost_told(self, of):
        share = f'{of.load:.2g}' if of.load < 10 else f'{of.load:.0f}'
        return f'{time_of(of.cycles / self.machine.hz * 1e9)}, {share} % of the chip'

    def take(self, of):
        return f'{named(of, self)}: {self.errors_told(of, alone=True)}, {self.cost_told(of)}'

    def reasons(self, candidates):
        """Why there is none: (name, text) of each that says something new."""
        plain, least, told = {}, {}, []
        for one in candidates:
            method, why = one.method, one.why
            if one.unpriced:
                if one.compensated and plain.get(method) == why:
                    continue
                plain[method] = why
                text = f'no cycles are known: {why}'
            elif one.errors is not None:
                if one.compensated and (method in least and one.ratio > 0.9 * least[method] or self.has(method)):
                    continue
                least.setdefault(method, one.ratio)
                text = f'no: {self.errors_told(one)} at {step_of(self.motions.period * one.k)}'
                text += f' in {one.n} sub-steps' if one.n > 1 else ''
                text += '; more steps are dearer' if why == 'steps' else ', by rounding'
            else:
                if one.compensated and (self.has(method) or plain.get(method) == why):
                    continue
                plain[method] = why
                text = why
            told.append((method + (', compensated' if one.compensated else ''), text))
        return told

    def has(self, method):
        return any(one.found and one.method == method for one in self.candidates)

    def table(self):
        found = sorted((one for one in self.candidates if one.found), key=lambda one: one.load)
        if found:
            yield f'{"method":<44} {"cycles":>9} {"time":>9} {"load":>9}  error'
        for one in found:
            load, time = f'{one.load:.3g} %', time_of(one.cycles / self.machine.hz * 1e9)
            yield f'{named(one, self):<44} {one.cycles:>9} {time:>9} {load:>9}  {self.errors_told(one)}'
        for name, text in self.reasons([one for one in self.candidates if not one.found]):
            yield f'{name:<44} {text}'

    def decides(self, best):
        """The limit of the cheapest candidate, its cost, and the cheapest of another method."""
        longer = ''
        if best.next is not None:
            error = f'{100 * best.next:.0f} %' if best.next < 1e4 else 'none that stays'
            longer = f'; the next longer step has {error}'
        self.say(f'{named(best, self)}: {self.errors_told(best)}, {100 * best.ratio:.0f} % of the bound{longer}.')
        self.say(f'{best.cycles} cycles in the dearest tick, {time_of(best.cycles / self.machine.hz * 1e9)}; '
                 f'{best.load:.3g} of {self.load:g} % of the chip.')
        if best.k > 1:
            period = step_of(self.motions.period)
            self.say(f'Its tick is {best.k} times that of the scene; --step {period.replace(" ", "")} keeps it as it '
                     'is.')
        others = [one for one in self.candidates if one.found and one.method != best.method]
        if others:
            other = min(others, key=lambda one: one.load)
            self.say(f'Runner-up: {named(other, self)}: {self.errors_told(other)}, {self.cost_told(other)}: '
                     f'{other.load / best.load:.2f} times as dear.')

    # --- The advice ---------------------------------------------------------------------------------------------------

    def advise(self, best):
        """Writes the advised scene, runs it, and measures its error again; the statements that it has."""
        motions, options, path = self.motions, self.options, self.folder / 'advised.scene'
        method = best.method.partition('-')[0]
        compensated = 'yes' if best.compensated else None
        others = {**statements_of(best.n, best.compensated, best.method), 'compensated': compensated}
        others.pop('method', None)
        statements = {'step': step_of(motions.period * best.k), 'method': method, **others}
        text, how = edited(motions.base, statements, must='step'), {}
        if text is None:
            text, how = motions.text({**others, 'compensated': 'yes' if best.compensated else 'no'}), {
                'method': method, 'step': f'{motions.period * best.k}ns'}
        path.write_text(text)
        again, shown = self.ratio(best.method, best.compensated, best.k, best.n), 1e-4
        if not options.recorded:
            plant = build.plant(path, folder=self.folder / 'run', quiet=True, target='host', real='float',
                                set=options.set, without=options.without, inputs=options.inputs, **how)
            run = plant.run(f'{motions.period * motions.rows}ns')
            again, shown = self.measured(best, np.loadtxt(run.trace, delimiter=',', skiprows=1, ndmin=2))
        if not (again <= 1 + shown and abs(again - best.ratio) <= shown):
            raise Wrong(f'the advised scene has {again:.6g} of the bound when it runs, not {best.ratio:.6g}; it is '
                        f'{path}')
        self.say(f'It ran as {path}: its error is {100 * again:.0f} % of the bound.')
        return statements

    def measured(self, best, trace):
        """The largest error of a run in its bound, from its trace, and the error that the decimal numbers of a trace
        may add, which are just long enough to distinguish floats."""
        motions = self.motions
        exact = motions.exact[::best.k * motions.every][:motions.rows // best.k // motions.every + 1]
        rows = trace[::motions.every, [1 + column for column in motions.columns]]
        if len(rows) < len(exact):
            return math.inf, 0
        errors = errors_of(rows, exact, motions.bounds)
        values = [bound.value for bound in motions.bounds for _ in bound.columns]
        return (max(of.max() / bound.value for of, bound in zip(errors, motions.bounds)),
                1e-4 + 1.2e-7 * np.abs(exact / values).max())

    def keep(self, statements):
        """Writes the advice into the scene."""
        options, told = self.options, '; '.join(f'{word} {value}' for word, value in statements.items()
                                                if value is not None)
        scene = pathlib.Path(options.scene)
        text = edited(scene.read_text(), statements, must='step')
        if text is None:
            raise Wrong(f'--write: {scene} has no step of its own, but includes one; it stays as it is. The advice is: '
                        f'{told}')
        build.write(scene.resolve(), text)
        self.say(f'written into {scene}: {told}'
                 + (f'; --inputs {options.inputs} has to be given to each run' if options.inputs else ''))

    # --- None ---------------------------------------------------------------------------------------------------------

    def ways_out(self, methods):
        """What would do if no candidate keeps the bounds within the load: a larger error, another chip, an effect
        less."""
        self.say('\nWhat would do:')
        self.say(self.larger_error())
        self.another_chip(methods)
        effects = subprocess.run([build.tools('isoc'), self.options.scene, '--effects', *self.motions.settings],
                                 capture_output=True, text=True).stdout.split()[::2]
        if effects:
            self.say('An effect less:')
        for effect in effects:
            print(f'choose: without {effect}', file=sys.stderr)
            self.say(f'    without {effect}: {self.without(effect, methods)}')

    def larger_error(self):
        """The least error of all runs that were made, whose tick fits. A tick that was too dear stands for all with as
        many steps in a time."""
        dear, left = math.inf, LEAST_TRIED
        for key, (ratio, _) in sorted(self.tried.items(), key=lambda one: one[1][0]):
            if ratio >= 1000 or not left:
                break
            one = self.candidate(*key)
            if one.n / one.k >= dear:
                continue
            left -= 1
            if not self.priced(one).found:
                continue
            if one.load > self.load:
                dear = one.n / one.k
                continue
            larger = '; '.join(f'{bound.value * bound.scale * max(ratio, 1) * 1.05:.2g} {bound.unit} of {bound.output}'
                               for bound in self.motions.bounds)
            return f"A larger error: --error '{larger}': {self.take(one)}."
        return (f'A larger error: up to a thousand times as large, nothing that was tried fits into {self.load:g} % of '
                'this chip.')

    def another_chip(self, methods):
        """The cheapest that keeps the bounds, whatever it takes of this chip, on the boards that have a unit for
        floats."""
        best = self.cheapest()
        if best is None:
            self.search(methods, 1e30)
            best = self.cheapest()
        if best is None:
            self.say('Another chip: none; in float no method that was tried keeps the bounds, however fast the chip.')
            return
        clock = self.machine.hz * best.load / self.load / 1e6
        self.say(f'Another chip: {self.take(best)}: a clock of {clock:.3g} MHz.')
        for name, target, _, clock, *_ in boards():
            if name == self.machine.board or name.startswith('mps2') or target not in ('cortex-m4f', 'cortex-m7'):
                continue
            options = argparse.Namespace(**{**vars(self.options), 'target': target, 'board': name, 'clock': clock,
                                            'core': None})
            one = dataclasses.replace(best)
            Chip(options, machine(target, '', name, clock)).count(self.motions, one)
            if one.found:
                self.say(f'    {name}, --target {target}, at {clock}: {one.load:.3g} %'
                         + (', within the load' if one.load <= self.load else ''))

    def without(self, effect, methods):
        """The cheapest method without this effect, and how far its removal moves the outputs."""
        left_out = '; '.join(filter(None, (self.options.without, effect)))
        options = argparse.Namespace(**{**vars(self.options), 'without': left_out, 'write': False})
        said = []
        try:
            other = Choice(options, self.machine, self.folder / f'without-{effect}', said.append)
            best = other.chosen(methods)
        except (Wrong, Refused):
            return 'it cannot be left out for this bound'
        if best is None:
            return 'none either'
        bounds = self.motions.bounds
        moved = ', '.join(f'{bound.output} by {bound.told(of.max())}' for bound, of in
                          zip(bounds, errors_of(self.motions.exact, other.motions.exact, bounds)))
        return f'{other.take(best)}; but that changes {moved}'

    def chosen(self, methods):
        """Tells what is found of the methods; the cheapest that keeps every bound within the load, or None."""
        self.say(f'{self.options.scene} on the {self.machine.board} at {self.machine.hz / 1e6:g} MHz: '
                 f'{self.options.error} over {self.motions.seconds(self.motions.rows)} s, load at most {self.load:g} %')
        with build.progress('computes the exact motion'):
            self.motions.judge(self.say)
        self.search(methods, self.limit)
        for line in self.table():
            self.say(line)
        best = self.cheapest(self.load)
        if best:
            self.statements = self.advise(best)
        return best


def asked_bounds(text):
    """The (value, output) of each bound in the text."""
    if not text:
        raise Wrong('--error is missing: how large the error may be, of which output; it could be '
                    "--error '1 mm of tip'")
    asked = []
    for part in map(str.strip, text.rstrip('; ').split(';')):
        match = re.fullmatch(rf'({NUMBER}\s*\S*.*) of ([A-Za-z_]\w*)', part)
        if not match:
            raise Wrong(f"--error: '{part}' is no bound; it could be '1 mm of tip', or several: "
                        "'1 mm of tip; 0.1 deg of theta'")
        if float(re.match(NUMBER, part)[0]) <= 0:
            raise Wrong(f"--error: '{part}' is no bound: it must be greater than 0")
        asked.append(match.groups())
    return asked


def number_of(load):
    match = re.fullmatch(r' *(\d+\.?\d*|\.\d+) *%? *', load)
    if not match or not 0 < float(match[1]) <= 100:
        raise Wrong(f'--load {load} is no load; it could be 50%, above 0 and up to 100%')
    return float(match[1])


def costs_of_methods():
    """The order and the evaluations of a step of each method; adams has none that are fixed."""
    printed = subprocess.run([build.tools('isoc'), '--methods'], capture_output=True, text=True, check=True).stdout
    rows = [[cell.strip() for cell in line.split('|')[1:]] for line in printed.splitlines() if line.startswith('|')]
    return {row[0]: [int(cell) for cell in row[1:3] if cell.isdigit()] for row in rows[2:]}


def time_of(ns):
    for unit, size in ('s', 1e9), ('ms', 1e6), ('us', 1e3):
        if ns >= size:
            return f'{ns / size:.3g} {unit}'
    return f'{ns:.0f} ns'


def named(one, choice):
    """As `rk4 at 4 ms`."""
    step = step_of(choice.motions.period * one.k)
    if one.method.startswith('adams-'):
        return f'adams at {step} in up to {one.n} sub-step{"s" if one.n > 1 else ""}, tolerance {one.method[6:]}'
    sub_steps = f' in {one.n} sub-steps' if one.n > 1 else ''
    return f'{one.method} at {step}{sub_steps}' + (', compensated' if one.compensated else '')


def dearest(motions, text, method, ns, target, core, **choices):
    """The cycles of the dearest tick of a plant, with the interrupt; a Wrong says why they are not known."""
    folder = motions.folder / f'count-{method}-{ns}-{threading.get_ident()}'
    folder.mkdir(parents=True, exist_ok=True)
    scene = folder / f'{motions.name}.scene'
    scene.write_text(text)
    try:
        with ONE_BUILDS:
            plant = build.plant(scene, folder=folder, quiet=True, target=target, method=method, step=f'{ns}ns',
                                **choices)
        parts = max((tick.parts for tick in ticks_of(plant, core)[0]), key=lambda parts: parts['tick'][2])
    except Wrong as wrong:
        if re.search('region .* overflowed|will not fit|relocation truncated', str(wrong)):
            raise Wrong('the program does not fit into the memory')
        raise Wrong(str(wrong).splitlines()[-1].removeprefix('cycles: '))
    return round(parts['tick'][2] + parts['interrupt'][2])


def run(options):
    scene = pathlib.Path(options.scene)
    if options.recorded and not pathlib.Path(options.recorded).is_file():
        raise Wrong(f'--recorded {options.recorded}: there is no such file')
    if options.recorded and options.inputs == 'smooth':
        raise Wrong('--inputs smooth has no effect with --recorded: between the lines of a file there is no signal')
    of = machine(options.target, options.core or '', options.board or '', options.clock or '')
    methods = options.methods.split() if options.methods else list(costs_of_methods())
    choice = Choice(options, of, build.outputs('choose', scene))
    best = choice.chosen(methods)
    if best:
        choice.decides(best)
        if options.write:
            choice.keep(choice.statements)
        print(f'take: {choice.take(best)}')
        return 0
    if not any(one.found for one in choice.candidates) and any(one.unpriced for one in choice.candidates):
        print(f'none: of no method that keeps {options.error} the cycles are known')
        return 1
    choice.ways_out([method for method in OF_ANOTHER_CHIP if method in methods] or methods)
    print(f'none: no method keeps {options.error} within {choice.load:g} % of the chip')
    return 1
