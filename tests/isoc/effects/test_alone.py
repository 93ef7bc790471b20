"""Plants without a mechanism: effects alone. A motor's thermal network, a cell and a converter against their closed forms, and
everything else that isoc makes of such a scene."""
import numpy as np
import pytest

THERMAL = '''
step 1 s
constant room = 20 degC
input copper W = 60 W
effect node {
    signal heat W
    value capacity J/K
    state temperature K = 20 degC
    rate temperature = heat / capacity
    output temperature
}
effect winding node { heat copper - 2 W/K * (winding.temperature - iron.temperature); capacity 150 J/K }
effect iron node {
    heat 2 W/K * (winding.temperature - iron.temperature) - 1.5 W/K * (iron.temperature - magnet.temperature)
        - 4 W/K * (iron.temperature - housing.temperature)
    capacity 700 J/K
}
effect magnet node { heat 1.5 W/K * (iron.temperature - magnet.temperature); capacity 90 J/K }
effect housing node {
    heat 4 W/K * (iron.temperature - housing.temperature) - 1 W/K * (housing.temperature - room); capacity 900 J/K
}
output winding = winding.temperature
output iron = iron.temperature
output magnet = magnet.temperature
output housing = housing.temperature
'''
CELL = '''
step 100 ms
input current A = 2 A
effect cell {
    signal current A
    state charge s*A = 3 Ah
    state drop V = 0 V
    rate charge = -current
    rate drop = (current * 20 mOhm - drop) / 30 s
    output voltage = table(charge / 3 Ah, 0: 3 V, 0.1: 3.4 V, 0.9: 4 V, 1: 4.2 V) - drop - current * 15 mOhm
}
effect c cell { current current }
output voltage = c.voltage
'''
BUCK = '''
step 1 us
input duty = 0.4 in 0 to 1
effect buck {
    signal duty
    state current A = 0 A
    state voltage V = 0 V
    rate current = (duty * 24 V - voltage) / 100 uH
    rate voltage = (current - voltage / 5 Ohm) / 220 uF
    output voltage
}
effect b buck { duty duty }
output voltage = b.voltage
'''
SCENES = {'thermal': THERMAL, 'cell': CELL, 'buck': BUCK}


def exponential(a, b, t):
    """The solution at t of x' = a x + b from zero, by the eigenvectors of a."""
    roots, vectors = np.linalg.eig(a)
    return (vectors @ (np.expm1(roots * t) / roots * np.linalg.solve(vectors, b))).real


def network(iron=700.0):
    a = np.array([[-2, 2, 0, 0], [2, -7.5, 1.5, 4], [0, 1.5, -1.5, 0], [0, 4, 0, -5]])
    capacity = np.array([150, iron, 90, 900.0])
    return a / capacity[:, None], np.array([60, 0, 0, 0]) / capacity


@pytest.mark.parametrize('real, close', [('float', 2e-3), ('double', 1e-7)])
def test_four_thermal_nodes_of_a_motor(plant, real, close):
    """At steps of 1 s: rk4 errs by (h / 56 s)^5 / 120 of 30 K in a step, 1e-8 K in all; a float by half an ulp of 300 K in each of
    1000 steps, at random."""
    rows = plant(THERMAL, real=real, by='gcc').outputs(1000, every=100).rows.astype(float)
    want = np.array([exponential(*network(), 100.0 * i) for i in range(11)]) + 293.15
    np.testing.assert_allclose(rows, want, atol=close)
    other = np.array([exponential(*network(710.0), 100.0 * i) for i in range(11)]) + 293.15
    assert np.abs(rows - other).max() > 10 * close  # the control


def test_cell(plant):
    rows = plant(CELL).outputs(6000, every=1000)
    t = np.arange(0, 601, 100.0)
    charge = 1 - 2 * t / 10800
    open_circuit = np.where(charge > 0.9, 4 + (charge - 0.9) * 2, 3.4 + (charge - 0.1) * 0.75)
    np.testing.assert_allclose(rows.voltage, open_circuit - 0.04 * -np.expm1(-t / 30) - 0.03, atol=1e-9)


def test_buck_converter(plant):
    a, b = np.array([[0, -1 / 100e-6], [1 / 220e-6, -1 / (5 * 220e-6)]]), np.array([0.4 * 24 / 100e-6, 0])
    rows = plant(BUCK).outputs(3000, every=300)
    np.testing.assert_allclose(rows.voltage, [exponential(a, b, 300e-6 * i)[1] for i in range(11)], atol=1e-8)


@pytest.mark.parametrize('name', SCENES)
@pytest.mark.parametrize('method', ['euler', 'rk4', 'ab4', 'abm4', 'bdf4', 'rosenbrock', 'adams', 'semi_implicit'])
def test_every_method(plant, name, method):
    """The rows of rk4, to what the least exact one errs, and no warning of a compiler."""
    p, other = plant(SCENES[name], '--method', method, by='gcc'), plant(SCENES[name])
    got, want = p.outputs(200).rows[-1], other.outputs(200).rows[-1]
    np.testing.assert_allclose(got, want, rtol=0.05)


@pytest.mark.parametrize('name', SCENES)
@pytest.mark.parametrize('product', [['--lanes'], ['--link'], ['--fmu'], ['--python'], ['--linear'], ['--standalone', '--name', 'alone']])
def test_every_product(isoc, name, product):
    assert isoc(SCENES[name], *product).status == 0
    assert isoc(SCENES[name], '--equations', 'text', writes=False).status == 0


def test_what_has_no_state_is_refused(isoc):
    for text in ('step 1 s; output now = 2 * time', 'step 1 s; body b { mass 1 kg }; joint j fixed { parent ground; child b }\n'
                 'output place = position of b'):
        made = isoc(text)
        assert made.refused and 'neither a joint that is not fixed nor an effect with a state' in made.errors
