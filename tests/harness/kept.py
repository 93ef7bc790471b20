"""What a run knows of the runs before: how long each test takes, and what passed and follows from nothing that has changed.

A test that passed under `make test` or `make check` is kept in build/tests/passed with a hash of all that it follows
from, and is not run again as long as that is the same (harness/project.py). One that failed is always run, and so is
one that is run without --keep.
"""
import hashlib
import json
import os
import resource

import pytest

from harness import project

KEPT = project.BUILD / 'passed'
TAKES = project.BUILD / 'takes'
# Seconds of processor time: what takes longer `make check` leaves to `make test`.
QUICK = 1.0


def pytest_addoption(parser):
    parser.addoption('--keep', action='store_true', help='do not run again what passed, as long as nothing has changed')
    parser.addoption('--quick', action='store_true', help='only what is quick, and unit tests in float')


def name_of(item):
    """The test in tests/times: a file, or a variant of a unit test."""
    path = str(item.path.relative_to(project.ROOT))
    return path if path.endswith(('.py', '.t')) else f'{path}::{item.name}'


def times():
    lines = (project.ROOT / 'tests/times').read_text().splitlines()
    return {name: float(seconds) for seconds, name in map(str.split, lines)}


def is_quick(item, known):
    if getattr(item, 'variant', None):
        return item.variant in (('plain', 'float'), ('m4f', 'float'))
    return item.path.parent.name != 'exhaustive' and known.get(name_of(item), QUICK + 1) <= QUICK


def place_of(item):
    return KEPT / hashlib.sha256(item.nodeid.encode()).hexdigest()[:32]


def state_of(item):
    if hasattr(item, 'state'):
        return item.state()
    return project.state_of_test(item.path)


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(config, items):
    """The longest files begin first, so that every core has work to the end; what is not in tests/times begins first of
    all. The tests of a file in Python share a worker, and its fixtures."""
    known = times()
    if config.getoption('quick'):
        slow = [item for item in items if not is_quick(item, known)]
        items[:] = [item for item in items if is_quick(item, known)]
        config.hook.pytest_deselected(items=slow)
    items.sort(key=lambda item: (-known.get(name_of(item), 1e9), name_of(item)))
    for item in items:
        if item.path.suffix == '.py':
            item.add_marker(pytest.mark.xdist_group(name_of(item)))


def kept_counts(item):
    """(passed, failed, skipped) of a test that need not be run, else nothing."""
    try:
        kept = json.loads(place_of(item).read_text())
    except (OSError, ValueError):
        return None
    return kept['tap'] if kept['state'] == state_of(item) else None


@pytest.hookimpl(tryfirst=True)
def pytest_runtest_protocol(item, nextitem):
    counts = kept_counts(item) if item.config.getoption('keep') else None
    if counts is None:
        return None
    hook = item.ihook
    hook.pytest_runtest_logstart(nodeid=item.nodeid, location=item.location)
    hook.pytest_runtest_logreport(report=pytest.TestReport(
        nodeid=item.nodeid, location=item.location, keywords={}, outcome='passed', longrepr=None, when='call',
        user_properties=[('tap', counts), ('kept', True)]))
    hook.pytest_runtest_logfinish(nodeid=item.nodeid, location=item.location)
    return True


def seconds():
    own, children = resource.getrusage(resource.RUSAGE_SELF), resource.getrusage(resource.RUSAGE_CHILDREN)
    return own.ru_utime + own.ru_stime + children.ru_utime + children.ru_stime


@pytest.hookimpl(hookwrapper=True)
def pytest_runtest_makereport(item, call):
    """A test whose parts all passed is kept; what it took goes to the report."""
    outcome = yield
    report = outcome.get_result()
    if call.when == 'setup':
        item.good, item.began = True, getattr(item, 'began', seconds())
    item.good = item.good and report.passed
    if call.when == 'teardown':
        report.user_properties.append(('takes', (name_of(item), seconds() - item.began)))
        if item.good and item.config.getoption('keep'):
            counts = dict(item.user_properties).get('tap', (1, 0, 0))
            KEPT.mkdir(parents=True, exist_ok=True)
            whole = place_of(item).with_suffix(f'.{os.getpid()}')
            whole.write_text(json.dumps({'state': state_of(item), 'tap': counts}))
            whole.rename(place_of(item))


@pytest.hookimpl(tryfirst=True)
def pytest_runtest_setup(item):
    item.began = seconds()
