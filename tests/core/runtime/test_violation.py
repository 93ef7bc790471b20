"""The loop's statistics tell how far a run was off its closures, and how many ticks were farther off than the scene's
limit; without a limit nothing of it is there. A four-bar linkage whose constraints drift, since nothing holds them."""
import re

import pytest

from harness.programs import path_of, run
from harness.project import ROOT
from lab import build

FOUR_BAR = (ROOT / 'tests/core/methods/order/four_bar.scene').read_text()


def linkage(stabilisation):
    """The scene, whose output `off` is the violation."""
    text = re.sub('^stabilisation.*\n', '', FOUR_BAR, flags=re.M)
    text = re.sub('^method.*', 'method rk4', text, flags=re.M).replace('start 90 deg', 'start 90 deg; speed 20 rad/s')
    return f'{text}output off = violation\nstabilisation {stabilisation}\n'


LIMITS = {'free': 'none', 'limited': 'none { limit 20 um }', 'never': 'none { limit 1 m }'}


@pytest.fixture
def runs(isochron, laboratory, tmp_path):
    """runs(name, limit, ...): a run of 5 s; `told` and `seen` are the largest violation and the ticks above the limit, as
    its summary and its table have them."""
    def of(name, limit=0.0, *words):
        scene = path_of(linkage(LIMITS[name]), tmp_path / name, 'linkage.scene')
        done = isochron('run', scene, '--seconds', 5, *words)
        head, *rows = ((laboratory / done.said['trace']).read_text()).splitlines()
        off = [line.split(',')[head.split(',').index('off')] for line in rows]
        done.told = done.said.get('violation'), done.said.get('violated')
        done.seen = max(off, key=float), str(sum(float(cell) > limit for cell in off))
        return done

    return of


def test_the_largest_violation_and_the_ticks_above_the_limit_are_those_of_the_table(runs):
    """Without a limit: the same motion, and nothing is told."""
    limited, never, free = runs('limited', 2e-5), runs('never', 1.0), runs('free')
    assert limited.told == limited.seen and 0 < int(limited.told[1]) < int(limited.said['ticks'])
    assert never.told == never.seen and never.told[1] == '0'
    assert free.said['hash'] == limited.said['hash'] == never.said['hash'] and free.told == (None, None)


def test_on_the_board_a_limit_costs_the_step_nothing(runs):
    board = '--target', 'cortex-m4f'
    host, limited, free = runs('limited', 2e-5), runs('limited', 2e-5, *board), runs('free', 0.0, *board)
    assert limited.said['instructions_per_step'] == free.said['instructions_per_step']
    assert limited.said['hash'] == host.said['hash'] and limited.told == limited.seen == host.told


def test_a_limit_adds_to_the_plant_what_computes_it_and_what_tells_of_it_alone(isoc, laboratory, tmp_path):
    def symbols(name):
        plant = isoc(linkage(LIMITS[name])).folder / 'plant.c'
        made = run(*build.port('cortex-m4f').compile, '-c', plant, '-o', tmp_path / f'{name}.o')
        assert made.status == 0, made.errors
        return {line.split()[-1].split('.')[0] for line in run('arm-none-eabi-nm', tmp_path / f'{name}.o').printed.splitlines()}

    free, limited = symbols('free'), symbols('limited')
    assert limited - free == {'iso_plant_tell', 'violation'} and free <= limited
