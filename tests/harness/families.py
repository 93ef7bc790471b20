"""Families: a test with an argument `seed` is run for each member. What a test imports beside pytest stands in its folder,
or in harness/."""
import os
import sys

from harness import project


def pytest_addoption(parser):
    parser.addoption('--seeds', type=int, help='how many members of each family, at least')
    parser.addoption('--first-seed', type=int, default=1)


def members(count, each, turn):
    """Of `count` seeds from 0 those of this turn, so many that over the turns all have theirs."""
    return [(turn * each + i) % count for i in range(each)]


def pytest_generate_tests(metafunc):
    """`@pytest.mark.seeds(n)` says how many members are tried; `seeds(n, m)` m of n by turns, with TEST_WHOLE all."""
    if 'seed' not in metafunc.fixturenames:
        return
    wanted, first = metafunc.config.getoption('seeds'), metafunc.config.getoption('first_seed')
    mark = metafunc.definition.get_closest_marker('seeds')
    count, each = ((*mark.args, mark.args[0]) if mark else (1, 1))[:2]
    if wanted or os.environ.get('TEST_WHOLE'):
        seeds = range(max(count, wanted or 1))
    else:
        seeds = members(count, each, project.turn(count, metafunc.definition.path)) if each < count else range(count)
    metafunc.parametrize('seed', [first + seed for seed in seeds])


def pytest_pycollect_makemodule(module_path, parent):
    if str(module_path.parent) not in sys.path:
        sys.path.append(str(module_path.parent))
