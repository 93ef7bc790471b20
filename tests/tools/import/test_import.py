"""isochron import: robots of URDF, MJCF. Files of the project, of which all is taken or named; files that are wrong; and
random ones, whose accelerations are those of dynamics.py and, where Debian's libmujoco-dev is there, of libmujoco, to 1e-9.
Ten of a hundred random robots by turns."""
import re

import pytest

from harness.plants import COMPILERS
from harness.programs import run
from harness.project import ROOT, turn

HERE = ROOT / 'tests/tools/import'
ISOC = ROOT / 'build/isoc'
SCENES = [HERE / 'export.scene', *(ROOT / f'models/{name}.scene' for name in (
    'double_pendulum', 'arm6', 'tree', 'quadrotor', 'bricard', 'n_four_bar'))]
HAS_MUJOCO = run('gcc', '-E', '-x', 'c', '-', given='#include <mujoco/mujoco.h>\n').status == 0
MUJOCO = (['-DMUJOCO'], ['-lmujoco']) if HAS_MUJOCO else ([], [])


def tried():
    """The first seed, and how many."""
    now = turn(10)
    return (0, 100) if now is None else (10 * now, 10)


def written(script, *words):
    done = run('python3', HERE / script, *words)
    assert done.status == 0, done.printed + done.errors
    return done


def compared(folder, *words):
    """The program that compares, of what was written into a folder; kernels and steps are not run."""
    flags, libraries = MUJOCO
    done = run(*COMPILERS['tcc'], '-std=c11', '-I.', '-DISO_UNROLL=', '-DISO_REAL_DOUBLE', *flags, f'-I{folder}', HERE / 'compare.c',
               '-o', folder / 'compare', *libraries, '-lm')
    assert done.status == 0, done.errors
    return run(folder / 'compare', *words)


def is_also_by_mujoco(done):
    return not HAS_MUJOCO or ' also by libmujoco' in done.printed and '; 0 also' not in done.printed


@pytest.mark.parametrize('family', ('usual', 'odd'))
def test_the_accelerations_of_random_robots_are_right(tmp_path, family):
    """And those of libmujoco."""
    first, count = tried()
    written('write_robots.py', tmp_path, family, first, count)
    done = compared(tmp_path)
    assert done.status == 0, done.printed + done.errors
    assert is_also_by_mujoco(done), done.printed


@pytest.mark.skipif(not HAS_MUJOCO, reason='libmujoco-dev is not installed')
def test_libmujoco_has_them_too(tmp_path):
    written('write_robots.py', tmp_path, 'usual', tried()[0], 2)
    assert is_also_by_mujoco(compared(tmp_path))


@pytest.mark.parametrize('family, pattern', (
    ('usual', r'/gravity \(/gravity (1e-6 + /'), ('usual', r'/(?m)child (\w+)$/child \1 at (0, 0, 1e-6) m/'),
    ('odd', r'/inertia \(/inertia (1e-6 + /'), ('odd', '/spin_armature /spin_armature 1.00001 * /'),
    ('odd', r'/(?m)^( +)stiffness (?=\d)/\1stiffness 1.00001 * /'), ('odd', r'/lift \(/lift (1e-6 + /'),
    ('odd', r'/most (?=\S+ N.m)/most 1.00001 * /'), ('odd', '/bias_by_rate (?=-)/bias_by_rate 1.00001 * /')))
def test_found_an_error_of_an_import_that_is_just_above_the_tolerance(tmp_path, family, pattern):
    """Gravity that is 1e-6 m/s^2 more, a body that is 1 um beside its place, an inertia that is 1e-6 kg*m^2 beside what is
    written, armatures of balls and limits of actuators and springs and dampings that are 10 ppm larger, a lift that is a
    millionth of a newton more."""
    written('write_robots.py', tmp_path, family, tried()[0], 8, pattern)
    done = compared(tmp_path, 1)
    assert done.status == 0, done.printed + done.errors


def test_out_to_mjcf_and_back_the_plant_has_the_same_accelerations(tmp_path):
    """Scenes, and random ones with all that MJCF can say. Limits act in no state of these: they are compared as they are
    written. Control: what comes back has other gravity."""
    first, count = tried()
    written('write_exports.py', tmp_path, first // 2, count // 2, *SCENES)
    done = compared(tmp_path)
    assert done.status == 0, done.printed + done.errors
    assert is_also_by_mujoco(done), done.printed
    numbers = '([^ ]*)'
    limits = sorted(tuple(map(float, found)) for path in tmp_path.glob('seed*.scene') for found in re.findall(
        f'^effect e_ends .*lower {numbers} .*upper {numbers} ', path.read_text(), re.M))
    exports = sorted(tmp_path.glob('e*.xml'))
    ranges = sorted(tuple(map(float, found.split())) for path in exports for found in re.findall(
        ' range="([^"]*)"', path.read_text()))
    assert limits and len(limits) == len(ranges)
    assert all(abs(a - b) < 1e-12 for limit, other in zip(limits, ranges) for a, b in zip(limit, other))
    assert not any('; the ' in path.read_text().splitlines()[0] for path in exports)      # all is said
    again = tmp_path / 'e0_again/e0_again.c'
    text = again.read_text()
    assert '9.81)' in text
    again.write_text(text.replace('9.81)', '9.8100001)'))
    robots = (tmp_path / 'robots.h').read_text()
    robots = re.sub('.*#include "e[1-9].*\n', '', robots)
    (tmp_path / 'robots.h').write_text(re.sub(r'robots\[\] = \{(ROBOT_E0),.*', r'robots[] = {\1};', robots))
    assert compared(tmp_path, 1).status == 0


def test_what_mjcf_cannot_say_is_refused_or_named():
    screw = run(ISOC, 'tests/isoc/mechanism/lead_screw.scene', '--mjcf')
    assert screw.status != 0 and screw.printed == '' and 'error: MuJoCo has no screw' in screw.errors
    assert re.search('^<!-- pump.scene.*; the closure motor', run(ISOC, 'models/pump.scene', '--mjcf').printed, re.M)
    drive = re.search('^<!-- cart_pole_drive.scene.*; the effect rub;.*', run(ISOC, 'models/cart_pole_drive.scene', '--mjcf').printed, re.M)
    assert '; the effect ends' not in drive[0]


@pytest.mark.parametrize('script', ('refused.py', 'named.py'))
def test_files_that_are_wrong_and_what_is_not_taken(tmp_path, script):
    """They are refused; and it has its reason."""
    written(script, tmp_path)


def test_of_files_with_changes_each_is_taken_or_refused(tmp_path):
    first, count = tried()
    written('mutated.py', tmp_path, first // 10, 100 * count)


@pytest.mark.parametrize('name', ('arm.urdf', 'rig.xml'))
def test_of_the_projects_own_files_all_that_is_not_taken_is_named_and_their_scenes_are_compiled(isochron, isoc, tmp_path, name):
    scene = tmp_path / f'{name}.scene'
    of = isochron('import', HERE / name, '-o', scene)
    assert of.status == 0, of.errors
    assert of.printed[of.printed.index('Not taken'):] == (HERE / f'{name.split(".")[0]}.not_taken').read_text()
    assert isoc(scene).status == 0
