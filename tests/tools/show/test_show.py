"""isochron show: the page of a scene in a browser without a window (browser.py). It plays, scrubs, turns, has its plots with
a cursor, in light and dark, narrow and wide; its bodies are where the outputs of the scene have them; a still has the same
polygons; a page with a fault, and a machine without a browser, are found."""
import re
import shutil
import sys
import types

import pytest

from harness.programs import path_of, run, traced
from harness.project import ROOT

MODELS = ROOT / 'models'
PENDULUM = MODELS / 'double_pendulum.scene'
FOLDER = 'build/host/float/double_pendulum'


@pytest.fixture(scope='module')
def pages(isochron, tmp_path_factory):
    """A folder with pages of one run, of three, of which one is in double, and with one that was kept; a still; and a page
    with a fault."""
    folder = tmp_path_factory.mktemp('pages')
    work = tmp_path_factory.mktemp('work')

    def show(name, *words):
        of = isochron('show', PENDULUM, '--seconds', 2, *words, cwd=work)
        assert of.status == 0, of.errors
        for kind in ('html', 'svg'):
            if (work / FOLDER / f'show.{kind}').exists():
                shutil.copy(work / FOLDER / f'show.{kind}', folder / f'{name}.{kind}')

    show('several', '--against', '--real double | --method heun --step "4 ms"')
    show('single')
    show('single', '--still', '0.3')
    before = isochron('run', PENDULUM, '--step', '4ms', '--seconds', 1, '--keep', 'before', cwd=work)
    assert before.status == 0
    show('kept', '--against', 'before | --real double')
    page = (folder / 'single.html').read_text()
    path_of(re.sub(r'^setPlaying\(false\);', 'setPlaying(false); missing();', page, flags=re.M), folder, 'fault.html')
    return types.SimpleNamespace(folder=folder, work=work, page=page)


def test_a_page_needs_nothing_but_itself(pages):
    """A scene with poses names the folder of the project nowhere, whose name may be no ASCII text."""
    assert not re.search(r'://|src=|@import|fetch\(', pages.page)
    assert re.search(r'^include "\.\./', (pages.work / FOLDER / 'show/1/double_pendulum.scene').read_text(), re.M)


def test_told_what_is_no_option_and_a_plant_in_c(isochron):
    for words, said in (([PENDULUM, '--against', 'rub'], "'rub' is no option of a run"), ([MODELS / 'oscillator.c'], 'show is for scenes')):
        of = isochron('show', *words)
        assert of.status != 0 and said in of.errors


@pytest.mark.parametrize('scene, edits, seconds, said', (
    ('parallelogram', {'^stabilisation.*\n': '', r'\Z': 'stabilisation projection { near stop }\n'}, 1,
     r'the run ends at 0[.]5.* s: the guard stopped it: near a singular position of closure follower_pin$'),
    ('double_pendulum', {'^method .*': 'method euler', '^step .*': 'step 0.3 s'}, 60,
     'the run ends at .* s: the guard stopped it: state ')))
def test_a_run_that_its_guard_ends_is_shown_until_then_and_why(isochron, tmp_path, scene, edits, seconds, said):
    """Near a singular position, or a state that is not finite."""
    text = (MODELS / f'{scene}.scene').read_text()
    for old, new in edits.items():
        text = re.sub(old, new, text, flags=re.M)
    of = isochron('show', path_of(text, tmp_path, 'guard.scene'), '--seconds', seconds)
    assert of.status == 0 and re.search(said, of.errors, re.M), of.errors


def test_what_is_shown_is_the_run_of_the_scene_bit_for_bit(pages, isochron, tmp_path):
    """The same outputs as of the scene without poses: the hash is over the states."""
    of = isochron('run', PENDULUM, '--seconds', 2)
    shown = traced(tmp_path, pages.work / FOLDER / 'show/1/program', 2 * 10**9)
    assert shown.said['hash'] == of.said['hash']


def test_in_a_browser(pages, proves):
    proves(sys.executable, 'tests/tools/show/pages.py', pages.folder)


def test_found_a_machine_without_a_browser_which_is_no_reason_to_skip(pages, tmp_path):
    done = run(sys.executable, 'tests/tools/show/pages.py', pages.folder, PATH=str(tmp_path))
    assert done.status != 0 and 'apt-get install chromium-headless-shell' in done.printed + done.errors
