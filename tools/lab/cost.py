"""`isochron cost`: what each effect of a scene costs and changes (lab/price.py); without a scene tables of costs on the
Cortex-M4F in float, by parts:

    models    states, operations, instructions and bytes of each model
    methods   instructions of a step with each method
    restarts  instructions of the longest step, which is one with a restart
    effects   the cost that each effect of tools/measure/effects.txt adds to the pendulum
    library   the cost that each effect of models/effects adds, in a scene of tools/measure/library.txt
"""
import re

from lab import build, price, table
from lab.counts import Counts
from lab.forced import forced
from lab.scene import elsewhere

MEASURE = build.ROOT / 'tools/measure'
MODELS = ['pendulum', 'double_pendulum', 'cart_pole', 'arm6', 'tree']
LOOPS = ['four_bar', 'squeezer']
MACHINES = ['dc_motor_bench', 'cart_pole_drive', 'arm_drive', 'quarter_car', 'crane', 'balancer', 'hopper',
            'quadrotor_sih']
PENDULUM = build.ROOT / 'models/pendulum.scene'


def path_of(model):
    return build.ROOT / f'models/{model}.scene'


def signed(less, more):
    return [f'{b - a:+d}' for a, b in zip(less, more)]


def models(_):
    def row(name):
        # The squeezer's step is longer than its tick of 10 us, so it runs with a longer tick, and only for some of
        # them: its motion is then far from the true one, and would soon be out of range. No count depends on it.
        how = {'step': '500us', 'seconds': 0.01} if name == 'squeezer' else {}
        once = Counts(f'{name}-euler', path_of(name), 'euler', **how)
        of = Counts(f'{name}-rk4', path_of(name), 'rk4', **how)
        sizes = of.sizes
        return [name, of.states, *of.operations, once.step, of.step, sizes.step_text, sizes.plant_memory, of.stack]
    table.show(['model', 'states', 'add', 'mul', 'div', 'sincos', 'euler', 'rk4', 'text', 'memory', 'stack'],
               map(row, table.due(MODELS + LOOPS + MACHINES)))


def methods(methods):
    table.show(['instructions of a step', *methods],
               ([name, *(Counts(f'{name}-{method}', path_of(name), method).step for method in methods)]
                for name in table.due(MODELS)))


def longest_step(folder, scene, method, cause, *statements):
    """The instructions of the longest step of a run in which every second tick has a discontinuity that is `announced`
    or `detected`. The run of adams has a tolerance that cannot be met as well: it restarts, then tries all of its
    sub-steps and rejects none. A rejected sub-step has no correction, which is the longest part of one; the restart
    within the tick, or the half step, that it has instead is shorter. How often order and step change depends on the
    motion: that adds less than a sub-step (tests/tools/lab/test_restarts.py)."""
    if method == 'adams' and not any('tolerance' in statement for statement in statements):
        statements = 'tolerance 1e-30', *statements
    elif method != 'adams' and cause == 'detected':
        statements = 'checked yes', *statements
    text = re.sub(r'^method .*\n', '', elsewhere(scene), flags=re.M)
    text += '\n'.join([f'method {method}', 'tunable forced = 1', *statements]) + '\n'
    return Counts(folder, text, change=lambda plant: forced(plant, cause), seconds=2).longest_step


def restarts(_):
    methods = ['ab4', 'abm4', 'abm4_pec', 'abm4_pecece', 'bdf4', 'adams']

    def row(name, cause):
        return [f'{name}, {cause}', *('-' if (method, cause) == ('adams', 'detected') else
                                      longest_step(f'{name}-{method}-{cause}', path_of(name), method, cause)
                                      for method in methods)]
    table.show(['instructions of the longest step', *methods],
               (row(name, cause) for name, cause in table.due([(name, cause) for name in MODELS
                                                               for cause in ('announced', 'detected')])))


def with_effect(scene, inside, statement):
    """A scene with one effect more: a text in its first joint, and a statement."""
    text, places = re.subn(r'^(joint .*?^ *axis.*?\n)', lambda joint: joint[1] + (inside and f'    {inside}\n'), scene,
                           count=1, flags=re.M | re.S)
    if not places:
        raise build.Wrong('the scene has no joint with an axis')
    return text + (statement and statement + '\n')


def listed_effects():
    """The name, the text in a joint and the statement of each."""
    return table.read(MEASURE / 'effects.txt', '|')


def effects(_):
    def cost(of):
        return of.step, of.tick, of.sizes.text, of.sizes.plant_memory
    without = cost(Counts('pendulum-rk4', PENDULUM, 'rk4'))
    table.show(['effect on the pendulum', 'instructions of a step', 'of a tick', 'bytes of text', 'of memory'],
               ([name, *signed(without, cost(Counts('effects/' + re.sub('[^a-z]+', '-', name),
                                                    with_effect(PENDULUM.read_text(), inside, statement), 'rk4')))]
                for name, inside, statement in table.due(listed_effects())))


def told(kind):
    """The description of an effect in its file, as cells: the first sentence of its comment, and its operands; in
    brackets those with a default."""
    text = (build.ROOT / f'models/effects/{kind}.scene').read_text()
    comment = ''.join(line[1:] for line in text.splitlines() if line.startswith('#'))
    operands = []
    for line in text.splitlines():
        for part in line.partition('#')[0].split(';') if line.startswith(' ') else []:
            words = part.split()
            if len(words) > 1 and words[0] in ('joint', 'body', 'signal', 'value', 'fault'):
                name = ('fault ' if words[0] == 'fault' else '') + f'`{words[1]}`'
                operands.append(f'[{name}]' if '=' in part else name)
    return re.split(r'[.:](?: |$)', comment.strip())[0], ', '.join(operands)


def library(_):
    rows = table.read(MEASURE / 'library.txt', '|')
    bases = {row[1]: row[2:] for row in rows if row[0] == 'base'}
    counted = {}

    def count(folder, base, signal, statements):
        without_signal, statements_of_base = bases[base]
        of_base = statements_of_base.replace('SIGNAL', signal or without_signal)
        text = f'{PENDULUM.read_text()}{of_base}\n{statements}\n'
        of = Counts(f'library/{folder}', text, 'rk4')
        return of.step, of.tick - of.step

    def row(kind, base, signal, statements):
        if base not in counted:
            counted[base] = count(base, base, '', '')
        return [f'`{kind}`', *told(kind), *signed(counted[base], count(f'of-{kind}', base, signal, statements))]
    table.show(['effect', 'what it is', 'operands', 'step', 'rest of the tick'],
               (row(*cells) for cells in table.due(cells for cells in rows if cells[0] != 'base')), 'lllrr')


def run(options):
    if options.scene:
        if options.parts or options.methods:
            raise build.Wrong('--parts and --methods have no effect on a scene; they are of `cost` without one')
        return price.run(options)
    if (options.target, options.real or 'float') != ('cortex-m4f', 'float'):
        raise build.Wrong('cost without a scene is of the cortex-m4f in float; --target and --real cannot be others')
    parts = {'models': models, 'methods': methods, 'restarts': restarts, 'effects': effects, 'library': library}
    asked = (options.parts or 'models methods restarts effects').split()
    chosen = options.methods.split() if options.methods else build.methods()[:-1]
    for part in asked:
        if part not in parts:
            raise build.Wrong(f'--parts {part} is unknown; it can be: {" ".join(parts)}')
        if part != asked[0]:
            print()
        parts[part](chosen)
