"""Orders of events against exact ones: the mean error over the run, over a factor of 16 in the step, with a fit, since a
single halving scatters by the place of the events in their steps."""
import math

import numpy as np
import pytest

import linkage
from exact import Event, Run

LOAD = 'body load { mass 1 kg }\njoint rail prismatic { parent ground; child load; axis x }\n'


def ball():
    """A ball with linear drag falls on the ground: drag by the square of the speed has a kink where it turns."""
    scene = '''gravity (0, 0, -9.81) m/s^2
body ball { mass 1 kg }
joint fall prismatic { parent ground; child ball; axis z; start 1 m }
effect drag { joint along; effort on along = -0.4 N*s/m * speed of along }
effect air drag { along fall }
when position of fall < 0 m { set speed of fall = -0.8 * speed of fall }
output z = position of fall
output v = speed of fall'''
    return scene, ['z', 'v'], Run(lambda x: [x[1], -9.81 - 0.4 * x[1]],
                                  [Event(lambda x: x[0], lambda x: [x[0], -0.8 * x[1]])], [1, 0], 2.5e-4), 2.56


def pendulum():
    """A pendulum of 1 m swings against a wall."""
    scene = '''gravity (0, -9.81, 0) m/s^2
body bob { mass 1 kg; com (0, -1, 0) m }
joint pivot revolute { parent ground; child bob; axis z; start 1.2 rad }
when position of pivot < -0.3 rad { set speed of pivot = -0.7 * speed of pivot }
output z = position of pivot
output v = speed of pivot'''
    return scene, ['z', 'v'], Run(lambda x: [x[1], -9.81 * math.sin(x[0])],
                                  [Event(lambda x: x[0] + 0.3, lambda x: [x[0], -0.7 * x[1]])], [1.2, 0], 2.5e-4), 2.56


def reset():
    """A leaking integrator that sets itself back at 1, with a sine that two states make."""
    scene = LOAD + '''effect fire {
    state x = 0
    state sine = 0
    state cosine = 1
    mode n = 0
    rate sine = 20 1/s * cosine
    rate cosine = -20 1/s * sine
    rate x = 30 1/s - x / 50 ms + 5 1/s * sine
    when x > 1 { set x = 0.3; set n = n + 1 }
    output x; output n
}
effect f fire { }
output x = f.x
output n = f.n'''
    rates = lambda x: [30 - x[0] / 0.05 + 5 * x[1], 20 * x[2], -20 * x[1], 0]
    return scene, ['x'], Run(rates, [Event(lambda x: 1 - x[0], lambda x: [0.3, x[1], x[2], x[3] + 1], True)],
                             [0, 0, 1, 0], 1e-4), 0.32


def relay():
    """A relay with hysteresis holds a body warm."""
    scene = LOAD + '''mode on = 1
effect heater {
    signal on
    state warm K = 0 K
    rate warm = (on * 40 K - warm) / 1 s
    output warm
}
effect body heater { on on }
when body.warm > 21 K and on == 1 { set on = 0 }
when body.warm < 19 K and on == 0 { set on = 1 }
output x = body.warm
output on = on'''
    rates = lambda x: [40 * x[1] - x[0], 0]
    functions = [lambda x: max(21 - x[0], abs(x[1] - 1) - 0.5), lambda x: max(x[0] - 19, abs(x[1]) - 0.5)]
    return scene, ['x'], Run(rates, [Event(functions[0], lambda x: [x[0], 0], True),
                                     Event(functions[1], lambda x: [x[0], 1], True)], [0, 1], 2e-3), 2.56


def thyristor():
    """A thyristor, fired at 60 degrees of 325 V at 50 Hz, feeds 10 Ohm and 20 mH; it blocks where the current ends."""
    scene = LOAD + '''effect thyristor {
    state i A = 0 A
    state phase = 0
    mode on = 0
    let volts = 325 V * sin(phase)
    rate phase = 2 * pi * 50 1/s
    rate i = if(on == 1, (volts - 10 Ohm * i) / 20 mH, 0 A/s)
    when phase > pi / 3 and phase < pi and on == 0 { set on = 1 }
    when i < 0 A { set on = 0; set i = 0 A }
    when phase > 2 * pi { set phase = phase - 2 * pi }
    output i
}
effect t thyristor { }
output i = t.i'''
    def rates(x):
        return [(325 * math.sin(x[1]) - 10 * x[0]) / 0.02 if x[2] == 1 else 0.0, 100 * math.pi, 0]

    def fire(x):
        return max(math.pi / 3 - x[1], x[1] - math.pi, abs(x[2]) - 0.5)
    return scene, ['i'], Run(rates, [Event(fire, lambda x: [x[0], x[1], 1], True),
                                     Event(lambda x: x[0], lambda x: [0, x[1], 0], True),
                                     Event(lambda x: 2 * math.pi - x[1], lambda x: [x[0], x[1] - 2 * math.pi, x[2]], True)],
                             [0, 0, 0], 1e-5), 0.064


def four_bar():
    """A four-bar swings against a wall, which takes its crank, a joint beside the closure."""
    scene = linkage.scene('start 60 deg; speed 0 rad/s') + """
when position of a < -20 deg { set speed of a = -0.8 * speed of a }
output q = position of a
output v = speed of a"""
    start = math.radians(60)
    rates = lambda x: [x[1], linkage.effort(x[0], x[1]) / linkage.inertia(x[0])]
    return scene, ['q', 'v'], Run(rates, [Event(lambda x: x[0] + math.radians(20), lambda x: [x[0], -0.8 * x[1]])],
                                  [start, 0.0], 5e-4), 1.92


CASES = {case.__name__: case for case in (ball, pendulum, reset, relay, thyristor, four_bar)}
COUNTS = {'ball': 64, 'pendulum': 128, 'reset': 64, 'relay': 64, 'thyristor': 320, 'four_bar': 128}
LOOKS = 16  # rows that all steps have
EXACT = {}


def exact(name):
    if name not in EXACT:
        scene, outputs, run, end = CASES[name]()
        truth = np.array([run.until(end * k / LOOKS)[:len(outputs)] for k in range(1, LOOKS + 1)])
        EXACT[name] = scene, outputs, truth, end, run.fired
    return EXACT[name]


def errors(plant, name, method, rest, counts, change=None):
    """The root of the mean square of the error in the rows of LOOKS, for each number of steps."""
    scene, outputs, truth, end, _ = exact(name)
    result = []
    for count in counts:
        text = f'step {end / count * 1e9:.0f} ns\nmethod {method}\nevents 1 rest {rest}\n{scene}\n'
        rows = plant(text, change=change).outputs(count, every=count // LOOKS)
        ours = np.stack([getattr(rows, output)[1:] for output in outputs], axis=1)
        result.append(np.sqrt(np.mean((ours - truth) ** 2)))
    return result


def order(counts, found):
    return -np.polyfit(np.log(counts), np.log(np.maximum(found, 1e-15)), 1)[0]


@pytest.mark.parametrize('name', CASES)
@pytest.mark.parametrize('method, rest, least', [('rk4', 'rk4', 3.6), ('rk4', 'heun', 2.4), ('heun', 'heun', 1.8)])
def test_orders(plant, name, method, rest, least):
    counts = [COUNTS[name] * 2 ** k for k in range(5)]
    found = errors(plant, name, method, rest, counts)
    print(name, method, rest, ' '.join(f'{e:.1e}' for e in found), f'{order(counts, found):.2f}')
    assert order(counts, found) > least
