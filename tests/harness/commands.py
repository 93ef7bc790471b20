"""Commands of isochron, and the laboratory behind them. They work in a folder of the tests, build/tests/commands; each
worker of pytest has its own, since the laboratory locks what it works in."""
import os
import subprocess
import sys
import types

import pytest

from harness import project

sys.path.insert(0, str(project.ROOT / 'tools'))
from lab import build  # noqa: E402

FOLDER = project.BUILD / 'commands' / os.environ.get('PYTEST_XDIST_WORKER', 'alone')
VARIABLES = {'TEST_BUILT': 'yes', 'LC_ALL': 'C'}


@pytest.fixture
def laboratory(monkeypatch):
    """The working folder, which stays from test to test with the objects that programs share; modules of tools/lab are
    lab.NAME. What a test has locked another program may have after it."""
    project.make(*project.TOOLS)
    FOLDER.mkdir(parents=True, exist_ok=True)
    monkeypatch.chdir(FOLDER)
    for name, value in VARIABLES.items():
        monkeypatch.setenv(name, value)
    yield FOLDER
    build.let_go()


@pytest.fixture(scope='session')
def isochron():
    """isochron(word, ..., NAME='value'): a command, with these variables in its environment: what it printed, its errors
    and its status; `rows` are those of its tables, each a list of cells. It works in the folder of
    `laboratory`, or in another, `cwd`."""
    project.make(*project.TOOLS)
    FOLDER.mkdir(parents=True, exist_ok=True)

    def call(*words, cwd=FOLDER, **environment):
        done = subprocess.run([project.ROOT / 'tools/isochron', *map(str, words)], capture_output=True, text=True,
                              stdin=subprocess.DEVNULL, cwd=cwd, env={**os.environ, **VARIABLES, **environment})
        rows = [[cell.strip() for cell in line.split('|')[1:-1]] for line in done.stdout.splitlines() if line.startswith('|')]
        said = dict(line.split(' ', 1) for line in done.stdout.splitlines() if ' ' in line)
        return types.SimpleNamespace(status=done.returncode, printed=done.stdout, errors=done.stderr, rows=rows, said=said)

    return call
