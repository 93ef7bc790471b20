"""The account of energy, the outputs energy, power and balance, of every model, and of all effects of the library, by rk4.

At a point the rate of the energy is the power: `balance` is zero to rounding, in the states of the run, and in the same with other speeds,
where closures are violated too. Over a tick the energy changes by the work. From the plant's state at the beginning of a tick the test
integrates the motion, with the power as one more state, in one step of rk4 and in four: what is left is of order h^4 over the whole, so
four steps leave 1/256 where the equations are smooth, and with corners in them, of stops and contacts, 1/16 of what a corner leaves, h^2,
on average over where in the step it lies: 1/4 of the sum over some tens of them. Inputs and memories are constant in a tick. What the
plant has at the end of its own step beyond one step of rk4 is the energy that the projection onto the closures takes."""
import pathlib
import re

import numpy as np
import pytest
from harness.plants import other_effect, replaced

SCENES = sorted(pathlib.Path('models').glob('*.scene')) + [pathlib.Path('tests/isoc/effects/all.scene')]
LOSSY = {path.stem for path in pathlib.Path('models/effects').glob('*.scene') if re.search(r'^ *loss = ', path.read_text(), re.M)}
ULP = np.finfo(float).eps
# Of sums of some hundred terms that flow both ways.
ROUNDING = 4096 * ULP
# Where closures are redundant, or singular, the augmented Lagrangian makes n / e of a rounding error, with n = 6 iterations and e the root
# of it (augmented.h): in multipliers that do no work, but for the violation of rates. And the multipliers have a peak that is shorter
# than a step: a step that meets it is off by so much of what flows.
ROUNDING_SINGULAR, PEAK = 6 * 1.5e-8, 1e-6
# A few corners of a small part of what flows may lie anywhere in their ticks.
CORNER = 1e-9


def loss_outputs(isoc, scene):
    effects = re.findall(r'^(\w+) (\w+)', isoc(scene, '--effects', writes=False).printed, re.M)
    return [f'output account_loss{i} = loss of {name}\n' for i, name in enumerate(name for name, kind in effects if kind in LOSSY)]


class Account:
    """The sums over the ticks that are looked at; `off`: each acceleration is off by a part of its own, up to twice this."""

    def __init__(self, p, ticks, every, losses, off=0.0):
        self.p, self.losses = p, losses
        self.first_speed = (p.states + 1) // 2  # the speeds stand behind all else, and are half of the states or fewer
        self.scale = 1 + off * (np.arange(p.states) % 3) * (np.arange(p.states) >= self.first_speed)
        self.rows = p.run(ticks, every)[:-(-ticks // every)]
        x = self.rows['x'].copy()
        draw = np.random.default_rng(1)
        other = x.copy()
        speeds = other[:, self.first_speed:]
        speeds += (np.abs(speeds) + 1) * draw.uniform(-0.5, 0.5, speeds.shape)
        flow, other_flow = self.flow(x), self.flow(other)
        y = p.outputs_at(self.rows, x)
        self.unbalanced, self.flowed = np.abs(y[:, -1]).max(), flow.sum() * p.step_size
        self.most = max(flow.max(), other_flow.max())
        self.part = (np.abs(p.outputs_at(self.rows, other)[:, -1]) / other_flow).max()
        self.gained = max(0, -y[:, -3 - losses:-3].min()) if losses else 0
        (once, left_1), (_, left_4) = self.passed(x, 1), self.passed(x, 4)
        self.left = np.abs(left_1).sum(), np.abs(left_4).sum()
        self.projected = np.abs(self.energy(p.stepped(self.rows)['x']) - self.energy(once)).sum()

    def energy(self, x):
        return self.p.outputs_at(self.rows, x)[:, -3]

    def flow(self, x):
        """The power that flows between all forms of energy: of each state its part of the energy's rate, without its sign."""
        slopes, total = self.p.slopes_at(self.rows, x)[0], 0
        for i in range(self.p.states):
            by = np.maximum(1, np.abs(x[:, i])) / 1e6
            more, less = x.copy(), x.copy()
            more[:, i] += by
            less[:, i] -= by
            total = total + np.abs((self.energy(more) - self.energy(less)) / (2 * by) * slopes[:, i])
        return total

    def slope(self, x):
        slopes, y = self.p.slopes_at(self.rows, x)
        return slopes * self.scale, y[:, -2]

    def passed(self, x, steps):
        """The states after a tick in so many steps, and what is left of the energy less the work."""
        before, h, work = self.energy(x), self.p.step_size / steps, 0
        for _ in range(steps):
            a, p1 = self.slope(x)
            b, p2 = self.slope(x + h / 2 * a)
            c, p3 = self.slope(x + h / 2 * b)
            d, p4 = self.slope(x + h * c)
            x, work = x + h / 6 * (a + 2 * b + 2 * c + d), work + h / 6 * (p1 + 2 * p2 + 2 * p3 + p4)
        return x, self.energy(x) - before - work


def account_plant(isoc, plant, place, definitions='', *options):
    """The plant of a scene with the outputs of its account, and how many losses it shows."""
    scene = f'include "{place.resolve()}"\n{definitions}'
    losses = loss_outputs(isoc, place)
    shown = ''.join(losses) + 'output account_energy = energy\noutput account_power = power\noutput account_balance = balance\n'
    return plant(scene + shown, '--method', 'rk4', '--inputs', 'held', *options), len(losses)


def is_closed(account, wrong, is_smooth, is_singular):
    """Whether each part of the account is as it should be, by its name."""
    least = ROUNDING if is_smooth else PEAK if is_singular else CORNER
    return {
        'balance': account.unbalanced <= ROUNDING * account.most,
        'losses': account.gained <= ROUNDING * account.most,
        'other speeds': account.part <= (ROUNDING_SINGULAR if is_singular else ROUNDING),
        'work': account.left[1] <= max(account.left[0] / (128 if is_smooth else 4), least * account.flowed),
        'control': wrong.left[1] / wrong.flowed > 2 * account.left[1] / account.flowed or account.flowed < ULP}


def tried(isoc, plant, place, is_cornered=None, *options):
    """Four seconds, the squeezer half of one; of the ticks some hundred, where there are corners 2000."""
    text = place.read_text()
    is_singular = bool(re.search('^stabilisation lagrangian', text, re.M))
    is_cornered = bool(re.search('^ *effect ', text, re.M)) if is_cornered is None else is_cornered
    p, losses = account_plant(isoc, plant, place, '', *options)
    ticks = round((0.5 if place.stem == 'squeezer' else 4) / p.step_size)
    every = ticks // (2000 if is_cornered and not is_singular else 200) + 1
    account, wrong = Account(p, ticks, every, losses), Account(p, ticks, 16 * every, losses, 1e-2)
    closed = is_closed(account, wrong, not is_singular and not is_cornered, is_singular)
    assert all(closed.values()), (closed, vars(account))
    return account, p.step_size


@pytest.mark.parametrize('place', SCENES, ids=lambda path: path.stem)
def test_the_account_of_energy_closes(isoc, plant, place):
    """What the projection takes is of order h^5 in a tick: half the step leaves 1/32 in as many of them, or rounding."""
    whole, step = tried(isoc, plant, place)
    if re.search('^close ', place.read_text(), re.M):
        half, _ = tried(isoc, plant, place, None, '--step', f'{step / 2}s')
        assert half.projected < whole.projected / 16 or half.projected < 1e-12 * whole.flowed, (whole.projected, half.projected)


DRUM = '''effect drum { signal to m; state paid m = 6 m; rate paid = reel; let reel = (to - paid) / (0.2 s); output paid; output reel }
effect winder drum { to winch }
'''


def balances(isoc, plant, place):
    """Whether the balance and the losses of 3000 ticks are as they should be."""
    p, losses = account_plant(isoc, plant, place)
    account = Account(p, 3000, 7, losses)
    return account.unbalanced <= ROUNDING * account.most, account.gained <= ROUNDING * account.most


@pytest.mark.parametrize('reel, closes', [('winder.reel', True), ('0 m/s', False)])
def test_a_cable_whose_length_is_a_state_knows_its_rate_or_is_found(isoc, plant, tmp_path, reel, closes):
    """What the winch gives is in the account."""
    place = tmp_path / 'reeled.scene'
    place.write_text(DRUM + replaced('length winch$', f'length winder.paid; reel {reel}', pathlib.Path('models/crane.scene').read_text()))
    if closes:
        tried(isoc, plant, place, True)
    else:
        assert not balances(isoc, plant, place)[0]


@pytest.mark.parametrize('scene, kind, text, by, gives', [
    ('models/dc_motor_bench', 'dc_motor', 'effort on shaft = constant', 'effort on shaft = 1.000001 * constant', False),
    ('models/dc_motor_bench', 'friction', 'loss = -effort', 'loss = effort', True),
    ('models/cart_pole_drive', 'stop', r'stiffness \* depth\^2 / 2', 'stiffness * depth^2 / 3', False),
    ('tests/isoc/effects/all', 'cogging', r'\(1 - cos\(angle\)\)', '(1 - cos(angle)) * 1.001', False),
    ('models/arm_drive', 'flexible_gear', r'effort / ratio\) / rotor', 'effort) / rotor', False),
    ('models/balancer', 'contact', r'ball = cross\(arm, push\)', 'ball = cross(push, arm)', False),
    ('models/crane', 'cable', r'tension / distance \* gap', '1.000001 * tension / distance * gap', False),
    ('models/crane', 'cable', r'loss = \(tension - stiffness \* stretch\)', 'loss = (stiffness * stretch - tension)', False),
    ('models/quadrotor_sih', 'propeller', r'\(0 N, 0 N, lift\)', '(0 N, 0 N, 1.00001 * lift)', False),
    ('models/quadrotor_sih', 'drag', r'loss = -dot\(force, v\)$', 'loss = 0 W', False)])
def test_a_changed_effect_has_no_balance(isoc, plant, tmp_path, scene, kind, text, by, gives):
    place = pathlib.Path(f'{scene}.scene')
    planted = tmp_path / f'{place.stem}.scene'
    planted.write_text(other_effect(kind, text, by) + re.sub('^include "', f'include "{place.parent.resolve()}/', place.read_text(), flags=re.M))
    balance, losses = balances(isoc, plant, planted)
    assert not balance and not (gives and losses)
