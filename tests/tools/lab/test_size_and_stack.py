"""isochron size and isochron stack: the double pendulum keeps its limits, and what breaks a limit or has no bound is
found."""
import os
import shutil
import subprocess

import pytest

from harness.project import ROOT
from lab import size, stack
from lab.build import Wrong

MODEL = ROOT / 'models/double_pendulum.scene'


def test_the_firmware_of_the_double_pendulum_keeps_its_limits(isochron):
    of = isochron('size', MODEL)
    assert of.status == 0 and 'of at most' in of.said['text']
    assert '-O2 -ffp-contract=off' in of.said['flags'] and ' -frename-registers ' in of.said['flags']


def test_of_the_host_nothing_is_limited(isochron):
    of = isochron('size', MODEL, '--target', 'host')
    assert of.status == 0 and int(of.said['step_text']) > 0


@pytest.mark.parametrize('target', ('host', 'cortex-m4f', 'atmega1284p'))
def test_the_stack_of_a_step_has_a_bound(isochron, target):
    of = isochron('stack', MODEL, '--target', target)
    assert of.status == 0 and int(of.said['stack_of_step']) > 0


def test_a_compiler_behind_ccache_writes_its_call_graph_each_time(isochron, tmp_path):
    behind = {'PATH': f'/usr/lib/ccache:{os.environ["PATH"]}', 'CCACHE_DIR': str(tmp_path / 'kept'), 'CCACHE_NOHASHDIR': 'yes'}
    for _ in range(2):
        of = isochron('stack', MODEL, '--target', 'cortex-m4f', '--out', tmp_path / 'made', **behind)
        assert of.status == 0 and int(of.said['stack_of_step']) > 0, of.errors
        shutil.rmtree(tmp_path / 'made/stack')


def sizes(text, data, bss, step):
    """Of a program of these sizes, with functions of a step of which one is a copy."""
    return size.sizes(f'   text\t   data\t    bss\t    dec\t    hex\tfilename\n{text} {data} {bss} 0 0 program\n',
                      f'00002000 A STACK_BYTES\n20000000 00000400 b trace_buffer\n00000100 {step:08x} t step\n'
                      '00000900 00000008 t derivative.constprop.0\n')


@pytest.mark.parametrize('of, kept', (((8192, 100, 9628, 2040), True), ((8193, 100, 9628, 2040), False),
                                      ((8192, 100, 9628, 2041), False), ((8192, 101, 9628, 2040), False)))
def test_limits(of, kept):
    assert size.listed(sizes(*of), size.LIMITS) == kept


def test_no_sizes_at_all():
    with pytest.raises(Wrong):
        size.sizes('', '')


def deepest(folder, code):
    """The deepest stack of the function `step`, by the call graph of gcc."""
    (folder / 'step.c').write_text(code)
    command = 'gcc -std=c11 -O2 -fno-inline -fcallgraph-info=su -c step.c -o step.o'
    subprocess.run(command.split(), cwd=folder, check=True, env={**os.environ, 'CCACHE_DISABLE': 'yes'})
    return stack.depth(stack.deepest(*stack.read((folder / 'step.ci').read_text()), 'step'))


def test_the_bound_is_that_of_the_deeper_call_and_not_the_sum(tmp_path):
    size_of_step = deepest(tmp_path, '''
        static int leaf(volatile int *p) { volatile int a[256]; a[9] = *p; return a[9]; }
        static int other(volatile int *p) { volatile int a[16]; a[9] = *p; return a[9]; }
        int step(volatile int *p); int step(volatile int *p) { return leaf(p) + other(p); }''')
    # A leaf of x86-64 may keep 128 bytes below its stack, which isochron stack turns off.
    assert 1024 - 128 <= size_of_step < 1024 + 64


@pytest.mark.parametrize('problem, code', (
    ('recursion', '''int step(volatile int *p); static int down(volatile int *p) { return *p ? step(p) + *p : 1; }
        int step(volatile int *p) { return down(p) * *p; }'''),
    ('grows at run time', '''void use(char *); static void use_not(volatile char *p) { *p = 1; }
        void step(int n); void step(int n) { volatile char a[n]; use_not(a); }'''),
    ('a call through a pointer', 'extern int (*volatile f)(int); int step(int); int step(int n) { return f(n) + 1; }'),
    ('not known', 'int other(int); int step(int); int step(int n) { return other(n) + 1; }'),
    ('no function', 'int leap(int n); int leap(int n) { return n; }')))
def test_no_bound(tmp_path, problem, code):
    with pytest.raises(Wrong, match=problem):
        deepest(tmp_path, code)
