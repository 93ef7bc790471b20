"""`isochron size`: the memory that the firmware of a plant takes, and its parts."""
import os
import re
import types

from lab import build

# The functions of a step. The compiler makes copies NAME.SUFFIX of a function, and isoc parts NAME_1.
STEP = re.compile(r'(step|derivative|held_derivative|prepare|complete|derivative_prepared|hold)($|[.]|_[0-9])')
# The most bytes of the double pendulum's firmware on the Cortex-M4F in float, with its own method.
LIMITS = {'text': 8192, 'step_text': 2048, 'data_bss': 512}


def sizes(size, nm):
    """The bytes of a program, from the outputs of `size` and `nm -S`: text, data, bss; of these the stack, the trace
    buffer, and what the plant takes: its memory, step_text; and data_bss, data and bss without stack and buffer, of
    which the first is the platform's, and the second the run's."""
    lines = size.splitlines()
    of = dict(zip(('text', 'data', 'bss'), map(int, lines[1].split()[:3]))) if len(lines) > 1 else {}
    of.update(dict.fromkeys(('stack', 'trace_buffer', 'plant_memory', 'step_text'), 0))
    for line in nm.splitlines():
        words = line.split()
        if words and words[-1] == 'STACK_BYTES':
            of['stack'] = int(words[0], 16)
        if len(words) != 4:
            continue
        _, length, kind, name = words
        if name == 'trace_buffer':
            of['trace_buffer'] = int(length, 16)
        if name == 'memory' and kind in 'bB':
            of['plant_memory'] = int(length, 16)
        if kind in 'tT' and STEP.match(name):
            of['step_text'] += int(length, 16)
    if not (of.get('text') and of['step_text'] and of['trace_buffer']):
        raise build.Wrong("size: this is not the output of size and nm for a plant's program")
    of['data_bss'] = of['data'] + of['bss'] - of['stack'] - of['trace_buffer']
    return types.SimpleNamespace(**of)


def listed(of, limits={}):
    """Prints the sizes; whether all keep the limits."""
    kept = True
    for name in 'text', 'step_text', 'plant_memory', 'data_bss', 'stack', 'trace_buffer':
        size, limit = getattr(of, name), limits.get(name)
        kept = kept and not (limit and size > limit)
        print(f'{name} {size}' + (f' of at most {limit}' + (': TOO LARGE' if size > limit else '') if limit else ''))
    return kept


def of_program(plant):
    return sizes(build.call([plant.port.size, plant.program]), build.call([plant.port.nm, '-S', plant.program]))


def run(options):
    plant = build.plant(options)
    objects = [os.path.relpath(build.ROOT / path) for path in plant.port.facts['OBJECTS'].split()]
    print(build.call([plant.port.size, *plant.folder.glob('*.o'), *objects, plant.program]), end='')
    is_limited = (plant.target, plant.real, options.method or 'rk4') == ('cortex-m4f', 'float', 'rk4') and \
        build.name_of(options.scene) == 'double_pendulum'
    kept = listed(of_program(plant), LIMITS if is_limited else {})
    flags = plant.port.facts['NUMERICS'] + ' ' + plant.port.flags
    print('flags', plant.port.optimise, *(flag for flag in flags.split() if flag.startswith('-f')))
    if not kept:
        raise build.Wrong('')
