"""Commands of isochron, and the laboratory behind them: they work in a folder of the tests, build/tests/commands."""
import os
import subprocess
import sys
import types

import pytest

from harness import project

sys.path.insert(0, str(project.ROOT / 'tools'))
FOLDER = project.BUILD / 'commands'


@pytest.fixture
def laboratory(monkeypatch):
    """The working folder, which stays from test to test with the objects that programs share; modules of tools/lab are
    lab.NAME."""
    project.make(*project.TOOLS)
    FOLDER.mkdir(parents=True, exist_ok=True)
    monkeypatch.chdir(FOLDER)
    monkeypatch.setenv('TEST_BUILT', 'yes')
    monkeypatch.setenv('LC_ALL', 'C')
    return FOLDER


@pytest.fixture
def isochron(laboratory):
    """isochron(word, ..., NAME='value'): a command, with these variables in its environment: what it printed, its errors
    and its status; `rows` are those of its tables, each a list of cells."""

    def call(*words, **environment):
        done = subprocess.run([project.ROOT / 'tools/isochron', *map(str, words)], capture_output=True, text=True,
                              stdin=subprocess.DEVNULL, env={**os.environ, **environment})
        rows = [[cell.strip() for cell in line.split('|')[1:-1]] for line in done.stdout.splitlines() if line.startswith('|')]
        said = dict(line.split(' ', 1) for line in done.stdout.splitlines() if ' ' in line)
        return types.SimpleNamespace(status=done.returncode, printed=done.stdout, errors=done.stderr, rows=rows, said=said)

    return call
