"""`isochron bench`: the methods at equal step and at equal error, as a Markdown table, with answers; with inputs that
keep their values, and for a scene with inputs in a loop, where they change at every tick. All files are in
build/bench/NAME/. """
import math

from lab import build, table
from lab.methods import Subject, error_of, known_methods

MOST = 1e-6 # the error
SAID = '1e-6'


class Search:
    """Looks with a program of a kind and a method for steps with which the error at the end is at most MOST. `words`
    are those of drive before the time."""

    def __init__(self, subject, reference, kind, method, *words):
        self.subject, self.reference, self.of, self.words = subject, reference, (kind, method), words

    def errors(self, *numbers):
        """(steps, error with four digits) of numbers of steps, or of tolerances."""
        lines = self.subject.run(*self.of, *self.words, self.subject.time, *numbers)
        return [(int(line[0]), float(f'{error_of(self.reference, self.subject.time, line[2:]):.3e}')) for line in lines]

    def error(self, steps):
        return self.errors(steps)[0][1]

    def told(self):
        """The errors at steps of twice the scene's and at the scene's, and the fewest steps from which on the error
        stays small enough, or None if that takes steps shorter than 1 us."""
        coarsest = self.subject.coarsest
        return self.error(2 * coarsest), self.error(4 * coarsest), self.fewest()

    def fewest(self):
        """Doubles the steps until the error is far below, goes back over a grid of sixteen to a doubling to the first
        that is small enough, and halves the interval before it."""
        shortest = int(float(self.subject.time) * 1e6)
        steps = self.subject.coarsest
        while not self.error(steps) <= MOST / 16 and steps < shortest:
            steps = min(2 * steps, shortest)
        grid, at = [], max(1, steps // 256)
        while at < steps:
            grid.append(int(at))
            at = max(at * 2 ** (1 / 16), at + 1)
        found = self.errors(*grid, steps)
        first = first_within(found)
        if first == len(found):
            return None
        few, enough = found[first - 1][0] if first else 0, found[first][0]
        while enough - few > 1:
            middle = (few + enough) // 2
            if self.error(middle) <= MOST:
                enough = middle
            else:
                few = middle
        return enough

    def loosest(self):
        """Of adams: the steps with the largest tolerance from which on the error stays small enough, and that
        tolerance, over a grid, four to a doubling; or None."""
        tolerances, at = [], 1e-2
        while at > 1e-13:
            tolerances.append(f'{at:.3g}')
            at /= 2 ** (1 / 4)
        found = self.errors(*tolerances)
        first = first_within(found)
        return (found[first][0], tolerances[first]) if first < len(found) else None


def first_within(found):
    """The first from which on all errors are small enough; so many as there are if there is none."""
    first = len(found)
    while first and found[first - 1][1] <= MOST:
        first -= 1
    return first


def run(options):
    subject = Subject('bench', build.outputs('bench', options.scene, options), options)
    subject.instructions_m4f('float', 'rk4') # so that those that are made at once find the objects that they share
    found = subject.each(lambda kind, method: measured(subject, kind, method), [('double', m) for m in subject.methods])
    said = subject.each(lambda kind, method: counted(subject, method, found['double', method]),
                        [('float', m) for m in subject.methods])
    costs = show(subject, {m: found['double', m] for m in subject.methods},
                 {m: said['float', m] for m in subject.methods})
    if not costs:
        raise build.Wrong(f'no method has an error of {SAID}')
    if subject.inputs:
        show_loop(subject, {m: said['float', m][0] for m in subject.methods})


def measured(subject, kind, method):
    """(error, error, steps) of a method of fixed steps, (steps, tolerance) or None of adams."""
    search = Search(subject, subject.reference([subject.time]), kind, method)
    return search.loosest() if method == 'adams' else search.told()


def counted(subject, method, found):
    """Instructions of a step in float on the Cortex-M4F; of adams at the tolerance that was found, and evaluations of a
    sub-step. Below 1e-8 rounding in float would be taken for an error, and steps for too large: sub-steps are measured
    at 1e-8."""
    tolerance = found[1] if method == 'adams' and found and float(found[1]) > 1e-8 else '1e-08'
    cost, said = subject.instructions_m4f('float', method, tolerance)
    return int(cost), int(said['evaluations']) / int(said['substeps']) if 'substeps' in said else None


def show(subject, found, said):
    """The table and the answers; returns the instructions in a second at equal error."""
    time, known = float(subject.time), known_methods()
    longest, costs = {}, {}

    def row(method):
        order, evaluations, jacobians = known[method][:3]
        two, one, steps = ('-', '-', found[method] and found[method][0]) if method == 'adams' else found[method]
        instructions, of_substep = said[method]
        text = f'{of_substep:.2f}' if of_substep else evaluations + (' and a Jacobian' if int(jacobians) else '')
        if steps:
            longest[method] = time / steps
            costs[method] = instructions / longest[method]
        errors = [error if error == '-' else f'{error:.2e}' for error in (two, one)]
        at_equal = ['below 0.001', instructions, '-']
        if steps:
            at_equal = [f'{1000 * longest[method]:.3g}', instructions, f'{costs[method]:.0f}']
        return [method, order, text, *errors, *at_equal]

    table.show(['method', 'order', 'evaluations', f'error, {2000 * subject.step:g} ms',
                f'error, {1000 * subject.step:g} ms',
                f'step for {SAID}, ms', 'instructions', f'per second for {SAID}'], map(row, subject.methods))

    def answer(subject_of_it, ratio, question, is_so):
        print(f"- {subject_of_it} {ratio:.2f} {question}: {'yes' if is_so else 'no'}.")

    if not costs:
        return costs
    print()
    if 'abm4' in longest and 'ab4' in longest:
        ratio = longest['abm4'] / longest['ab4']
        answer('abm4 (PECE) has', ratio, 'times the step of ab4 at equal error. More than twice', ratio > 2)
    for a, b, subject_of_it, question in (
            ('abm4', 'ab4', 'abm4 needs', 'times the instructions of ab4 at equal error. Fewer'),
            ('abm4_pec', 'abm4', 'abm4_pec, without the last evaluation, needs', 'times those of abm4. Fewer'),
            ('abm4_pecece', 'abm4', 'abm4_pecece, with a second correction, needs', 'times those of abm4. Fewer'),
            ('ab4', 'rk4', 'ab4, with one evaluation instead of four, needs', 'times the instructions of rk4. Fewer'),
            ('adams', 'abm4', 'adams, which varies step and order, needs', 'times those of abm4. Fewer')):
        if a in costs and b in costs:
            answer(subject_of_it, costs[a] / costs[b], question, costs[a] < costs[b])
    if 'bdf4' in said and 'rk4' in said:
        ratio = said['bdf4'][0] / said['rk4'][0]
        answer('A step of bdf4 has', ratio, 'times the instructions of a step of rk4. At most three times', ratio <= 3)
    print(f'- The fewest instructions for an error of {SAID}: {min(costs, key=costs.get)}.')
    return costs


def show_loop(subject, held_costs):
    """In a loop, whose ticks are the scene's step: the errors with one step a tick and the fewest steps from which on
    the error is small enough: with held inputs against the staircase, with as many steps in every tick; with smooth
    ones, sampled at every step, against the continuous signal."""
    restarted, smooth = subject.loop_references()
    if subject.unlike:
        subject.fail(subject.unlike)
    jobs = [(kind, method) for kind in ('double', 'smooth') if kind == 'double' or smooth for method in subject.fixed]
    found = subject.each(lambda kind, method: Search(subject, smooth if kind == 'smooth' else restarted, kind, method,
                                                     'smooth' if kind == 'smooth' else 'held').told(), jobs)
    said = subject.each(subject.instructions_m4f, [('smooth_float', method) for method in subject.fixed])
    step, time = 1000 * subject.step, float(subject.time)
    ticks = int(time / subject.step + 0.5)
    errors, costs = {}, {}

    def cells(reading, method, instructions):
        one, steps = found.get(('double' if reading == 'held' else 'smooth', method), (None, None, None))[1:]
        if reading == 'held' and steps:
            steps = ticks * math.ceil(steps / ticks)
        if one is not None:
            errors[reading, method] = one
        if steps:
            costs[reading, method] = instructions * steps / time
        of_tick = '-'
        if steps:
            of_tick = f'{steps * subject.step / time if reading == "held" else 1000 * time / steps:.3g}'
        return ['-' if one is None else f'{one:.2e}', of_tick, instructions,
                f'{costs[reading, method]:.0f}' if steps else '-']

    print()
    table.show(['method', f'held: error, {step:g} ms', f'steps a tick for {SAID}', 'instructions', 'per second',
                f'smooth: error, {step:g} ms', f'step for {SAID}, ms', 'instructions', 'per second'],
               ([method, *cells('held', method, held_costs[method]),
                 *cells('smooth', method, int(said['smooth_float', method][0]))]
                for method in subject.fixed))
    print()
    for reading in 'held', 'smooth':
        for of, text in ((errors, 'the least error with one step a tick'),
                         (costs, f'the fewest instructions for an error of {SAID}')):
            best = min((key for key in of if key[0] == reading), key=of.get, default=None)
            if best:
                print(f'- Inputs {reading}: {text}: {best[1]}.')
