"""The plants of the tests of the link, and a controller of them in this process."""
import re
import types

import numpy as np

from harness.programs import path_of
from harness.project import ROOT

CONTROLLERS = ROOT / 'tests/core/link/controllers'
INPUT = 'input force in -20 N to 20 N'


def cart(folder, statement=INPUT + ' safe 0 N after 5 ticks'):
    """The scene of the cart with its pole, whose input comes over the link, as a file."""
    text = re.sub('^input force .*', statement, (ROOT / 'models/cart_pole.scene').read_text(), flags=re.M)
    return path_of(text, folder, 'cart_pole.scene')


def controller_of(program, name, made, real='float', **how):
    """The program NAME.c of this folder, with what isoc has made for controllers of a plant."""
    flags = ['-D_POSIX_C_SOURCE=200809L', '-I', made.folder]
    return program(CONTROLLERS / f'{name}.c', 'tests/host/report.c', by='clang', real=real, flags=flags, **how)


def law(y, number=np.float32):
    """What law.h computes, in the plant's numbers; y has the outputs by their names."""
    return number(30) * number(y.pole) + number(6) * number(y.pole_speed) + number(2) * number(y.cart_position) + \
        number(4) * number(y.cart_speed)


def balance(link, y, tick, number=np.float32):
    """Exchanges until that tick; the outputs there."""
    while link.tick < tick:
        y = link.exchange(force=float(law(y, number)))
    return y


def alone(cart, ticks, number):
    """The same loop without a wire: the states behind each of so many ticks, and the last angle of the pole."""
    cart.start()
    place = {name: i for i, name in enumerate(cart.names)}
    rows = []
    for tick in range(ticks):
        y = types.SimpleNamespace(**{name: cart.now['y'][0][i] for name, i in place.items()})
        cart.go(1, given=[[law(y, number)]], first=tick)
        rows.append(cart.now['x'][0].copy())
    return np.array(rows), cart.now['y'][0][place['pole']]


def is_refused(client, why, call, *arguments):
    """Whether the plant, or its module, refuses a call for a reason."""
    try:
        call(*arguments)
    except client.LinkError as refusal:
        return why in str(refusal)
    return False
