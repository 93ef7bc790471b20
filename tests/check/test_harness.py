"""The harness counts what it must: passed, failed, crashed, without a plan, skipped; and runs again what has to be.

It follows from the harness, and from nothing of the project.
"""
# Depends on: tests/tools.sh
import collections
import os
import re
import shutil
import subprocess
import sys

import pytest

from harness.project import ROOT
from harness.tap import Results

SCRIPTS = {
    'good': 'echo "ok 1 - a"; echo "ok 2 - b"; echo 1..2',
    'bad': 'echo "ok 1 - a"; echo "not ok 2 - this one fails"; echo "# for a reason"; echo 1..2; exit 1',
    'crash': 'echo "ok 1 - a"; echo 1..1; kill -SEGV $$',
    'noplan': 'echo "ok 1 - a"',
    'silent': 'exit 0',
    'short': 'echo "ok 1 - a"; echo 1..3',
    'status': 'echo "ok 1 - a"; echo 1..1; exit 3',
    'skip': 'echo "ok 1 - a"; echo "ok 2 # SKIP no need"; echo 1..2',
    'not_here': 'echo "1..0 # SKIP no such machine"',
}
IN_PYTHON = '''
import pytest

def test_good(seed):
    assert seed

def test_bad():
    assert 1 == 2

def test_skip():
    pytest.skip("no need")
'''


class Small:
    """A small project with the harness and some tests."""

    def __init__(self, folder):
        self.folder, self.tests = folder, folder / 'tests/room'
        for name in ('tests/harness', 'tools/lab', 'tools/build'):
            shutil.copytree(ROOT / name, folder / name, ignore=shutil.ignore_patterns('__pycache__'))
        for name in ('tests/conftest.py', '.pytest.ini'):
            shutil.copy(ROOT / name, folder / name)
        self.tests.mkdir()
        (folder / 'core').mkdir()
        (folder / 'core/part.c').write_text('')
        self.know()

    def know(self, **seconds):
        (self.folder / 'tests/times').write_text(''.join(f'{n} tests/room/{name}.t\n' for name, n in seconds.items()))

    def write(self, *names, head=''):
        for name in names:
            (self.tests / f'{name}.t').write_text(f'{head}echo {name} >>{self.folder}/runs\n{SCRIPTS[name]}\n')

    def order(self):
        return (self.folder / 'runs').read_text().split()

    def runs(self, name):
        return self.order().count(name)

    def state(self, name):
        """What decides whether a script that passed is run again."""
        code = f'import sys; sys.path.insert(0, "."); from harness import project as p; print(p.state_of_test(p.ROOT / "tests/room/{name}.t"))'
        return subprocess.run([sys.executable, '-B', '-c', code], cwd=self.folder / 'tests', text=True, check=True,
                              capture_output=True).stdout

    def run(self, *words):
        done = subprocess.run([sys.executable, '-B', '-m', 'pytest', *words, 'tests'], cwd=self.folder, text=True,
                              capture_output=True, env={**os.environ, 'TEST_BUILT': 'yes', 'PYTEST_ADDOPTS': ''})
        self.status, self.output = done.returncode, done.stdout + done.stderr
        return done.stdout.splitlines()[-1]


@pytest.fixture
def small(tmp_path):
    return Small(tmp_path)


@pytest.mark.parametrize('names, line', [
    ('good', '2 passed, 0 failed'), ('good bad', '3 passed, 1 failed'), ('crash', '1 passed, 1 failed'),
    ('noplan', '1 passed, 1 failed'), ('silent', '0 passed, 1 failed'), ('short', '1 passed, 1 failed'),
    ('status', '1 passed, 1 failed'), ('skip', '1 passed, 0 failed, 1 skipped'), ('not_here', '0 passed, 0 failed, 1 skipped')])
def test_scripts_are_counted_by_their_results(small, names, line):
    small.write(*names.split())
    assert small.run() == line
    assert (small.status == 0) == (' 0 failed' in line)


def test_workers_count_as_one_process_does(small):
    small.write('good', 'bad', 'skip')
    (small.tests / 'test_three.py').write_text(IN_PYTHON)
    assert small.run('-n', '2', '--dist', 'loadgroup') == '5 passed, 2 failed, 2 skipped' and small.status != 0


def test_the_tests_of_a_file_in_python_share_a_worker(small):
    for name in 'ab':
        (small.tests / f'test_{name}.py').write_text(
            'import os\nimport pytest\n\n@pytest.mark.parametrize("n", range(20))\n'
            f'def test_own(n):\n    open("{small.folder}/{name}", "a").write(os.environ["PYTEST_XDIST_WORKER"] + "\\n")\n')
    assert small.run('-n', '4', '--dist', 'loadgroup') == '40 passed, 0 failed'
    workers = [set((small.folder / name).read_text().split()) for name in 'ab']
    assert [len(some) for some in workers] == [1, 1] and workers[0] != workers[1]


def test_what_failed_is_shown_with_its_comments_and_all_stands_in_the_log(small):
    small.write('bad')
    small.run()
    assert 'not ok 2 - this one fails' in small.output and '# for a reason' in small.output
    assert 'ok 1 - a' in (small.folder / 'build/tests/log/tests/room/bad.t/script').read_text()


def test_a_test_in_python_passes_fails_and_is_skipped(small):
    (small.tests / 'test_three.py').write_text(IN_PYTHON)
    assert small.run() == '1 passed, 1 failed, 1 skipped' and 'assert 1 == 2' in small.output
    assert small.run('--seeds', '3').startswith('3 passed')


def test_what_was_skipped_is_told_with_its_reason(small):
    small.write('skip', 'not_here')
    (small.tests / 'test_three.py').write_text(IN_PYTHON)
    small.run()
    assert small.output.splitlines()[-4:-1] == [
        'skipped: tests/room/not_here.t::script: no such machine', 'skipped: tests/room/skip.t::script: no need',
        'skipped: tests/room/test_three.py::test_skip: no need']


def test_a_file_that_cannot_be_read_fails(small):
    (small.tests / 'test_wrong.py').write_text('import nothing_of_this_name\n')
    assert small.run() == '0 passed, 1 failed' and small.status != 0


def test_the_longest_begin_first_and_before_them_what_has_no_time(small):
    small.write('good', 'skip', 'bad')
    small.know(good=20, skip=9.5)
    small.run('--keep')
    assert small.order() == ['bad', 'good', 'skip']
    assert re.search(r'^ *[0-9.]+ tests/room/good\.t$', (small.folder / 'build/tests/takes.txt').read_text(), re.M)


def test_the_quick_part_leaves_out_what_takes_long_or_has_no_time(small):
    small.write('good', 'skip', 'bad')
    small.know(good=0.5, skip=9.5)
    assert small.run('--quick') == '2 passed, 0 failed'


def test_what_passed_is_not_run_again_as_long_as_nothing_has_changed(small):
    small.write('good', 'bad', 'short')
    assert small.run('--keep') == '4 passed, 2 failed' and 'not run again' not in small.output
    assert small.run('--keep') == '4 passed, 2 failed' and '1 tests were not run again' in small.output
    assert [small.runs(name) for name in ('good', 'bad', 'short')] == [1, 2, 2]
    (small.folder / 'core/part.c').write_text('int part;\n')
    small.run('--keep')
    assert small.runs('good') == 2


def test_a_test_follows_from_what_it_says_and_from_its_folder(small):
    small.write('good', head='# Depends on: core/a *.md\n')
    (small.folder / 'core/a').mkdir()
    changes = [('core/part.c', False), ('core/a/x.c', True), ('README.md', True), ('tests/room/x.scene', True)]
    for file, is_of_it in changes:
        before = small.state('good')
        (small.folder / file).write_text('changed\n')
        assert (small.state('good') != before) == is_of_it, file


def test_a_test_follows_from_all_sources_and_from_the_readmes_that_it_names(small):
    small.write('good', head='# as core/README.md says\n')
    changes = [('core/README.md', True), ('README.md', False), ('core/part.c', True), ('tools/lab/rig.c', True), ('Makefile', True),
               ('tests/room/x.scene', True), ('tests/other.scene', False)]
    for file, is_of_it in changes:
        before = small.state('good')
        with (small.folder / file).open('a') as text:
            text.write('/* changed */\n')
        assert (small.state('good') != before) == is_of_it, file


FAMILY = """
import pytest

@pytest.mark.seeds(10, 4)
def test_one(seed):
    open('members', 'a').write(f'{seed} ')
"""


def test_the_members_that_are_tried_follow_from_the_sources_and_the_whole_family_is_tried_when_told(small, monkeypatch):
    (small.tests / 'test_family.py').write_text(FAMILY)

    def tried(*words):
        (small.folder / 'members').unlink(missing_ok=True)
        small.run(*words)
        return list(map(int, (small.folder / 'members').read_text().split()))

    found = {}
    for change in range(3):
        (small.folder / 'core/part.c').write_text(f'int part_{change};\n')
        found[change] = tried()
        assert len(found[change]) == 4
    assert found[change] == tried() and len(set(map(tuple, found.values()))) > 1
    assert sorted(sum((tried() for turn in '012' if not monkeypatch.setenv('TEST_TURN', turn)), [])) == [
        1, 1, 2, 2, 3, 4, 5, 6, 7, 8, 9, 10]
    assert tried('--seeds', '12') == list(range(1, 13))
    monkeypatch.setenv('TEST_WHOLE', 'yes')
    assert tried() == list(range(1, 11))


def test_a_script_is_told_its_turn(small, monkeypatch):
    (small.tests / 'turn.t').write_text('. tests/host/test.sh\nturn_of 10 >turn\nturn_of 1000000000 >large\necho "ok 1 - a"\necho 1..1\n')
    shutil.copytree(ROOT / 'tests/host', small.folder / 'tests/host')

    def told(name):
        assert small.run() == '1 passed, 0 failed'
        return (small.folder / name).read_text().strip()

    first = told('large')
    (small.folder / 'core/part.c').write_text('int part;\n')
    assert told('large') != first
    monkeypatch.setenv('TEST_TURN', '7')
    assert told('turn') == '7'
    monkeypatch.setenv('TEST_WHOLE', 'yes')
    assert told('turn') == 'all'


def test_a_unit_test_follows_from_its_program_and_a_script_from_the_makefiles(small):
    unit, program = small.folder / 'tests/core/room/one.c', small.folder / 'build/tests/plain/float/room/one'
    for path in unit, program:
        path.parent.mkdir(parents=True)
    unit.write_text('')
    small.write('good')

    def counted(results):
        program.write_text(f'#!/bin/sh\n{results}\n')
        program.chmod(0o755)
        return small.run('--keep', '-k', 'plain-float or good')

    assert counted('echo "ok 1 - a"; echo 1..1') == '3 passed, 0 failed'
    assert counted('echo "not ok 1 - a"; echo 1..1') == '2 passed, 1 failed'
    (small.folder / 'tools/build/flags.mk').write_text('FLAGS := -O1\n')
    small.run('--keep')
    assert small.runs('good') == 2


def test_variants_of_the_unit_tests_have_equal_numbers(small):
    unit = small.folder / 'tests/core/room'
    unit.mkdir(parents=True)
    (unit / 'one.c').write_text('')
    for variant, results in (('plain', 'echo "ok 1 - a"; echo 1..1'), ('asan', 'echo "ok 1 - a"; echo "ok 2 - b"; echo 1..2')):
        program = small.folder / f'build/tests/{variant}/float/room/one'
        program.parent.mkdir(parents=True)
        program.write_text(f'#!/bin/sh\n{results}\n')
        program.chmod(0o755)
    assert small.run('-k', 'plain-float or asan-float') == '3 passed, 1 failed' and 'asan 2, plain 1' in small.output
    shutil.copy(small.folder / 'build/tests/plain/float/room/one', small.folder / 'build/tests/asan/float/room/one')
    assert small.run('-k', 'plain-float or asan-float') == '3 passed, 0 failed'


def test_a_plan_within_the_results_is_counted_once():
    assert Results('ok 1\n1..1\n', 0).failed == 0 and Results('ok 1\n1..1\n1..1\n', 0).failed == 1


@pytest.fixture
def machine(tmp_path):
    """machine(user, command): looks for the tools on a machine that lacks clang, as the user of that number, where
    apt-get does `command`; the status and what was said."""
    bin = tmp_path / 'bin'
    bin.mkdir()
    asked = re.findall(r'^    have ([a-z0-9+-]*) ', (ROOT / 'tests/tools.sh').read_text(), re.M)
    # The compilers themselves, not ccache before them.
    path = ':'.join(folder for folder in os.environ['PATH'].split(':') if not folder.endswith('/ccache'))
    for tool in {'sh', 'cut', 'tr', 'cat', 'uname', 'env', 'ln', 'mkdir', 'tail', 'grep', 'as', 'ld', 'cc', *asked} - {'clang'}:
        if shutil.which(tool, path=path):
            (bin / tool).symlink_to(shutil.which(tool, path=path))

    def look(user, command):
        for name, text in (('id', f'echo {user}'),
                           ('apt-get', f'echo "$@" >>{tmp_path}/asked\n[ "$1" = update ] || {command}')):
            (bin / name).write_text(f'#!/bin/sh\n{text}\n')
            (bin / name).chmod(0o755)
        (tmp_path / 'asked').unlink(missing_ok=True)
        done = subprocess.run(['/bin/sh', str(ROOT / 'tests/tools.sh')], cwd=tmp_path, env={'PATH': str(bin)}, text=True,
                              capture_output=True)
        asked_for = (tmp_path / 'asked').read_text() if (tmp_path / 'asked').exists() else ''
        return done.returncode, done.stdout + done.stderr, asked_for

    look.bin, look.path = bin, path
    return look


def test_a_user_who_may_not_install_is_told_the_command(machine):
    status, said, asked = machine(1000, 'true')
    assert status != 0 and not asked and re.search('install it with: sudo apt-get install .* clang libclang-rt-dev *$', said, re.M)


def test_an_installation_that_fails_or_brings_nothing_is_told(machine):
    status, said, _ = machine(0, 'false')
    assert status != 0 and re.search('the installation failed: apt-get install .* clang', said)
    status, said, _ = machine(0, 'true')
    assert status != 0 and 'still missing after the installation: clang' in said


def test_root_installs_what_is_missing_and_is_told_what_and_how_much(machine):
    status, said, asked = machine(0, f"ln -s {shutil.which('clang', path=machine.path)} {machine.bin}/clang")
    assert re.search('^install .* clang', asked, re.M) and re.search(r'some minutes.* \d+ MB', said)
    assert machine(0, 'false')[2] == ''


def doubled(root):
    """Names of more than one file that tests import from folders of theirs, or from the import's."""
    names = collections.Counter(path.stem for path in [*root.glob('tests/*/**/*.py'), *root.glob('tools/import/*.py')]
                                if not path.name.startswith('test_') and path.stem not in ('conftest', 'write_scene')
                                and path.parent != root / 'tests/harness')
    return {name for name, count in names.items() if count > 1}


def test_a_module_that_tests_import_has_a_name_of_its_own(tmp_path):
    """All tests that a worker runs look for modules in the same places."""
    assert doubled(ROOT) == set()
    for name in 'tests/a/part.py', 'tests/b/part.py', 'tests/b/other.py':
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).touch()
    assert doubled(tmp_path) == {'part'}
