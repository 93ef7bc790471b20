"""isoc FILE --check: definitions of effects without a scene."""
import re

import pytest

from harness.project import ROOT

LIBRARY = sorted((ROOT / 'models/effects').glob('*.scene'))
# Operands without a unit, which can have any: as plain numbers they do not fit.
ANY_UNIT = {'noisy', 'rate_limit'}


@pytest.mark.parametrize('path', LIBRARY, ids=lambda path: path.stem)
def test_a_definition_of_the_library_stands_alone(isoc, path):
    made = isoc(path, '--check', writes=False)
    assert (made.status == 0) == (path.stem not in ANY_UNIT), made.errors
    if made.status == 0:
        listed = re.findall(r'^ *(?:joint|body|signal|value|fault|state) (\w+)', re.sub(r'; *', '\n', path.read_text()), flags=re.M)
        assert set(listed) <= {line.split()[1] for line in made.printed.splitlines()}


def test_what_it_has_is_printed_with_units(isoc):
    made = isoc('''effect motor {
    joint shaft; signal supply V; value resistance Ohm; value constant N*m/A; value most like effort of shaft; fault open
    memory heat J = 0 J; next heat = heat + resistance * (supply / resistance)^2 * step
    memory way m = (0, 0, 0) m; next way = way
    let current = supply / resistance * (1 - open)
    effort on shaft = min(constant * current, most)
    part bearing friction { along shaft; sliding 1 N*m }
    output current; output heat; output way
    require resistance >= 5 Ohm
}
''', '--check', writes=False)
    assert made.printed == '''effect motor
joint shaft
signal supply V
value resistance Ohm
value constant N*m/A
value most N*m
fault open
memory heat N*m
memory way m vector
part bearing friction
output current A
output heat N*m
output way m vector
''', made.errors


@pytest.mark.parametrize('line, message', [
    ('let a = supply + 1 A', r':2:\d+: error: V and A cannot be added'),
    ('effort on shaft = supply', r":2:\d+: error: the effort on 'shaft' is in N.m; this is in V"),
    ('let a = b', r":2:\d+: error: this effect has no 'b'"),
    ('state z = 0', r":2:\d+: error: the state 'z' needs one rate, and has 0"),
    ('stat z = 0', r":2:\d+: error: expected joint, body")])
def test_what_is_wrong_is_told_at_its_line(isoc, line, message):
    made = isoc(f'effect motor {{ joint shaft; signal supply V\n{line}\n}}\n', '--check', writes=False)
    assert made.status == 1 and re.search(message, made.errors), made.errors


def test_one_for_a_joint_that_slides_is_tried_on_such_a_joint(isoc):
    made = isoc('effect pull { joint along; effort on along = 1 N - 1 N*s/m * speed of along }\n', '--check', writes=False)
    assert made.status == 0 and made.printed == 'effect pull\njoint along\n'
