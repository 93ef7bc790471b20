"""Inputs that are plain numbers, and inputs with a value, which they have until one comes in: in the plant, its link
and its package of Python; tests/tools/fmu/test_inputs.py has the FMU."""
import importlib.util
import re
import socket
import subprocess

import numpy as np
import pytest
from harness.plants import replaced


def scene(level, unit='', force='1 N'):
    return f'''step 1 ms
body b {{ mass 1 kg }}
joint j prismatic {{ parent ground; child b; axis x }}
input level {level}
effect push {{ joint along; signal level {unit}; effort on along = level * {force}; output level }}
effect p push {{ along j; level level }}
output x = position of j
output shown = p.level
'''


def test_plain_number(plant):
    """An input without a unit is one with the unit 1, and has the bits of one in volts."""
    given = np.random.default_rng(1).uniform(0, 1, (200, 1))
    plain, volts = (plant(text).run(200, given=given) for text in (
        scene('in 0 to 1'), scene('V in 0 V to 1 V', 'V', '1 N/V')))
    assert np.array_equal(plain['x'], volts['x']) and np.array_equal(plain['y'], volts['y']) and plain['x'][-1].any()


def test_header(isoc):
    made = isoc(scene('in 0 to 1 safe 0 after 5 ticks'), '--link')
    assert made.status == 0, made.errors
    assert re.search(r'\{"level", "1", R?\(?0', made.file('plant.h'))


@pytest.mark.parametrize('real', ['float', 'double'])
def test_value(plant, real):
    """The value stands from row 0 on, without an input; what comes in takes its place, and stays."""
    made = plant(scene('= 0.25 in 0 to 1'), real=real)
    assert (made.outputs(50).shown == 0.25).all()
    given = np.linspace(0.5, 1, 50)[:, None]
    assert np.array_equal(made.outputs(50, given=given).shown[1:], given[:, 0].astype(made.number))
    zero = plant(scene(''), real=real).outputs(50, given=np.full((50, 1), 0.25))
    assert np.array_equal(made.outputs(50).x, zero.x)


def test_controls(plant):
    """Found: a start without the value; a value that each tick sets again."""
    text = scene('= 0.25')
    lost = plant(text, change=lambda c: replaced(r'memory->u\[PLANT_U_LEVEL\] = R\(0\.25\);', '', c))
    assert (lost.outputs(5).shown == 0).all()
    again = plant(text, change=lambda c: replaced(
        r'(static iso_refused admit\(.*\n\{\n.*\n)', r'\1    memory->u[PLANT_U_LEVEL] = R(0.25);\n', replaced(
            r'    \.amiss = amiss,\n', '', c)))
    assert not np.array_equal(again.outputs(5, given=np.ones((5, 1))).shown[1:], np.ones(5))


def test_not_finite(plant):
    """The value is the last good one from the start on."""
    made = plant(scene('= 0.25 in 0 to 1'))
    assert made.outputs(1, given=np.full((1, 1), np.nan)).shown[1] == 0.25


def test_package(isoc, tmp_path):
    """Both ends of a link list it, and begin with the value; so does the package."""
    made = isoc(scene('= 0.25 in 0 to 1'), '--link')
    spec = importlib.util.spec_from_file_location('plant_link', made.folder / 'plant_link.py')
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    assert module.INPUTS == {'level': ('1', 0.0, 1.0)}
    here, there = socket.socketpair()
    with module.Link(f'fd:{here.detach()}') as link:
        assert link.inputs == {'level': 0.25}
    there.close()
    (tmp_path / 'main.c').write_text('#include "plant_link.h"\nint main(void)\n{\n    static plant_link link;\n'
                                     '    return !plant_open(&link, "fd:0") || link.u[PLANT_U_LEVEL] != 0.25F;\n}\n')
    subprocess.run(['gcc', f'-I{made.folder}', tmp_path / 'main.c', '-o', tmp_path / 'main'], check=True)
    assert subprocess.run([tmp_path / 'main']).returncode == 0
    package = isoc(scene('= 0.25 in 0 to 1'), '--python')
    assert '"level": ("1", 0, 1)' in (package.folder / 'plant_plant/__init__.py').read_text()
