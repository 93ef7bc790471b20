"""Values that make no sense, zero, negative or crossed, are refused at each effect of the library that has such, with the
place."""
import pathlib
import re

import pytest
from harness.plants import other_effect, replaced

SCENE = pathlib.Path('tests/isoc/effects/all.scene').read_text()
SENSELESS = '''
stop impact -1 m/s | stop impact 0 m/s | stop rest 0 | stop rest 1.1 | stop stiffness -1 N/m | stop upper -1 m
bumper impact -1 m/s | bumper side 0.5 | bumper stiffness -1 N/m
backlash impact 0 rad/s | backlash gap -1 deg | backlash ratio 0
contact impact -1 m/s | contact friction -1 | contact stiffness -1 N/m
friction sliding -1 N | friction static 0 N | friction creep 0 m/s | friction fall -1 m/s
battery capacity 0 A*s | battery start 1.5 | battery cells 0 | battery empty 0 | battery resistance -1 Ohm
chopper period 0 s | chopper inductance -1 H | chopper drop -1 V
dc_motor inductance 0 H | dc_motor resistance -1 Ohm | thermal resistance 0 K/W | thermal capacity -1 J/K
flexible_gear ratio 0 | flexible_gear rotor 0 kg*m^2 | cogging periods 0.5 | cogging peak -1 N*m
jammed rate 0 Hz | current_limit most -1 A | lag constant 0 s'''


def scene_with(case):
    """The scene in which the first use of a kind has this value."""
    kind, operand, value = case.split(' ', 2)
    use = re.search(rf'^effect \w+ {kind} {{.*}}$', SCENE, re.M)[0]
    other = re.sub(rf'; *{operand} [^;}}]*', '', use)
    return SCENE.replace(use, replaced(r' *\}$', f'; {operand} {value} }}', other))


@pytest.mark.parametrize('case', re.split(r'[|\n] *', SENSELESS.strip().replace(' |', '|')))
def test_a_senseless_value_is_refused_at_its_place(isoc, case):
    made = isoc(scene_with(case))
    assert made.refused and re.search(r'scene:\d+:\d+: error: .*breaks what its effect requires', made.errors), made.errors


def test_sound_values_are_accepted_and_so_is_all_by_an_effect_that_requires_nothing(isoc):
    assert isoc(SCENE).status == 0
    assert isoc(other_effect('lag', '^ *require.*$', '') + scene_with('lag constant 1e-12 s')).status == 0
