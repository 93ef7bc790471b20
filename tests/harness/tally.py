"""The last line, `N passed, N failed, N skipped`: results, of which a program that prints TAP has many, and a test in Python
one; before it what was skipped, and why. What each test took stands in build/tests/takes.txt, the longest first; what
failed so far in build/tests/failed."""
import collections
import os

import pytest

from harness import project


class Tally:
    def __init__(self, is_of_all):
        """Only a run of all tests writes files: a test may itself run pytest."""
        self.is_of_all = is_of_all
        self.passed = self.failed = self.skipped = self.kept = 0
        self.variants = collections.defaultdict(collections.Counter)
        self.takes = collections.Counter()
        self.skips = []
        project.BUILD.mkdir(parents=True, exist_ok=True)
        self.failures = open(project.BUILD / 'failed' if is_of_all else os.devnull, 'w', buffering=1)

    def pytest_runtest_logreport(self, report):
        properties = dict(report.user_properties)
        if report.failed:
            self.failures.write(f'{report.nodeid}\n{report.longreprtext}\n\n')
        if report.when == 'teardown' and 'takes' in properties:
            name, seconds = properties['takes']
            self.takes[name] += seconds
        if report.when != 'call' and report.passed:
            return
        self.kept += 'kept' in properties
        passed, failed, skipped = properties.get('tap', (report.passed, report.failed, report.skipped))
        failed = max(failed, report.failed)
        self.passed, self.failed, self.skipped = self.passed + passed, self.failed + failed, self.skipped + skipped
        of_python = [report.longrepr[2].removeprefix('Skipped: ')] if report.skipped else []
        self.skips += [f'{report.nodeid}: {why}' for why in properties.get('skips', of_python)]
        if 'variant' in properties:
            variant, real = properties['variant']
            self.variants[real][variant] += passed + failed + skipped

    def pytest_collectreport(self, report):
        self.failed += report.failed

    def unequal(self):
        """The variants of the unit tests must have equal numbers of results; those of a run by itself are not compared."""
        for real, counts in sorted(self.variants.items()):
            if len(counts) > 1:
                yield real, counts, len(set(counts.values())) > 1

    @pytest.hookimpl(hookwrapper=True, tryfirst=True)
    def pytest_sessionfinish(self, session):
        yield
        if self.kept:
            print(f'{self.kept} tests were not run again: they passed, and nothing that they follow from has changed')
        for real, counts, are_unequal in self.unequal():
            print(f'unit tests in {real}: ' + ', '.join(f'{variant} {n}' for variant, n in sorted(counts.items())))
            self.failed += are_unequal
            self.passed += not are_unequal
        lines = [f'{seconds:7.1f} {name}\n' for name, seconds in self.takes.most_common()]
        project.BUILD.mkdir(parents=True, exist_ok=True)
        if self.is_of_all:
            (project.BUILD / 'takes.txt').write_text(''.join(lines))
        for line in sorted(self.skips):
            print(f'skipped: {line}')
        skipped = f', {self.skipped} skipped' if self.skipped else ''
        print(f'{self.passed} passed, {self.failed} failed{skipped}')
        if self.failed and session.exitstatus == 0:
            session.exitstatus = 1


def pytest_configure(config):
    # Workers tell the process that began them.
    if not hasattr(config, 'workerinput'):
        config.pluginmanager.register(Tally(config.getoption('keep')), 'tally')
