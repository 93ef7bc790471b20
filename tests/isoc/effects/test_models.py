"""The machines with effects, models/, over ten seconds: each against what must hold whatever else happens in it, a balance or a
closed form. Constants are those of the scenes."""
import math
import pathlib

import numpy as np
import pytest
from harness.plants import replaced

G = 9.81


def off(values, wanted):
    return np.abs(values - wanted).max()


def dc_motor_bench(y):
    """At rest in speed: V = R i + k w, and k i = damping w + friction + load, where friction slides. Before, it had 28 time constants
    R J / k^2 = 48 ms; what is left of them, exp(-28), and of the creep, (creep / w)^2 / 2, is below 1e-8. The encoder has counted
    what the speed adds up to by the rule of the trapezoid, which is off by h^2 / 12 (w'(T) - w'(0))."""
    k, damping, resistance, volts = 0.05, 20e-6, 2.0, 12.0
    speed = (k * volts / resistance - 5e-3 - 60e-3) / (k * k / resistance + damping)
    current = (volts - k * speed) / resistance
    assert off(y.speed[29900:30001], speed) < 1e-7 * speed and off(y.current[29900:30001], current) < 1e-7 * current
    angle = np.cumsum(0.5e-4 * (y.speed[:-1] + y.speed[1:]))
    assert off(y.count[1:] + 0.5, angle * 4 * 500 / (2 * math.pi)) <= 0.5 + 0.01, 'counts both ways'


def cart_pole_drive(y):
    """From 6 s to 6.5 s the reading of the pole sticks. Against the stop the motor stands, with V / R; the pole moves the cart by
    little there. With its circuit open the motor carries no current (the 5 ms of the scene divide a second), and then friction and
    stop only take energy: no tick has more than the one before, to rounding."""
    assert off(y.pole[6000:6500], y.pole[6000]) == 0 and abs(y.pole[6500] - y.pole[6000]) > 0.1
    assert abs(y.current[2000] - 2.5) < 0.025 and off(y.current[9000:], 0) < 1e-9
    assert np.diff(y.energy[8200:]).max() < 1e-14


def quarter_car(y):
    """At rest the tyre bears all. In the air only gravity acts on all of it, whatever springs, damper and stops do: the centre of
    mass falls along a parabola, to rounding."""
    assert off(y.load[:1000], 365 * G) < 1e-9 * 365 * G
    air = y.load <= 0
    first = 1400 + np.argmax(air[1400:])
    half = (np.argmin(air[first:]) - 1) // 2
    centre = (320 * y.body + 45 * y.wheel)[first:first + 2 * half + 1:half] / 365
    assert half > 50 and abs(centre[0] - 2 * centre[1] + centre[2] + G * (half * 1e-3)**2) < 1e-12


def crane(y):
    """The cable bears the load, then it is slack while the floor does, but for what is left of the bounce: its damping goes with its
    depth."""
    assert off(y.tension[:501], 250 * G) < 1e-6 * 250 * G
    assert off(y.tension[4500:5501], 0) == 0 and off(y.floor[4500:5501], 250 * G) < 1e-4 * 250 * G


def balancer(y):
    """In a curve the moment of the centrifugal force about the ground shifts the load between the wheels. The spin of the wheels adds
    2 %, and the tilt by the tyres 1 %."""
    moment = (1.2 * 0.15 + 0.16 * 0.05) * y.speed[3500] * y.spin[3500]
    assert abs((y.normal[3500] - 1.36 * G / 2) / (moment / 0.2) - 1) < 0.03
    assert off(y.pitch, 0) < 0.1, 'it stays upright'


def hopper(y):
    """In the air only gravity acts: the centre of mass, of torso, thigh and shin, has a parabola, whatever hip and leg do."""
    far = (0.6 * 0.15 + 0.3 * (0.5 - y.leg) + 0.1 * (0.7 - y.leg)) / 9
    x, z = y.place_x - far * np.sin(y.hip), y.place_z - far * np.cos(y.hip)
    tick, flights = 200, 0
    while tick + 100 < len(x):
        if off(y.normal[tick:tick + 101], 0) > 0:
            tick += 1
            continue
        k = [tick, tick + 50, tick + 100]
        assert abs(x[k] @ [1, -2, 1]) < 1e-6 and abs(z[k] @ [1, -2, 1] + G * 0.05**2) < 1e-6
        flights, tick = flights + 1, tick + 101
    assert flights >= 16
    assert off(y.speed[9000:], 0) < 0.05 and y.speed[6000] > 0.3, 'it runs and stops'


def quadrotor_sih(y):
    """On the ground the unit reads g, on average but for four times 0.045 m/s^2 / sqrt(500) of its noise; it hovers on a lift of its
    weight, but for the drag of its tilt."""
    assert abs(y.force[1:501].mean() - G) < 1e-2
    assert abs((4 * 8e-6 * y.speed[4000:5000]**2).mean() / (1.2 * G) - 1) < 1e-3


def arm_drive(y):
    """After its motor has failed the rotor of the shoulder has the gear's effort alone: 100^2 * 2e-4 kg*m^2 times the second difference
    of its angle. That leaves out (w h)^2 / 12 of an oscillation with w = 150/s, 0.2 %, and what an impact has besides. In the end
    the arm lies on its stop."""
    angle, effort = y.shoulder_angle + y.shoulder_twist, y.shoulder_torque[5010:-1]
    most = np.abs(effort).max()
    assert most > 100 and off(2 * np.diff(angle, 2)[5009:] / 1e-6, -effort) < 0.01 * most
    assert 0 < y.shoulder_angle[-1] < 0.01


# A machine, and what is changed in it for the control.
MACHINES = {arm_drive: ('2e-4 kg', '2.1e-4 kg'), balancer: ('of 1.2 kg', 'of 1.3 kg'), cart_pole_drive: ('2 Ohm', '2.1 Ohm'),
            crane: ('of 250 kg', 'of 251 kg'), dc_motor_bench: ('50 mN', '51 mN'), hopper: ('-9.81', '-9.82'),
            quadrotor_sih: ('= 8 uN', '= 8.1 uN'), quarter_car: ('-9.81', '-9.82')}


@pytest.fixture
def copies(tmp_path):
    """The models, whose includes stand beside them."""
    (tmp_path / 'parts').mkdir()
    for path in [*pathlib.Path('models').glob('*.scene'), *pathlib.Path('models').glob('parts/*.scene')]:
        (tmp_path / path.relative_to('models')).write_text(path.read_text())
    return tmp_path


@pytest.mark.parametrize('machine', MACHINES, ids=lambda machine: machine.__name__)
def test_a_machine_has_its_balance_and_another_machine_has_not(plant, copies, machine):
    place = copies / f'{machine.__name__}.scene'
    p = plant(place)
    assert p.made.errors == '', 'isoc has nothing to say'
    machine(p.follow(round(10 / p.step_size)).y)
    text, by = MACHINES[machine]
    holder = copies / 'parts/cart_pole.scene' if machine is cart_pole_drive else place
    holder.write_text(replaced(text, by, holder.read_text()))
    other = plant(place)
    with pytest.raises(AssertionError):
        machine(other.follow(round(10 / other.step_size)).y)
