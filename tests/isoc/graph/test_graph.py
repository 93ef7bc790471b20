"""The operators of isoc's expressions: each has its derivative, or it does not compile; and a new one is a row and the function that makes its
nodes. Large scenes take little memory and time."""
import glob
import re
import resource
import shutil
import subprocess
import sys

import pytest
from harness.plants import COMPILERS, STRICT, replaced
from harness.project import ROOT

SOURCES = 'tools/isoc/graph/*.c tools/isoc/base/*.c tests/isoc/graph/operators.c tests/tap.c port/host/*.c port/unix/console.c'.split()
LIST = 'tools/isoc/graph/operators.h'


class Tree:
    """A copy of what operators.c is compiled of, to change; the compiler's judgement, what it says, and the results of the program."""

    def __init__(self, place):
        self.place = place
        for folder in ('tools/isoc/graph', 'tools/isoc/base', 'tests/isoc/graph', 'port', 'core'):
            shutil.copytree(ROOT / folder, place / folder)
        for name in ('tap.c', 'tap.h'):
            shutil.copy(ROOT / 'tests' / name, place / 'tests')

    def change(self, name, *changes):
        text = (self.place / name).read_text()
        for pattern, by in changes:
            text = replaced(pattern, by, text)
        (self.place / name).write_text(text)

    def compiles(self):
        sources = sorted(glob.glob(SOURCES[0], root_dir=self.place))
        done = subprocess.run(['gcc', '-std=c11', *STRICT, '-D_POSIX_C_SOURCE=200809L', '-DISO_REAL_DOUBLE', '-fsyntax-only', '-I.', *sources], cwd=self.place, capture_output=True, text=True)
        self.said = done.stderr
        return done.returncode == 0

    def results(self):
        """What each result says."""
        sources = [path for pattern in SOURCES for path in sorted(glob.glob(pattern, root_dir=self.place))]
        subprocess.run([*COMPILERS['tcc'], '-std=c11', '-D_POSIX_C_SOURCE=200809L', '-DISO_REAL_DOUBLE', '-I.', *sources, '-lm', '-o', 'program'],
                              cwd=self.place, check=True)
        printed = subprocess.run([self.place / 'program'], capture_output=True, text=True).stdout
        return {name: good == 'ok' for good, name in re.findall(r'^(ok|not ok) \d+ - (.*?)(?:, to .*)?$', printed, re.M)}


@pytest.fixture
def tree(tmp_path):
    return Tree(tmp_path)


def test_every_operator_has_its_derivative(tree):
    results = tree.results()
    assert tree.compiles() and len(results) > 25 and all(results.values()), [name for name, good in results.items() if not good]


@pytest.mark.parametrize('pattern, by', [(r'^.*derivative_of_magnitude.*\n', ''), (r'derivative_of_magnitude\([^,]*,[^,]*,[^,]*\),', ',')])
def test_a_row_without_its_derivative_does_not_compile(tree, pattern, by):
    tree.change(LIST, (pattern, by))
    assert not tree.compiles() and 'operators' in tree.said


def test_a_derivative_of_zero_is_found(tree):
    tree.change(LIST, (r'(derivative_of_magnitude\([^,]*,[^,]*,[^,]*\)),', r'mul(g, constant(g, 0.0), \1),'))
    assert tree.results()['ABS has its derivative'] is False


def test_a_new_operator_is_a_row_and_a_function(tree):
    row = '    OPERATION(TWICE, 1, a + a, add(g, da, da), twice(g, a), "iso_twice(@a)", WHOLE, SUM, SUM, DECLARED, 0, 1, 0, 0) \\\\\n'
    tree.change(LIST, (r'^    OPERATION\(ADD, 2,', row + r'\g<0>'))
    tree.change('tools/isoc/graph/graph.c', (r'\Z', 'node twice(graph *g, node a) { return graph_put(g, (graph_node){.op = OP_TWICE, .a = a}); }\n'))
    tree.change('tools/isoc/graph/graph.h', (r'^node add\(', r'node twice(graph *g, node a);\n\g<0>'))
    results = tree.results()
    assert results['TWICE has its derivative'] and all(results.values())


def compiled(scene, method, folder, megabytes, seconds=4):
    """isoc with so much memory and time of a processor."""
    def limit():
        resource.setrlimit(resource.RLIMIT_AS, (megabytes << 20,) * 2)
        resource.setrlimit(resource.RLIMIT_CPU, (seconds,) * 2)

    return subprocess.run(['build/isoc', scene, '-o', folder, '--method', method], preexec_fn=limit, capture_output=True, text=True)


@pytest.mark.parametrize('scene, method', [('models/stewart.scene', 'bdf4'), (32, 'bdf4'), (200, 'rk4')])
def test_a_large_scene_takes_at_most_100_megabytes_and_4_seconds(tmp_path, scene, method):
    if isinstance(scene, int):
        links, scene = scene, tmp_path / 'chain.scene'
        scene.write_text(subprocess.run([sys.executable, 'tools/lab/chain.py', str(links), 'planar'], capture_output=True, text=True, check=True).stdout)
    assert compiled(scene, method, tmp_path, 100).returncode == 0


def test_what_takes_more_is_found(tmp_path):
    done = compiled('models/stewart.scene', 'bdf4', tmp_path, 20)
    assert done.returncode and 'out of memory' in done.stderr
