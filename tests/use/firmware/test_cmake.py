"""The folder of a plant as a package of CMake: installed, a project in a folder of its own finds it by its name and its
version, and runs it."""
import pathlib
import subprocess

import pytest

PROJECT = '''cmake_minimum_required(VERSION 3.13)
project(user C)
find_package(swing {version} REQUIRED)
add_executable(user main.c)
target_link_libraries(user swing::swing)
'''
PROGRAM = '''#include <swing.h>
#include <core/runtime/tick.h>
int main(void)
{
    static swing_memory memory;
    const iso_plant swing = swing_plant(&memory);
    return !iso_plant_start(&swing) || iso_plant_tick(&swing, 0) != SWING_STATES;
}
'''
SCENES = {'without a root': (pathlib.Path('models/pendulum.scene'), 'float'),
          'with a root': (pathlib.Path('tests/isoc/formula/functions/all.scene'), 'double')}


def cmake(*words):
    return subprocess.run(['cmake', *words], capture_output=True, text=True)


def used(place, version='1.0'):
    """What becomes of a project that wants this version of what is installed in place/prefix."""
    user = place / 'user'
    user.mkdir(exist_ok=True)
    (user / 'CMakeLists.txt').write_text(PROJECT.format(version=version))
    (user / 'main.c').write_text(PROGRAM)
    said = cmake('-S', user, '-B', user / version, f'-DCMAKE_PREFIX_PATH={place / "prefix"}')
    if said.returncode == 0:
        said = cmake('--build', user / version)
    if said.returncode == 0:
        said = subprocess.run([user / version / 'user'], capture_output=True, text=True)
    return said


@pytest.fixture(scope='module', params=SCENES)
def installed(isoc, request, tmp_path_factory):
    """The folder with `prefix`, where the plant is installed; the folder of its sources is gone."""
    scene, real = SCENES[request.param]
    place = tmp_path_factory.mktemp('cmake')
    made = isoc(scene, '--name', 'swing', '--real', real, '--standalone')
    assert made.status == 0, made.errors
    made.folder.rename(place / 'swing')
    for words in (('-S', place / 'swing', '-B', place / 'build', '-DCMAKE_BUILD_TYPE=Release'), ('--build', place / 'build'),
                  ('--install', place / 'build', '--prefix', place / 'prefix')):
        said = cmake(*words)
        assert said.returncode == 0, said.stdout + said.stderr
    (place / 'swing').rename(place / 'moved')
    return place


def test_a_project_finds_it(installed):
    said = used(installed)
    assert said.returncode == 0, said.stdout + said.stderr


def test_another_version_is_not_found(installed):
    said = used(installed, '2.0')
    assert said.returncode != 0 and 'version: 1.0.0' in said.stderr


def test_found_a_package_without_its_headers(installed):
    header = installed / 'prefix/include/swing/core/runtime/tick.h'
    header.rename(header.with_suffix('.gone'))
    said = used(installed, '1')
    assert said.returncode != 0 and 'tick.h' in said.stdout + said.stderr
    header.with_suffix('.gone').rename(header)
