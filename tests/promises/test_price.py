"""Absence costs nothing: a scene without an effect (isoc --without) gives the bytes of an isoc whose library lacks it.
(What each effect costs: tests/tools/lab/test_price.py.)"""
import functools
import pathlib
import re
import subprocess

import pytest

from harness.project import ROOT, make, turn

OBJECTS = ROOT / 'build/obj/tools/isoc'
KINDS = sorted(path.stem for path in ROOT.glob('models/effects/*.scene'))
PRICE = (ROOT / 'tests/isoc/effects/price.scene').read_text()
LOST = [('^output lost.*', ''), ('^signal loss.*', '')]
# What of the scene reads an effect, besides its own line.
READS = {
    'drive': ('dc_motor', [('^at 2 s.*', ''), ('^output current.*', ''), *LOST, (r'drive\.current', '0 A')]),
    'sense': ('current_sense', [('^output measured.*', '')]),
    'bearing': ('friction', [('^output shaken.*', ''), *LOST]),
    'ends': ('stop', []),
    'slow': ('lag', [('^output slow.*', ''), (r'slow\.value', '0 m/s')]),
}
MODELS = 'pendulum dc_motor_bench quarter_car cart_pole_drive hopper crane'.split()


@pytest.fixture(scope='module')
def lacking(tmp_path_factory):
    """lacking(kind, ...): an isoc whose library has not the files of these kinds."""
    make('tools')

    @functools.cache
    def linked(*kinds):
        folder = tmp_path_factory.mktemp('isoc')
        files = [f'models/effects/{kind}.scene' for kind in KINDS if kind not in kinds]
        text = subprocess.run(['awk', '-f', 'tools/build/embed.awk', 'effect_files', *files], capture_output=True, check=True).stdout
        (folder / 'effect_files.c').write_bytes(text)
        objects = [path for path in OBJECTS.glob('*.o') if path.name != 'effect_files.o']
        subprocess.run(['gcc', '-std=c11', '-I.', folder / 'effect_files.c', *objects, '-o', folder / 'isoc', '-lm'], check=True)
        return folder / 'isoc'
    return linked


def by(program, scene, folder):
    """What an isoc of its own makes of a text or a Path: its status, what it printed and said, and its plant."""
    folder.mkdir()
    if not isinstance(scene, pathlib.Path):
        (folder / 'plant.scene').write_text(scene)
        scene = folder / 'plant.scene'
    done = subprocess.run([program, scene, '-o', folder / 'made'], capture_output=True, text=True)
    files = [(folder / 'made' / name).read_text() for name in ('plant.c', 'plant.h')] if done.returncode == 0 else None
    return done, files


def plant_of(made):
    assert made.status == 0, made.errors
    return [made.file('plant.c'), made.file('plant.h')]


def edited(text, changes):
    for pattern, new in changes:
        text = re.sub(pattern, new, text, flags=re.M)
    return text


def test_isoc_lists_the_effects(isoc):
    assert isoc(PRICE, '--effects', writes=False).printed.split() == (
        'drive dc_motor sense current_sense bearing friction ends stop slow lag'.split())


@pytest.mark.parametrize('effect', READS)
def test_without_an_effect_a_plant_has_the_bytes_of_an_isoc_that_lacks_it(isoc, lacking, tmp_path, effect):
    """Others read the lag, whose state has its dimension by what it reads: that can stand at another place, so that only the
    counts are the same."""
    kind, changes = READS[effect]
    refused, _ = by(lacking(kind), PRICE, tmp_path / 'refused')
    assert refused.returncode == 1 and f"no effect of the kind '{kind}' is defined" in refused.stderr
    done, written = by(lacking(kind), edited(PRICE, [(f'^effect {effect}.*', ''), *changes]), tmp_path / 'written')
    left = isoc(PRICE, '--without', effect)
    assert written == plant_of(left) or effect == 'slow'
    assert done.returncode == 0 and done.stdout == left.printed
    assert plant_of(left) != plant_of(isoc(PRICE)), 'control'


def test_without_any_it_has_the_bytes_of_an_isoc_that_lacks_all(isoc, lacking, tmp_path):
    changes = [('^effect.*', ''), ('^at.*', ''), ('^signal [sl].*', ''), ('^output [lms].*', ''), ('^output current.*', '')]
    _, written = by(lacking(*(kind for kind, _ in READS.values())), edited(PRICE, changes), tmp_path / 'written')
    assert written == plant_of(isoc(PRICE, '--without', '; '.join(READS)))


def test_an_input_that_only_the_effect_reads_is_left_out_with_it(isoc):
    made = isoc(edited(PRICE, [('^output wanted.*', ''), ('^signal bare.*', '')]), '--without', 'drive')
    assert made.summary['inputs'] == '1'


def test_an_output_stays_and_is_zero_where_the_scene_shows_nothing_else(isoc):
    made = isoc(edited(PRICE, [('^output(?!.*measured).*\n', '')]), '--without', 'drive; sense')
    assert made.summary['outputs'] == '1' and 'y[PLANT_Y_MEASURED] = R(0' in made.file('plant.c')


def of_turn():
    """An eighth of the kinds of the library."""
    now = turn(8, pathlib.Path(__file__))
    return [kind for number, kind in enumerate(KINDS) if now is None or number % 8 == now]


@pytest.mark.parametrize('kind', of_turn())
def test_an_isoc_that_lacks_a_kind_refuses_the_models_that_use_it_and_writes_the_others(isoc, lacking, tmp_path, kind):
    """To the same bytes of plant, which is all that firmware follows from."""
    equal = 0
    for model in MODELS:
        scene = ROOT / f'models/{model}.scene'
        done, written = by(lacking(kind), scene, tmp_path / model)
        if done.returncode == 0:
            assert written == plant_of(isoc(scene)), model
            equal += 1
        else:
            assert f"no effect of the kind '{kind}' is defined" in done.stderr, model
    assert equal


@pytest.mark.parametrize('words, said', [
    ('drve', "--without:1:1: error: no effect is called 'drve' (did you mean 'drive'?)"),
    ('drive ends', "--without:1:7: error: expected ; and a further effect; found 'ends'"),
    ('drive; 3', "--without:1:8: error: expected the name of an effect; found '3'")])
def test_what_is_no_list_of_effects_is_refused(isoc, words, said):
    made = isoc(PRICE, '--without', words)
    assert made.refused and said in made.errors.splitlines()
