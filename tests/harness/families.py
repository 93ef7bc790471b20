"""Families: a test with an argument `seed` is run for each member. What a test imports beside pytest stands in its folder,
or in harness/."""
import sys


def pytest_addoption(parser):
    parser.addoption('--seeds', type=int, default=1, help='how many members of each family, at least')
    parser.addoption('--first-seed', type=int, default=1)


def pytest_generate_tests(metafunc):
    """`@pytest.mark.seeds(n)` says how many members are tried by default."""
    if 'seed' in metafunc.fixturenames:
        first, count = metafunc.config.getoption('first_seed'), metafunc.config.getoption('seeds')
        mark = metafunc.definition.get_closest_marker('seeds')
        count = max(count, mark.args[0] if mark else 1)
        metafunc.parametrize('seed', range(first, first + count))


def pytest_pycollect_makemodule(module_path, parent):
    if str(module_path.parent) not in sys.path:
        sys.path.append(str(module_path.parent))
