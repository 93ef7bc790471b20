"""`isochron cycles`: the cycles of the dearest tick of a plant on a board, by published timings, and whether it
fits."""
import math
import os
import pathlib
import re
import subprocess
import types

from lab import build, size, table
from lab.build import Wrong
from lab.forced import forced, with_text
from lab.machine import machine, path_of

# The parts of a tick, by the functions of each; `interrupt` is counted apart, and what is `-` not at all.
PARTS = {
    'interrupt': 'tick_interrupt,__vector_15', 'inputs': 'drive,forced,iso_port_read_float',
    'checks': 'amiss,admit,book_refused', 'step': 'step,iso_plant_attempt', 'finish': 'finish*',
    'outputs': 'iso_port_publish_float', 'tell': 'tell,iso_plant_tell', 'port': 'iso_port_wait,iso_port_clock',
    '-': 'forced_cause'}


def read(text):
    """The dearest of some ticks, as build/cycles counts it: `parts` and `kinds` with (instructions, least, most) of
    each, `simulated` cycles of the parts, where the simulator counts them, and facts by name."""
    tick = types.SimpleNamespace(parts={}, kinds={}, simulated={})
    for line in text.splitlines():
        words = line.split('\t')
        if words[0] in ('part', 'kind'):
            getattr(tick, words[0] + 's')[words[1]] = int(words[2]), float(words[3]), float(words[4])
            tick.simulated[words[1]] = int(words[5]) if words[0] == 'part' else 0
        else:
            setattr(tick, words[0], words[1])
    return tick


def cycles(least, most):
    return f'{least:.0f} to {most:.0f}' if least < most else f'{most:.0f}'


def report(scene, machine, period, sizes, ticks, path):
    """Prints the cost of the dearest of the ticks, and whether it fits; the numbers go to the file. Whether it does.
    `period` is in ns."""
    tick = max(ticks, key=lambda tick: tick.parts['tick'][2])
    hz, kept = machine.hz, []

    def parts(head, column, of, last, form):
        print(f'{head:<10}{"instructions":>14}{"cycles":>20}{column:>12}')
        for name, (count, least, most) in getattr(tick, of + 's').items():
            if of == 'part' or most > 0:
                share = f'{last(most):{form}}' + ('' if of == 'part' else ' %')
                print(f'{name:<10}{count:>14}{cycles(least, most):>20}{share}')
            kept.append([of, name, count, f'{least:.12g}', f'{most:.12g}', f'{last(most):.4g}'])

    def told(name, text):
        print(f'{name:<14}{text}')

    def fits_in(name, size, there):
        told(name, f'{size} of {there} bytes')
        kept.append([name, size, there])
        return '' if size <= there else f': too much {name}'

    print(f'{scene} on the {tick.core}, {machine.board} at {hz / 1e6:.6g} MHz\n')
    parts('part', 'us', 'part', lambda most: most / hz * 1e6, '12.2f')
    print()
    parts('the step', 'share', 'kind', lambda most: 100 * most / tick.parts['step'][2], '10.1f')
    print()
    _, least, most = map(sum, zip(tick.parts['tick'], tick.parts['interrupt']))
    told('tick', f'number {tick.number} of {tick.ticks}, the dearest of {tick.of}; their mean takes {tick.mean} cycles')
    told('load', f'{most / hz / period * 1e11:.2f} % of a step of {period / 1e6:.6g} ms')
    told('highest rate', f'{hz / most:.1f} Hz, a step of {most / hz * 1e6:.2f} us')
    kept.append(['load_percent', *(f'{n / hz / period * 1e11:.4f}' for n in (least, most))])
    kept.append(['highest_rate_hz', *(f'{hz / n:.2f}' for n in (most, least))])
    told('stack', f'{tick.stack} bytes, of which the step takes {tick.stack_of_step}')
    kept.append(['stack', tick.stack, tick.stack_of_step])
    why = '' if most / hz <= period / 1e9 else ': the tick is longer than the step'
    why += fits_in('RAM', sizes.data_bss + int(tick.stack), machine.ram)
    why += fits_in('flash', sizes.text + sizes.data, machine.flash)
    told('timings', tick.source)
    told('', tick.note)
    told('', 'no wait states, no entry of interrupts')
    told('numbers', path)
    verdict = 'does not fit' if why else 'fits'
    print(verdict + why)
    table.write(path, [*kept, ['verdict', verdict]])
    return not why


# --- What is counted -------------------------------------------------------------------------------------------------

def traced(plant, nanoseconds, words):
    """What build/cycles prints of the trace of a run of so many nanoseconds: each instruction that the simulator
    executes. Of its words, LISTING stands for that of the program."""
    port, program = plant.port, pathlib.Path(plant.program).absolute()
    port.need_runner()
    if port.tracer:
        build.tools(pathlib.Path(port.tracer).name)
    listing = program.with_name('listing')
    listing.write_text(build.call([port.objdump, '-d', program]))
    counter, command = build.tools('cycles'), [listing if word == 'LISTING' else word for word in words]
    simulator = subprocess.Popen(['sh', '-c', f'exec {port.trace}'], stdout=subprocess.PIPE, cwd=build.ROOT,
                                 env={**os.environ, 'PROGRAM': str(program), 'NANOSECONDS': str(nanoseconds)})
    try:
        with build.progress(f'counts what {plant.program} executes'):
            done = subprocess.run([counter, *command], stdin=simulator.stdout, capture_output=True, text=True)
        if done.returncode:
            raise Wrong(done.stderr.strip())
        return done.stdout
    finally:
        simulator.stdout.close()
        simulator.wait()


def period_of(plant):
    """The nanoseconds of a step."""
    return int(re.search(r'period_ns = UINT32_C\((\d+)', (plant.folder / 'plant.c').read_text())[1])


def ticks_together(plant):
    """So many ticks that all outputs of only some ticks meet, at least two: the first sets all counts, the second is
    the first with a change."""
    source = (plant.folder / 'plant.c').read_text()
    every = math.lcm(1, *map(int, re.findall(r'(?:output_every_|is_due_)(\d+)', source)))
    return 2 if every < 2 else every + 1 if every < 100 else 101


def dearest(plant, core, ticks, what='a run', period=None):
    """The dearest of so many ticks of a run."""
    parts = [f'{part}={functions}' for part, functions in PARTS.items()]
    return read(traced(plant, (period or period_of(plant)) * ticks,
                       ['tick', path_of(core), 'LISTING', 'iso_loop_tick_float', what, *parts]))


def ticks_of(plant, core):
    """The dearest tick of each of some runs: of the plant; where a tunable changes or a method has a history, also of
    one in which every second tick has such a change, and where the method watches for discontinuities, of one in which
    every second step is made again. Of adams, ticks with all sub-steps count. Then the plant of the first run."""
    source = (plant.folder / 'plant.c').read_text()
    members = re.findall(r'^    [.](discontinuity|before) = ', source, re.M)
    ticks, run = ticks_together(plant), plant
    if plant.facts['method'] == 'adams':
        # Of a plant whose tolerance no sub-step can meet. The budget is the next power of two, since so many have one
        # length.
        source = re.sub(r'^(    [.]tolerance_(?:absolute|relative) = ).*', r'\1R(1e-30),', source, flags=re.M)
        source = re.sub(r'^(    [.]budget = )(\d+).*',
                        lambda budget: f'{budget[1]}{power_of_two(int(budget[2]))},', source, flags=re.M)
        run = with_text(plant, 'dearest', source)
    found = [dearest(run, core, ticks, period=period_of(plant))]
    # A changed plant has a tick of 10 ms (lab/forced.py).
    causes = {}
    if int(plant.facts['parameters']):
        causes['changed'] = 'a run with a change of the first tunable in every second'
    elif 'discontinuity' in members:
        causes['input'] = 'a run with a discontinuity of the first input in every second'
    if 'before' in members:
        causes['detected'] = 'a run with every second step made again, after a discontinuity'
    found += [dearest(with_text(plant, cause, forced(source, cause)), core, ticks, what, 10 ** 7)
              for cause, what in causes.items()]
    return found, run


def power_of_two(n):
    """The least that is not below n."""
    return 1 << (n - 1).bit_length()


def of_plant(plant, scene, machine, path):
    """The report of a plant."""
    ticks, run = ticks_of(plant, machine.core)
    return report(scene, machine, period_of(plant), size.of_program(run), ticks, path)


def run(options):
    if not options.scene:
        return show_models(options)
    of = machine(options.target, options.core, options.board, options.clock)
    plant = build.plant(options, board=None)
    return 0 if of_plant(plant, options.scene, of, plant.folder / 'cycles.tsv') else 1


# --- The table of models ---------------------------------------------------------------------------------------------

CLOCKS = {'cortex-m4f': (84, 168), 'cortex-m3': (84, 168), 'cortex-m0': (84, 168), 'atmega1284p': (20,)}
NAMES = {'cortex-m4f': 'Cortex-M4F', 'cortex-m3': 'Cortex-M3', 'cortex-m0': 'Cortex-M0', 'atmega1284p': 'AVR'}


def percent(load):
    return f'{load:.2f} %' if load < 10 else f'{load:.1f} %' if load < 100 else f'{load:.0f} %'


def cells_of(scene, target, clocks):
    """The cycles of a model, and the load at each clock in MHz; dashes where the target has no room for the program."""
    try:
        folder = pathlib.Path('build/cost/cycles', target, scene.stem)
        plant = build.plant(scene, folder=folder, quiet=True, target=target)
    except Wrong as wrong:
        if re.search('region .* overflowed|relocation truncated|will not fit', str(wrong)):
            return ['-'] * (1 + len(clocks))
        raise
    tick = max(ticks_of(plant, machine(target).core)[0], key=lambda tick: tick.parts['tick'][2]).parts
    load = (tick['tick'][2] + tick['interrupt'][2]) / period_of(plant)
    return [f"{tick['tick'][2]:.0f}", *(percent(1e5 * load / mhz) for mhz in clocks)]


def show_models(options):
    """The cycles of the dearest tick of each model on four cores, and how much of its step that is at some clocks. With
    CORES in the environment only on these, and dots for the others (tests/tools/lab/test_cycles.py)."""
    if options.given:
        raise Wrong(f'--{min(options.given)} has no effect without a scene')
    cores = os.environ.get('CORES', ' '.join(CLOCKS)).split()

    def row(scene):
        plant = build.plant(scene, 'none', pathlib.Path('build/cost/cycles', scene.stem))
        return [scene.stem, f'{period_of(plant) / 1e6:g} ms',
                *(cell for target, clocks in CLOCKS.items()
                  for cell in (cells_of(scene, target, clocks) if target in cores else ['.'] * (1 + len(clocks))))]
    table.show(['model', 'step', *(head for target, clocks in CLOCKS.items()
                                   for head in (NAMES[target], *(f'{mhz} MHz' for mhz in clocks)))],
               map(row, table.due(sorted(build.ROOT.glob('models/*.scene')))))
