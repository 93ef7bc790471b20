"""The stiff flyball governor (IFToMM benchmark A05) with the implicit methods and projection, 5 s in steps of 1 ms, where an explicit method
needs steps below 0.34 ms. With springs and dampers as given, against the solution of its equations in two coordinates (Radau IIA, 58
digits); with 10,000 times of both, which leaves the legs rigid to 1e-8 m, the methods against each other."""
import pathlib
import re

import numpy as np
import pytest
from harness.plants import replaced

GOVERNOR = pathlib.Path('tests/core/methods/order/governor.scene').read_text()
REFERENCE = [[0.5218333016255462, 0.5014209223795677], [0.4828745765869398, 0.5355631037216435]]
# The motion that is not damped has 7.35 rad/s: order three leaves at most (7.35 rad/s 1 ms)^3 of it.
ALLOWED = 4e-7


def stiff(times):
    """The scene with springs and dampers that are so many times as stiff."""
    harder = replaced('^constant stiffness =.*', f'constant stiffness = 8e5 N/m * {times}', GOVERNOR)
    return replaced('^constant damper =.*', f'constant damper = 4e4 N*s/m * {times}', harder)


@pytest.fixture(scope='module')
def governed(plant):
    """governed(scene, method): arm and slider at 1 s and at 5 s."""
    def run(scene, method, real='double'):
        y = plant(scene, '--method', method, '--step', '1ms', real=real).follow(5000).y
        return np.stack([y.beta, y.s], 1)[[1000, 5000]].astype(float)

    return run


def off(a, b):
    return np.abs(np.asarray(a) - b).max()


@pytest.mark.parametrize('method', ['rosenbrock', 'bdf4'])
def test_an_implicit_method_has_the_reference(governed, method):
    assert off(governed(stiff(1), method), REFERENCE) <= ALLOWED


def test_ten_thousand_times_as_stiff_both_methods_agree_and_it_is_another_motion(governed):
    rigid = governed(stiff(1e4), 'bdf4')
    assert off(governed(stiff(1e4), 'rosenbrock'), rigid) <= ALLOWED
    assert off(rigid, REFERENCE) > 1e-5


def test_the_springs_of_the_legs_may_be_an_effect_and_a_spring_between_points(governed):
    struts = re.sub('^    (spring|damping) .*\n', '', stiff(1e4), flags=re.M) + '''effect strut { joint leg; value k N/m; value c N*s/m
    effort on leg = -k * (position of leg - 0.5 m) - c * speed of leg
}
effect strut1 strut { leg leg1; k stiffness; c damper }
spring strut2 { between eye2 and slider at (-0.05, 0, 0) m; stiffness stiffness; damping damper; length 0.5 m }
'''
    assert off(governed(struts, 'rosenbrock'), governed(stiff(1e4), 'rosenbrock')) <= 1e-9


def test_the_augmented_lagrangian_holds_them_in_float(governed):
    """It adds 2e-4 of itself to the Schur complement: a Jacobian that is off by as much does not hold the springs. The rounding of a state,
    3e-8 in each of 5000 steps, adds up to 1.5e-4 at most."""
    assert off(governed(stiff(1e4) + 'stabilisation lagrangian\n', 'bdf4', 'float'), governed(stiff(1e4), 'bdf4')) <= 1.5e-4
