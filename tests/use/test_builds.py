"""A command builds what a change asks for, and nothing else; `make run` and isochron alike."""
import os
import resource
import shutil
import subprocess

import pytest

from harness.project import ROOT

PLANT = 'build/host/float/double_pendulum'
LOOP = 'build/obj/host/float/core/runtime/loop.o'


class Copy:
    """A copy of the sources, with the tools that are built; `call` returns the files of build/ that it made anew."""

    def __init__(self, place):
        self.place = place
        for name in ('Makefile', 'core', 'models', 'port', 'tools', 'tests/tests.mk', 'build/isoc', 'build/trace', 'build/obj/tools'):
            (place / name).parent.mkdir(parents=True, exist_ok=True)
            subprocess.run(['cp', '-a', ROOT / name, place / name], check=True)

    def state(self):
        return {str(path.relative_to(self.place)): (path.stat().st_ino, path.stat().st_mtime_ns)
                for path in (self.place / 'build').rglob('*') if path.is_file()}

    def call(self, *words, **environment):
        before = self.state()
        environment = {**{name: value for name, value in os.environ.items() if not name.startswith(('MAKE', 'TEST_'))}, **environment}
        command = ['make', *words] if words[0] == 'run' and len(words) == 1 else ['tools/isochron', *words]
        done = subprocess.run(command, cwd=self.place, capture_output=True, text=True, env=environment)
        self.status, self.said = done.returncode, done.stdout + done.stderr
        after = self.state()
        runs = ('trace.csv', 'units.csv', 'last.txt', 'summary.txt', 'plant.txt', '/lock')
        return {name for name in after if before.get(name) != after[name] and not name.endswith(runs)}

    def edit(self, name, old='', new=''):
        path = self.place / name
        text = path.read_text()
        path.write_text(text.replace(old, new) if old else text)


@pytest.fixture(scope='module')
def copy(tmp_path_factory):
    place = Copy(tmp_path_factory.mktemp('project'))
    place.call('run')
    yield place
    shutil.rmtree(place.place)


RUN = ('run', 'models/double_pendulum.scene', '--seconds', '1')
# What changes, and what is made of it.
CHANGES = [
    ('core/numbers/real.h', {f'{PLANT}/plant.o', f'{PLANT}/program', LOOP}),
    ('core/numbers/sincos.h', {f'{PLANT}/plant.o', f'{PLANT}/program'}),
    ('core/runtime/loop.c', {LOOP, f'{PLANT}/program'}),
    ('port/host/script.h', {'build/obj/host/float/port/host/sim.o', f'{PLANT}/program'}),
    ('tools/isoc/graph/graph.h', {'build/isoc'}),
    ('tools/trace/main.c', {'build/trace'}),
    ('models/effects/friction.scene', {'build/isoc'}),
]


@pytest.mark.parametrize('words', [('run',), RUN], ids=['make run', 'isochron run'])
def test_nothing_changed_nothing_built(copy, words):
    copy.call(*words)
    assert copy.call(*words) == set() and copy.status == 0, copy.said


@pytest.mark.seeds(2 * len(CHANGES), len(CHANGES))
def test_a_source_that_changes(copy, seed):
    """By make run and by isochron run."""
    words, (file, made) = (('run',), RUN)[(seed - 1) // len(CHANGES)], CHANGES[(seed - 1) % len(CHANGES)]
    copy.call(*words)
    copy.edit(file)
    anew = copy.call(*words)
    assert made <= anew and copy.status == 0, copy.said
    assert 'build/isoc' in made or 'build/isoc' not in anew or file.startswith('core/'), anew
    assert copy.call(*words) == set()


@pytest.mark.parametrize('words', [('run',), RUN], ids=['make run', 'isochron run'])
def test_a_scene_that_changes(copy, words):
    copy.call(*words)
    copy.edit('models/double_pendulum.scene', 'mass 1 kg', 'mass 2 kg')
    anew = copy.call(*words)
    copy.edit('models/double_pendulum.scene', 'mass 2 kg', 'mass 1 kg')
    copy.call(*words)
    assert {f'{PLANT}/plant.c', f'{PLANT}/plant.o', f'{PLANT}/program'} == anew - {f'{PLANT}/plant.d'}, anew


def test_a_file_that_the_scene_includes(copy):
    (copy.place / 'part.scene').write_text('constant unused = 1\n')
    (copy.place / 'whole.scene').write_text((copy.place / 'models/pendulum.scene').read_text() + 'include "part.scene"\n')
    copy.call('run', 'whole.scene')
    (copy.place / 'part.scene').write_text('tunable unused = 1\n')
    assert 'build/host/float/whole/plant.c' in copy.call('run', 'whole.scene')
    (copy.place / 'part.scene').unlink()
    copy.call('run', 'whole.scene')
    assert copy.status == 1 and "cannot include 'part.scene'" in copy.said


@pytest.mark.parametrize('words', [['--method', 'heun'], ['--step', '2ms'], ['--without', '']], ids=['method', 'step', 'nothing'])
def test_a_choice(copy, words):
    copy.call(*RUN)
    anew = copy.call(*RUN, *words)
    assert (f'{PLANT}/program' in anew) == (words[1] != '')


def test_flags_of_the_user_are_of_plants_and_not_of_tools(copy):
    copy.call(*RUN)
    anew = copy.call(*RUN, CFLAGS='-DPLANTED')
    assert {f'{PLANT}/plant.o', LOOP} <= anew and 'build/isoc' not in anew
    copy.call(*RUN)


def test_a_plant_in_c(copy):
    words = 'run', 'models/oscillator.c', '--seconds', '1'
    copy.call(*words)
    copy.edit('models/oscillator.c')
    assert 'build/host/float/oscillator/program' in copy.call(*words)
    assert 'build/host/float/oscillator/program' in copy.call(*words, '--method', 'heun') and '\nmethod heun\n' in copy.said
    assert copy.call(*words, '--method', 'heun') == set()


def test_a_warning_is_an_error_but_with_flags_of_the_user(copy):
    source = copy.place / 'tools/trace/decimal.c'
    kept = source.read_text()
    source.write_text(kept + 'static int planted;\n')
    said = {}
    for flags in ('', 'CFLAGS=-O3'):
        done = subprocess.run(['make', 'build/trace', *flags.split()], cwd=copy.place, capture_output=True, text=True)
        said[flags] = done.returncode, 'planted' in done.stderr
    source.write_text(kept)
    copy.call(*RUN)
    assert said[''][0] != 0 and said[''][1] and said['CFLAGS=-O3'] == (0, True)


def test_a_tool_that_cannot_be_linked_leaves_the_one_before(copy):
    source, tool = copy.place / 'tools/trace/main.c', copy.place / 'build/trace'
    kept, before = source.read_text(), tool.stat().st_ino
    source.write_text(kept.replace('int main(', 'int other(int argc, char **argv);\nint other('))
    failed = subprocess.run(['make', 'build/trace'], cwd=copy.place, capture_output=True).returncode
    left = tool.stat().st_ino
    source.write_text(kept)
    copy.call(*RUN)
    assert failed and left == before and tool.stat().st_ino != before


def test_a_changed_scene_runs_within_a_second_of_the_processor(copy):
    copy.call(*RUN)
    copy.edit('models/double_pendulum.scene', 'mass 1 kg', 'mass 3 kg')
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    anew = copy.call(*RUN)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    copy.edit('models/double_pendulum.scene', 'mass 3 kg', 'mass 1 kg')
    copy.call(*RUN)
    assert f'{PLANT}/program' in anew
    assert after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime < 1


def test_found_headers_that_make_does_not_know_of(copy):
    copy.call(*RUN)
    copy.edit('tools/build/program.mk', '-include $(OBJECTS:.o=.d) $(OWN:.o=.d)', '')
    copy.edit('core/runtime/loop.h')
    forgotten = copy.call(*RUN)
    subprocess.run(['cp', '-a', ROOT / 'tools/build/program.mk', copy.place / 'tools/build/program.mk'], check=True)
    assert LOOP not in forgotten
