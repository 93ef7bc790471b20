"""Noise is given by its density: the spectrum of what sensors show is the same at any step. Its unit is checked."""
import math

import numpy as np
import pytest

SCENE = '''step 1 ms
body b { mass 1 kg; inertia (1, 1, 1) kg*m^2 }
joint j prismatic { parent ground; child b; axis x }
signal volts = 0 * speed of j / 1 m/s * 1 V
effect probe sensor { input volts; density 10 mV/sqrt(Hz); noise noise(1) }
effect drift walk { sigma 0.3 V/sqrt(s) }
effect fault noisy { input volts; density 20 mV/sqrt(Hz) }
effect unit imu {
    on b; force_density 3 mm/s^2/sqrt(Hz); noise_1 noise(3)
    spin_density 0.05 deg/s/sqrt(Hz); noise_6 noise(4)
}
at 0 s set fault.active = 1
output sensor = probe.value; output walk = drift.value; output noisy = fault.value
output force = unit.force_x; output spin = unit.spin_z
'''


def wrong(plant, step_ms, real, factor=1.0):
    """The outputs without their variance. White noise of density d in steps of h has the variance d^2 / (2 h), the increments of a walk
    with sigma k have k^2 h; both within five standard deviations, sqrt(2 / n) of a variance of n independent Gaussian numbers."""
    p, h = plant(SCENE, '--step', f'{step_ms}ms', real=real), step_ms * 1e-3
    y = p.follow(8000).y
    densities = {'sensor': 0.01, 'noisy': 0.02, 'force': 0.003, 'spin': math.radians(0.05)}
    shown = {name: (y[name].astype(float), d * d / (2 * h)) for name, d in densities.items()}
    shown['walk'] = np.diff(y.walk.astype(float)), 0.3**2 * h
    return {name for name, (x, want) in shown.items() if abs((x * x).mean() / (want * factor) - 1) > 5 * math.sqrt(2 / len(x))}


@pytest.mark.parametrize('real', ['float', 'double'])
@pytest.mark.parametrize('step_ms', [0.25, 1, 8])
def test_each_sensor_has_its_density_at_any_step(plant, step_ms, real):
    assert wrong(plant, step_ms, real) == set()


def test_a_tenth_more_of_the_variance_is_found(plant):
    assert wrong(plant, 8, 'double', 1.1) == {'sensor', 'noisy', 'force', 'spin', 'walk'}


@pytest.mark.parametrize('density, other, unit', [('density 3 mm/s^2/sqrt(Hz)', 'density 3 mm/s^2', 'm/s*sqrt(Hz)'),
                                                  ('density 10 mV/sqrt(Hz)', 'density 10 mV', 'V/sqrt(Hz)')])
def test_a_density_with_the_unit_of_a_deviation_is_refused(isoc, density, other, unit):
    made = isoc(SCENE.replace(density, other))
    assert made.refused and unit in made.errors
