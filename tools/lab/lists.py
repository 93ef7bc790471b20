"""isochron targets, methods and effects: what there is to choose from."""
import difflib
import re

from . import build, table

EFFECTS = build.ROOT / 'models/effects'


def targets(options):
    """Each target with the sentence that begins its port.mk, and what the port has."""
    for name in build.targets():
        print(f'{name:12} {sentence(build.ROOT / "port" / name / "port.mk")}')
        print(f'{"":12} {"; ".join(parts(build.port(name)))}')


def parts(port):
    """What a port has: number types, channels, kinds of pins, and whether a program can be flashed."""
    reals = (port.reals or 'float double').split()
    channels = int(port.channels or (2 if port.channel else 0))
    return [' and '.join(reals), f'{channels or "no"} channel{"s" * (channels != 1)}',
            *([f'pins: {port.pins}'] if port.pins else []), *(['flash'] if port.flash else [])]


def methods(options):
    print(build.call([build.tools('isoc'), '--methods']), end='')


def effects(options):
    """All kinds, or the definition of one: its operands with their units, its equations, and its price."""
    kinds = {path.stem: path for path in sorted(EFFECTS.glob('*.scene'))}
    if not options.words:
        for kind, path in kinds.items():
            print(f'{kind:14} {sentence(path)}')
        return
    kind = options.words[0]
    if kind not in kinds:
        near = difflib.get_close_matches(kind, kinds, 1)
        raise build.Wrong(f'there is no effect {kind}' + (f' (did you mean {near[0]}?)' if near else '') +
                          '; `isochron effects` lists them')
    print(kinds[kind].read_text(), end='')
    print()
    table.show(['', 'name', 'unit'], described(kinds[kind]), 'lll')
    print()
    print(price(kind))


def described(path):
    """The operands, states, memories, faults and outputs of a definition, as isoc finds them with operands that have no
    unit as plain numbers; no rows where it does not fit those."""
    try:
        lines = build.call([build.tools('isoc'), path, '--check']).splitlines()
    except build.Wrong:
        return []
    return [(line.split(' ', 2) + [''])[:3] for line in lines[1:]]


def sentence(path):
    """The first sentence of the comment that a file begins with."""
    comment = re.match(r'(#.*\n)+', path.read_text())
    text = ' '.join(line.lstrip('# ') for line in comment[0].splitlines()) if comment else ''
    return re.split(r'(?<=[.;:]) ', text)[0].rstrip('.:;')


def price(kind):
    """What the table of all effects says that this one adds, in words."""
    for line in (build.ROOT / 'models/README.md').read_text().splitlines():
        cells = [cell.strip() for cell in line.strip('|').split('|')]
        if cells[0] == f'`{kind}`':
            return f'# price, with rk4 on the Cortex-M4F: {cells[-2]} instructions of a step, {cells[-1]} of the rest of a tick'
    return '# price: isochron cost prints it for a scene'
