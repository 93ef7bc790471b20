"""`isochron ticks`: the cost of a tick of the loop beside the step and the equations of the plant, on the Cortex-M4F:
instructions, and the cycles that they mean, of the last of ten ticks. `loop` is core/runtime/loop.c, `checks` the
checks of inputs, states and outputs, `port` the port's clock and the wait for the tick, `tick` their sum. Equations of
the scene beside step and outputs are `signals`: functions of time and memories. `interrupt` is the timer's. Where
outputs or samples are not of each tick, or tunables are set at times, `finish` is all behind the step, the memories and
the outputs with it: in the least and in the longest of the ten ticks."""
import re

from lab import build
from lab.cycles import period_of, traced
from lab.machine import path_of

PLANT = ('step derivative held_derivative prepare complete derivative_prepared output output_prepared settle').split()
SIGNALS = 'drive advance see'.split()
PORT = 'iso_port_wait iso_port_clock iso_port_read_float iso_port_publish_float'.split()
CHECKS = 'amiss admit finish finish_on_rung'.split()
LOOP = 'iso_loop_tick_float'


def run(options):
    if (options.target, options.real or 'float') != ('cortex-m4f', 'float'):
        raise build.Wrong('ticks is of the cortex-m4f in float; --target and --real cannot be others')
    plant = build.plant(options)
    nanoseconds = 10 * period_of(plant)
    symbols = [line.split()[-1] for line in build.call([plant.port.nm, plant.program]).splitlines()]

    def count(function, *left_out, ranges=()):
        """Instructions and cycles; with `ranges` the least and the most instructions, the tick of these, and the mean."""
        lines = traced(plant, nanoseconds, ['count', *ranges, path_of('cortex-m4f'), 'LISTING', function, *left_out])
        return [int(line.split()[1]) for line in lines.splitlines()]

    its = [*PLANT, *(name for name in symbols if re.fullmatch(r'output_every_\d+', name)), 'tick_interrupt']
    whole = count(LOOP, *its)
    its += SIGNALS
    tick, no_port, loop = count(LOOP, *its), count(LOOP, *its, *PORT), count(LOOP, *its, *PORT, *CHECKS)
    parts = {'loop': loop, 'checks': less(no_port, loop), 'port': less(tick, no_port), 'tick': tick}
    if whole != tick:
        parts['signals'] = less(whole, tick)
    parts['interrupt'] = count('tick_interrupt')
    for name, (instructions, cycles) in parts.items():
        print(f'{name} {instructions} instructions {cycles} cycles')
    if finish := [name for name in ('finish_on_rung', 'finish') if name in symbols]:
        least, most = count(finish[0], ranges=['--range'])[:2]
        if least != most:
            print(f'finish {least} to {most} instructions')


def less(a, b):
    return [one - other for one, other in zip(a, b)]
