"""All effects of the library in one scene: the same bits on host and board, one number of instructions for every step, through
slip and rest, impacts, limits and faults; losses that are never negative; and no number that nothing has set."""
import pathlib
import re
import subprocess

import pytest
from harness import project
from harness.plants import compiled, other_effect, replaced

PLACE = pathlib.Path('tests/isoc/effects/all.scene')
SCENE = PLACE.read_text()
LIBRARY = pathlib.Path('models/effects')
USES = dict(re.findall(r'^effect (\w+) (\w+) \{', SCENE, re.M))


def test_the_scene_has_all_effects_of_the_library():
    """But for those with events, which not every method has: test_rigid.py, test_holds.py."""
    kinds = {path.stem for path in LIBRARY.glob('*.scene') if not re.search('^ *(when|hold) ', path.read_text(), re.M)}
    assert kinds <= set(USES.values()) and len(kinds) > 30


def test_the_board_has_the_bits_of_the_host_and_every_step_the_same_instructions(isochron):
    """Five seconds; once in eight turns a minute."""
    seconds = 5 if project.turn(8) else 60
    host, board = (isochron('run', PLACE.resolve(), '--target', target, '--seconds', str(seconds)).said for target in ('host', 'cortex-m4f'))
    assert host['ticks'] == board['ticks'] == f'{seconds}000' and host['hash'] == board['hash']
    least, mean, most, unit = board['execution'].split()
    assert float(least) == float(mean) == float(most) and unit == 'instructions'


# --- losses ---


def losing():
    """Each use of a kind whose file says a loss that is not 0."""
    for use, kind in USES.items():
        loss = re.search(r'^ *loss = (.*)', (LIBRARY / f'{kind}.scene').read_text(), re.M)
        if loss and not loss[1].startswith('0 W'):
            yield use


def losses(plant, definitions=''):
    """Of five seconds, by use."""
    shown = ''.join(f'output loss_{use} = loss of {use}\n' for use in losing())
    y = plant(SCENE + shown + definitions).follow(5000).y
    return {use: y[f'loss_{use}'] for use in losing()}


def test_no_effect_of_the_library_turns_heat_into_work(plant):
    """Rounding: where a loss is a difference of what is far larger, an epsilon of that, compared by the largest loss."""
    found = losses(plant)
    assert len(found) > 10
    for use, loss in found.items():
        assert loss.max() > 0 and loss.min() >= -1e-9 * loss.max(), use


def test_losses_of_the_wrong_sign_are_found(plant):
    turned = ''.join(other_effect(kind, r'^( *)loss = ([^#\n]*[^#\s])', r'\1loss = -(\2)') for kind in {USES[use] for use in losing()})
    assert all(loss.min() < 0 for loss in losses(plant, turned).values())


# --- memcheck ---

MAIN = '''#include "plant.c"

#include "core/runtime/tick.h"

int main(void)
{
    unsigned bad = 0;
    iso_plant_start(&iso_the_plant);
    for (uint64_t tick = 0; tick < 200; tick++) {
        bad += iso_plant_tick(&iso_the_plant, tick) != iso_the_plant.model->states ? 1U : 0U;
    }
    for (int i = 0; i < PLANT_OUTPUTS; i++) {
        bad += iso_the_plant.y[i] > R(1e30) ? 1U : 0U;
    }
    return bad == 0 ? 0 : 1;
}
'''
WATCHED = sorted(path for path in pathlib.Path('tests/isoc/effects').glob('*.scene') if path.stem not in ('cell', 'price'))
TURN = project.turn(len(WATCHED), pathlib.Path(__file__))


def watched(isoc, scene, real, change=None):
    """What memcheck says of 200 ticks."""
    files = {**isoc(scene, '--real', real).files(), 'main.c': MAIN}
    files['plant.c'] = change(files['plant.c']) if change else files['plant.c']
    program = compiled('gcc', files, 'main.c', '-O0', '-g', *['-DISO_REAL_DOUBLE'] * (real == 'double'), kind='')
    done = subprocess.run(['valgrind', '--quiet', '--error-exitcode=99', program], capture_output=True, text=True)
    return done.stderr if done.returncode else ''


@pytest.mark.parametrize('real', ['float', 'double'])
@pytest.mark.parametrize('path', WATCHED if TURN is None else [WATCHED[TURN]], ids=lambda path: path.stem)
def test_memcheck_finds_nothing(isoc, path, real):
    """By turns; promises/poison.t watches all.scene."""
    assert watched(isoc, path, real) == ''


def test_memcheck_finds_a_number_that_nothing_has_set(isoc):
    def unset(text):
        return replaced(r'\A((?:.|\n)*?)const real t1 = ', r'\1real none[1]; const real *volatile where = none; '
                        r'const real t1 = R(0.0) * where[0] + ', text)

    assert 'uninitialised' in watched(isoc, pathlib.Path('tests/isoc/effects/ground.scene'), 'float', unset)
