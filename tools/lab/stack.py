"""`isochron stack`: the deepest stack of a step and of all that it calls, in bytes, from the call graph that gcc writes
with -fcallgraph-info=su. There is no bound with recursion, a call through a pointer, a frame that grows at run time, or
a function whose frame is not known."""
import collections
import os
import re

from lab import build
from lab.build import Wrong

NODE = re.compile(r'^node: { title: "([^"]*)" label: "([^"]*)"')
EDGE = re.compile(r'^edge: { sourcename: "([^"]*)" targetname: "([^"]*)"')
FRAME = re.compile(r'(\d+) bytes \(([^)]*)\)')


def short(name):
    """A name without the file that gcc writes before it."""
    return name.rpartition(':')[2]


def read(graph):
    """Of the text of a .ci: the frames of functions, (bytes, 'static' or 'dynamic'), and what each calls."""
    frames, calls = {}, {}
    for line in graph.splitlines():
        if node := NODE.match(line):
            if frame := FRAME.search(node[2]):
                frames[node[1]] = int(frame[1]), frame[2]
        elif edge := EDGE.match(line):
            calls.setdefault(edge[1], []).append(edge[2])
    return frames, calls


def deepest(frames, calls, function):
    """The path to the deepest stack of a function: (bytes, name) of each."""
    known = {}

    def path(name, above):
        if name == '__indirect_call':
            raise Wrong('stack: a call through a pointer')
        if name not in frames:
            raise Wrong(f'stack: the frame of {short(name)} is not known')
        if name in above:
            raise Wrong(f'stack: recursion through {short(name)}')
        if frames[name][1] == 'dynamic':
            raise Wrong(f'stack: the frame of {short(name)} grows at run time')
        if name not in known:
            paths = [path(called, above | {name}) for called in calls.get(name, [])]
            below = max(paths, key=depth, default=[])
            known[name] = [(frames[name][0], short(name))] + (below if depth(below) > 0 else [])
        return known[name]

    for name in frames:
        if short(name) == function:
            return path(name, frozenset())
    raise Wrong(f'stack: there is no function {function}')


def depth(path):
    return sum(size for size, _ in path)


def frames_of_avr(listing):
    """The frames and calls of `avr-objdump -d`: for a compiler that writes no call graph. A frame is the pushed bytes,
    the move of the stack pointer before it is set, and the return address, of 2 bytes. A called function is found by
    its address: symbols may share a value."""
    size, at, called, name, is_set = collections.Counter(), {}, collections.defaultdict(dict), '', False
    for line in listing.splitlines():
        if label := re.match(r'0*([0-9a-f]+) <([^.].*)>:$', line):
            name, is_set = label[2], False
            at[label[1]], size[name] = name, 2
            continue
        words = line.split('\t')
        code, operands = (words[2].strip(), words[3:]) if len(words) > 2 else ('', [])
        last = line.split()[-1] if line.split() else ''
        if code == 'push':
            size[name] += 1
        elif code == 'rcall' and operands and operands[0].startswith('.+0 '):
            size[name] += 2
        elif code in ('sbiw', 'subi') and operands[0].startswith('r28, ') and not is_set:
            size[name] += number(last)
        elif code == 'sbci' and operands[0].startswith('r29, ') and not is_set:
            size[name] += 256 * number(last)
        elif code == 'out' and operands[0].startswith('0x3d, '):
            is_set = True
        elif code in ('icall', 'ijmp'):
            called[name]['__indirect_call'] = True
        elif code in ('call', 'rcall', 'jmp', 'rjmp'):
            called[name]['at ' + line.split()[-2].removeprefix('0x')] = True
    frames = {name: (bytes_, 'static') for name, bytes_ in size.items()}
    calls = {}
    for name, targets in called.items():
        for target in targets:
            to = at.get(target.removeprefix('at ')) if target.startswith('at ') else target
            if to and to != name:
                calls.setdefault(name, []).append(to)
    return frames, calls


def number(text):
    return int(text) if text.isdigit() else 0


def of_plant(plant):
    """The path to the deepest stack of the step of a plant."""
    port = plant.port
    if port.frames:
        return deepest(*frames_of_avr(build.call([*port.frames.split(), plant.program])), 'step')
    # The functions that compute with float are the port's, where the processor has no unit for it.
    soft = [build.ROOT / path for path in port.shared.split() if path.startswith('port/soft/')]
    flags = build.plant_flags(plant.words) if plant.is_in_c else []
    folder = plant.folder / 'stack'
    folder.mkdir(exist_ok=True)
    graph = ''
    for source in *soft, *plant.folder.glob('*.c'):
        made = folder / f'{source.stem}.o'
        # ccache keeps objects, and no call graphs.
        build.call([*port.compile, *flags, '-fcallgraph-info=su', *port.stack.split(), '-c', source.absolute(),
                    '-o', made.absolute()], cwd=build.ROOT, env={**os.environ, 'CCACHE_DISABLE': 'yes'})
        graph += made.with_suffix('.ci').read_text()
    return deepest(*read(graph), 'step')


def run(options):
    plant = build.plant(options, 'none')
    path = of_plant(build.plant(options) if plant.port.frames else plant)
    for size, name in path:
        print(f'{size:6d} {name}')
    print('stack_of_step', depth(path))
