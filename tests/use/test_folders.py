"""Where what is made of a scene stands: whatever its path, its own folder; several commands at once do not meet there."""
import os
import pathlib
import re
import shutil
import subprocess

import pytest

from harness.project import ROOT

SCENE = ROOT / 'models/pendulum.scene'
RUNS = [f'S {words}' for words in ('--method rk4', '--method heun', '--method bdf4', '--step 2ms', '--step 4ms', '--real double')] + [
    'a/pendulum.scene', 'b/pendulum.scene']


def scene_at(path, start=90):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(SCENE.read_text().replace('start 90 deg', f'start {start} deg'))
    return path


@pytest.mark.parametrize('name', ["a $b #c'd (e)/x$y z.scene", 'ä/ö.scene', 'n' * 130 + '.scene', '.scene', '-x.scene',
                                  'two\nlines.scene'])
def test_any_path_has_the_hash_of_the_plain_one(isochron, laboratory, name):
    plain = isochron('run', SCENE, '--seconds', 0.1).said['hash']
    path = scene_at(laboratory / 'strange' / name)
    said = isochron('run', path, '--seconds', '0.1')
    assert said.status == 0, said.errors
    assert said.said['hash'] == plain


@pytest.mark.parametrize('folder', ['plain', "o'f $HOME (x)"])
def test_from_any_folder(isochron, laboratory, folder):
    plain = isochron('run', SCENE, '--seconds', 0.1).said['hash']
    place = laboratory / folder
    shutil.rmtree(place, ignore_errors=True)
    scene_at(place / 'arm.scene')
    said = isochron('run', 'arm.scene', '--seconds', 0.1, cwd=place)
    assert said.status == 0, said.errors
    assert said.said['hash'] == plain and said.said['trace'] == 'build/host/float/arm/trace.csv'
    assert isochron('run', 'arm.scene', '--seconds', 0.1, '--out', 'here', cwd=place).said['trace'] == 'here/trace.csv'
    assert sorted(path.name for path in place.iterdir()) == ['arm.scene', 'build', 'here']


def test_scenes_of_one_name_have_folders_of_their_own(isochron, laboratory):
    traces = {isochron('run', scene, '--seconds', 0.1).said['trace']
              for scene in (SCENE, scene_at(laboratory / 'a/pendulum.scene', 80), scene_at(laboratory / 'b/pendulum.scene', 70))}
    assert len(traces) == 3 and 'build/host/float/pendulum/trace.csv' in traces


def start(words, place, environment=None):
    words = [str(SCENE) if word == 'S' else word for word in words.split()]
    return subprocess.Popen([ROOT / 'tools/isochron', 'run', *words, '--seconds', '0.2'], cwd=place, text=True,
                            stdout=subprocess.PIPE, stderr=subprocess.PIPE, env={**os.environ, **(environment or {})})


def hashes(processes):
    return [re.findall('^hash (.*)', process.communicate()[0], re.M) for process in processes]


def test_commands_at_once_have_each_the_hash_of_its_own_run(laboratory, tmp_path):
    scene_at(tmp_path / 'a/pendulum.scene', 80), scene_at(tmp_path / 'b/pendulum.scene', 70)
    alone = [hashes([start(words, tmp_path)])[0] for words in RUNS]
    assert len({value for value, in alone}) == len(RUNS)
    shutil.rmtree(tmp_path / 'build/host')
    assert hashes([start(words, tmp_path) for words in RUNS for _ in range(3)]) == [value for value in alone for _ in range(3)]

    # Control: without a lock they meet.
    unlocked = tmp_path / 'unlocked/sitecustomize.py'
    unlocked.parent.mkdir()
    unlocked.write_text('import fcntl\nfcntl.flock = lambda file, how: None\n')
    for _ in range(3):
        shutil.rmtree(tmp_path / 'build/host', ignore_errors=True)
        met = hashes([start(words, tmp_path, {'PYTHONPATH': str(unlocked.parent)}) for words in RUNS for _ in range(3)])
        if met != [value for value in alone for _ in range(3)]:
            return
    pytest.fail('commands without locks do not meet')


def test_an_end_by_the_user_leaves_whole_files(laboratory, tmp_path):
    """Ended at any time, the folder has what was there before, or what is new, and the next run is right."""
    right = hashes([start('S', tmp_path)])[0]
    for after in (0.05, 0.15, 0.25, 0.4):
        process = start('S --method heun', tmp_path)
        try:
            process.wait(after)
        except subprocess.TimeoutExpired:
            process.send_signal(2)
        process.communicate()
        left = {path.name for path in pathlib.Path(tmp_path).rglob('*') if path.name.startswith('.isoc')}
        assert not left and hashes([start('S', tmp_path)])[0] == right
