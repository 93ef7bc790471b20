"""Only what the scene calls for: an effect that it does not name leaves no instruction, no byte and no symbol in the
plant's object for the Cortex-M4F; one that it names is there. The effects are those of tools/measure/effects.txt."""
import functools
import re
import subprocess

import pytest

from harness.plants import STRICT, replaced
from lab import cost

PENDULUM = cost.PENDULUM.read_text()
M4F = '-mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16'.split()
EVERY = set('derivative finish iso_the_derivative_float iso_the_plant_float memory output plant_derivative plant_model start step'.split())
EFFECTS = {name: cost.with_effect(PENDULUM, inside, statement) for name, inside, statement in cost.listed_effects()}
# The symbols beside those of every plant, and the bytes of memory: two states, six outputs, and the six that are
# published while one is not finite; a sine and a cosine, which outputs and the next step share.
PLAIN = 'prime range', 64
HOLDS = {
    'damping, tunable': ('admit amiss defaults prime range', 72),
    # The last sample, three differences, and whether there is one.
    'input, smooth': ('admit amiss prime range', 92),
    # An input and its last good value; one that nobody drives is the port's.
    'input': ('admit amiss prime range', 72),
    # An angle that is kept within a turn has no range to be guarded, and no sine that is shared.
    'continuous': ('', 64),
    'continuous, output of turns': ('', 72),
    'output of acceleration': ('prime range', 72),
    "output of a point's velocity": ('prime range', 88),
    # What rounding took of two states; three sums of derivatives of two states, and four words of progress.
    'compensated sums': ('prime range', 72),
    'steps checked': ('derivative_by_sines iso_plant_tell derivative_prepared prime range', 104),
}


@pytest.fixture(scope='module')
def thing(isoc):
    """thing(scene, ...): the object of its plant."""
    @functools.cache
    def compiled(scene, *options):
        made = isoc(scene, *options, '--real', 'float')
        assert made.status == 0, made.errors
        place = made.folder / 'plant.o'
        subprocess.run(['arm-none-eabi-gcc', *STRICT, *M4F, '-I.', '-c', made.folder / 'plant.c', '-o', place], check=True)
        return place
    return compiled


def bytes_of(place):
    return place.read_bytes()


def nm(*words):
    return subprocess.run(['arm-none-eabi-nm', *words], capture_output=True, text=True, check=True).stdout


def contents(place):
    """The symbols of an object, without what the compiler adds to their names, and the bytes of all that its plant keeps."""
    lines = [line.split() for line in nm('-S', place).splitlines()]
    return {line[-1].split('.')[0] for line in lines}, next(int(line[1], 16) for line in lines if line[-1] == 'memory')


def expected(words, memory):
    return EVERY | set(words.split()), memory


def of_effect(name):
    return HOLDS.get(name) or (('admit amiss drive prime range', 72) if name.startswith('input, ') else PLAIN)


def commented_out(scene):
    """With each line as a comment that the pendulum has not."""
    known = PENDULUM.splitlines()
    return ''.join(f'{line}\n' if line in known else f'# {line}\n' for line in scene.splitlines())


def test_a_plant_without_effects_needs_nothing_of_others(thing):
    assert contents(thing(PENDULUM)) == expected(*PLAIN)
    assert nm('-u', thing(PENDULUM)) == ''


@pytest.mark.parametrize('pattern, by', [
    ('axis z', r'\g<0>; damping 0 N*m*s/rad; spring 0 N*m/rad rest 10 deg'),
    ('^method rk4', r'\g<0>\nconstant resistance = 0.1 N*m*s/rad')], ids=['damping and a spring of zero', 'an unused constant'])
def test_what_is_not_there_in_the_end_costs_nothing(thing, pattern, by):
    assert bytes_of(thing(replaced(pattern, by, PENDULUM))) == bytes_of(thing(PENDULUM))


def test_gravity_of_zero_is_none(thing):
    zero, none = (thing(replaced('^gravity.*\n', by, PENDULUM)) for by in ('gravity (0, 0, 0) m/s^2\n', ''))
    assert bytes_of(zero) == bytes_of(none) != bytes_of(thing(PENDULUM))


@pytest.mark.parametrize('name', EFFECTS)
def test_an_effect_that_is_named_is_there_and_commented_out_it_is_not(thing, name):
    assert len(EFFECTS) >= 8 and set(HOLDS) <= set(EFFECTS)
    assert bytes_of(thing(EFFECTS[name])) != bytes_of(thing(PENDULUM))
    off = commented_out(EFFECTS[name])
    assert re.search('^# ', off, re.M) and bytes_of(thing(off)) == bytes_of(thing(PENDULUM))
    assert contents(thing(EFFECTS[name])) == expected(*of_effect(name))


@pytest.mark.parametrize('method, words, memory', [
    # Three older derivatives of two states has the method with a history.
    ('euler', 'range', 56), ('heun', 'prime range', 64), ('ab4', 'prime range', 80)])
def test_a_method_keeps_what_it_needs(thing, method, words, memory):
    assert contents(thing(PENDULUM, '--method', method)) == expected(words, memory)
