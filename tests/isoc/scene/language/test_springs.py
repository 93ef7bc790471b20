"""Springs and dampers between points, against closed forms and against a spring of a joint."""
import math

import numpy as np
import pytest
from harness.project import ROOT

# --- on a line ---


def test_an_oscillator_through_the_zero_of_its_springs_length(plant):
    """e^-at (cos wt + a/w sin wt) with a = c / 2m and w^2 = k/m - a^2. rk4 is off by (w h)^5 / 120 in a step, 5000 of which make 1.4e-12;
    the rounding of as many is less."""
    y = plant('''step 1 ms
body bob { mass 2 kg; inertia (1, 1, 1) g*m^2 }
joint afloat free { parent ground; child bob; start at (0, 0.6, 0.8) m }
spring bungee { between ground and bob; stiffness 8 N/m; damping 0.4 N*s/m; length 0 m }
output place = position of bob
output pull = effort of bungee
''').follow(5000).y
    a, w, t = 0.1, math.sqrt(4 - 0.01), 5
    x = math.exp(-a * t) * (math.cos(w * t) + a / w * math.sin(w * t))
    v = -math.exp(-a * t) * math.sin(w * t) * (w + a * a / w)
    wanted = [0.6 * x, 0.8 * x, math.copysign(1, x) * (8 * x + 0.4 * v)]
    assert np.abs(np.array([y.place_y[-1], y.place_z[-1], y.pull[-1]]) - wanted).max() < 1e-11


@pytest.mark.parametrize('real, method', [('float', 'euler'), ('float', 'rosenbrock'), ('double', 'bdf4')])
def test_ends_may_meet(plant, real, method):
    """Exactly: x is -0.5, 0, 0.5. Nothing overflows, in float neither, nor in the Jacobian of a stiff method."""
    y = plant('''step 0.5 s
body bob { mass 1 kg }
joint slide prismatic { parent ground; child bob; axis x; start -0.5 m; speed 1 m/s }
spring gap { between ground and bob; stiffness 1e-9 N/m; damping 1e-9 N*s/m; length 0 m }
output x = position of slide
output pull = effort of gap
''', '--method', method, real=real).follow(2).y
    assert np.abs(np.array([y.x[1], y.pull[1], y.x[2] - 0.5])).max() < 1e-6


OF_JOINT = '''step 1 ms
tunable k = 40 N/m
body one { mass 1 kg }
body two { mass 2 kg }
joint first prismatic { parent ground; child one; axis x; start 100 mm; speed 1 m/s }
joint second prismatic { parent one; child two; axis x; start 0.4 m; spring k rest 0.3 m; damping 0.5 N*s/m }
output energy = energy
output a = position of first
output b = speed of second
'''


@pytest.mark.parametrize('stiffness, is_same', [('k', True), ('1.0001 * k', False)])
def test_a_spring_between_two_bodies_is_that_of_the_joint_between_them(plant, stiffness, is_same):
    """But for the rounding of 5000 steps, 2.2e-16 each."""
    between = OF_JOINT.replace(' spring k rest 0.3 m; damping 0.5 N*s/m', '') + f'''spring link {{
    between one at (-1, 0, 0) m and two at (-1, 0, 0) m; stiffness {stiffness}; damping 0.5 N*s/m; length 0.3 m
}}
'''
    a, b = (plant(scene).follow(5000).rows['y'][-1] for scene in (OF_JOINT, between))
    assert (np.abs(a - b).max() < 1e-11) == is_same


def test_tension_acceleration_and_reactions_are_those_by_hand(plant):
    """r = (3, -4, 0) m, d = 5 m, d' = 0.6 m/s, T = 10 N/m 1 m + 5 N*s/m d' = 13 N along (0.6, -0.8, 0)."""
    y = plant('''step 1 ms
body post { mass 1 kg }
body bob { mass 2 kg }
frame top { on post at (0, 4, 0) m }
joint root fixed { parent ground; child post }
joint slide prismatic { parent ground; child bob; axis x; start 3 m; speed 1 m/s }
spring link { between top and bob; stiffness 10 N/m; damping 5 N*s/m; length 4 m }
output pull = effort of link
output a = acceleration of slide
output on_post = force of root
output turning = moment of root
output on_bob = force of slide
''').follow(1).y
    found = [y[name][0] for name in ('pull', 'a', 'on_post_x', 'on_post_y', 'turning_z', 'on_bob_x', 'on_bob_y')]
    assert np.abs(np.array(found) - [13, -3.9, -7.8, 10.4, 31.2, 0, -10.4]).max() < 1e-13


# --- in space, between bodies on a ball and on a universal joint, with a gap that a loop holds ---

TANGLE = '''gravity (0, 0, -9.81) m/s^2; step 2 ms; stabilisation projection
body arm { mass 1 kg; com (0, 0, -0.3) m; inertia (20, 30, 10) g*m^2 }
body fore { mass 2 kg; com (0, 0.1, -0.3) m; inertia (30, 20, 10) g*m^2 }
body load { mass 1.5 kg; inertia (10, 20, 30) g*m^2 }
joint ball spherical { parent ground; child arm; start rotate 30 deg about x rotate 20 deg about y; spin (1, 0, 2) rad/s }
joint elbow universal { parent arm at (0, 0, -0.6) m; child fore; axis x; second y; start rotate 40 deg rotate 10 deg }
joint swing revolute { parent ground at (1, 0, -1) m; child load at (0, 0, 0.4) m; axis y; start 20 deg }
spring inner { between ground at (0.5, 0, 0) m and fore at (0, 0, -0.6) m; stiffness k; length 0.5 m }
spring outer { between load at (0.1, 0, 0) m and arm at (0, 0.1, -0.6) m; stiffness 2 * k; damping c; length 0.4 m }
output energy = energy
output place = position of fore
output angle = position of swing
'''


def test_an_undamped_mechanism_with_springs_keeps_its_energy(plant):
    """It changes with the step's fourth power at least."""
    off = []
    for steps in (250, 500):
        y = plant('constant k = 60 N/m; constant c = 0 N*s/m; ' + TANGLE, '--step', f'{500 // steps}ms').follow(steps).y
        off.append(y.energy[-1] - y.energy[0])
    assert off[0] / off[1] > 16


@pytest.mark.parametrize('method, ratio', [('rk4', 16), ('rosenbrock', 8), ('bdf4', 16)])
def test_each_method_has_its_order_with_springs_so_their_jacobian_is_right(plant, method, ratio):
    ends = []
    for steps in (200, 400, 800, 1600):
        p = plant('tunable k = 60 N/m; tunable c = 3 N*s/m; ' + TANGLE, '--method', method, '--step', f'{200_000 // steps}us')
        ends.append(p.follow(steps).rows['y'][-1, 1:])
    off = [np.linalg.norm(a - b) for a, b in zip(ends, ends[1:])]
    assert ratio / 1.5 < off[1] / off[2] < ratio * 1.5


def test_springs_and_frames_have_the_bits_of_the_host_on_the_board_and_one_count(isochron):
    host, board = (isochron('run', ROOT / 'tests/isoc/scene/frames.scene', '--target', target, '--seconds', '1').said
                   for target in ('host', 'cortex-m4f'))
    assert host['hash'] == board['hash'] and 'instructions_per_step' in board
