"""`make install`: a user with a folder of his own, and no checkout, makes, runs, shows and links a scene."""
import os
import subprocess

import pytest

from harness.project import ROOT

CONTROLLER = '''import arm_link as plant

with plant.Link() as link:
    y = link.start("lockstep", 500)
    while y:
        y = link.exchange(push=-0.1 * y.rate)
'''


@pytest.fixture(scope='module')
def user(tmp_path_factory):
    """What a command says in an empty folder, with nothing of the checkout in its environment."""
    place = tmp_path_factory.mktemp('install')
    environment = {name: value for name, value in os.environ.items() if not name.startswith(('MAKE', 'TEST_', 'PYTHON'))}
    subprocess.run(['make', '-s', 'install', f'DESTDIR={place}', 'PREFIX=/usr'], cwd=ROOT, check=True, env=environment)
    home = place / 'home'
    home.mkdir()
    environment['PATH'] = f'{place}/usr/bin:' + environment['PATH']

    def call(*words, **how):
        return subprocess.run(words, cwd=home, text=True, stdin=subprocess.DEVNULL, env=environment,
                              capture_output=True, **how)

    call.home, call.root = home, place / 'usr'
    call.installed = state(call.root)
    return call


def state(folder):
    return {path: path.lstat().st_mtime_ns for path in folder.rglob('*')}


def said(done):
    assert done.returncode == 0, done.stderr
    return dict(line.split(' ', 1) for line in done.stdout.splitlines() if ' ' in line)


def test_what_stands_where_a_packager_expects_it(user):
    root = user.root
    assert sorted(path.name for path in root.iterdir()) == ['bin', 'lib', 'share']
    assert sorted(path.name for path in (root / 'bin').iterdir()) == ['isoc', 'isochron']
    assert (root / 'share/man/man1/isochron.1').read_text().startswith('.TH ISOCHRON 1')
    assert (root / 'share/bash-completion/completions/isochron').exists()
    assert str(ROOT) not in ''.join(path.read_text(errors='replace') for path in (root / 'lib').rglob('*.py'))
    assert said(user('isoc', '--version')) is not None


def test_a_scene_of_his_own(user):
    assert said(user('isochron', 'new', 'arm'))['scene'] == 'arm.scene'
    ran = said(user('isochron', 'run', 'arm.scene'))
    assert ran['trace'] == 'build/host/float/arm/trace.csv' and len(ran['hash']) == 16
    if subprocess.run(['which', 'arm-none-eabi-gcc', 'qemu-system-arm'], capture_output=True).returncode == 0:
        assert said(user('isochron', 'run', 'arm.scene', '--target', 'cortex-m4f'))['hash'] == ran['hash']
    said(user('isochron', 'show', 'arm.scene', '--seconds', '1'))
    assert 'arm' in (user.home / 'build/host/float/arm/show.html').read_text()
    said(user('isochron', 'python', 'arm.scene'))
    said(user('isochron', 'fmu', 'arm.scene'))
    said(user('isochron', 'effects', 'drag'))
    assert 'needs its sources' in user('isochron', 'digits').stderr


def test_a_controller_of_his_own(user):
    (user.home / 'arm.scene').unlink(missing_ok=True)
    user('isochron', 'new', 'arm')
    scene = user.home / 'arm.scene'
    text = scene.read_text().replace('joint pivot revolute {', 'input push safe 0 after 5 ticks\njoint pivot revolute {\n    drive push')
    scene.write_text(text + 'output rate = speed of pivot\n')
    (user.home / 'controller.py').write_text(CONTROLLER)
    linked = said(user('isochron', 'link', 'arm.scene', '--seconds', '0.5', '--controller', 'python3 controller.py'))
    assert linked['link_inputs'] == '500'


def test_nothing_is_written_but_to_the_folder_of_the_user(user):
    assert state(user.root) == user.installed
    assert {path.name for path in user.home.iterdir()} <= {'arm.scene', 'controller.py', 'build'}
