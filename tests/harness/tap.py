"""Tests that are no Python: unit tests in C, programs over whole domains, and shell scripts. Each is a program that
prints TAP, a line for each of its results.

A unit test is run in four variants, in float and in double: on the host, there under memcheck and with sanitizers, and
on a Cortex-M4F in QEMU (tests/units.mk).
"""
import os
import re
import subprocess

import pytest

from harness import project

VARIANTS = ('plain', 'memcheck', 'asan', 'm4f')
REALS = ('float', 'double')
STARTERS = {
    'plain': [], 'asan': [],
    'memcheck': 'valgrind --quiet --error-exitcode=99 --leak-check=full --show-leak-kinds=all '
                '--errors-for-leak-kinds=all'.split(),
    'm4f': 'qemu-system-arm -M mps2-an386 -icount shift=10,align=off,sleep=off -display none -monitor none -serial none '
           '-semihosting-config enable=on,target=native -kernel'.split(),
}
SHOWN = 40  # lines of a failure; all stand in the log
# Seconds: whatever runs for longer is killed, has no plan, and counts as failed; of all turns at once so many times that.
PATIENCE = 1800
WHOLE = 8


class Wrong(Exception):
    """A program whose results are not all right."""


class Results:
    """What a program printed, counted. One that ends badly without naming a failed test, or that does not keep to its plan,
    has one failure."""

    def __init__(self, text, status):
        self.lines, self.status = text.splitlines(), status
        results = [line for line in self.lines if re.match(r'(not )?ok\b', line)]
        skipped = [line for line in results if re.search(r'# SKIP', line)]
        self.failed = sum(line.startswith('not') for line in results)
        self.skipped, self.skips = len(skipped), [line.split('# SKIP')[1].strip() for line in skipped]
        self.passed = len(results) - self.failed - self.skipped
        plans = [line for line in self.lines if re.fullmatch(r'1\.\.\d+( *# *SKIP.*)?', line)]
        self.whole = len(plans) == 1 and int(re.match(r'1\.\.(\d+)', plans[0])[1]) == len(results)
        if plans and plans[0].startswith('1..0'):
            self.skipped, self.skips = 1, [plans[0].split('# SKIP')[-1].strip()]
            self.whole = status == 0 and 'SKIP' in plans[0]
        if not self.failed and (status != 0 or not self.whole or not results and not self.skipped):
            self.failed = 1

    def reason(self):
        """The failed results with the comments around them, or the last lines."""
        named = [line for line in self.lines if re.match(r'not ok|#|Bail out', line)]
        if not any(line.startswith('not ok') for line in named):
            named = self.lines[-20:] + ([] if self.whole else ['# the results are not those of the plan'])
        return '\n'.join([f'status {self.status}'] + named[-SHOWN:])


class Program(pytest.Item):
    """A program that prints TAP: `command`; `goals` builds it."""

    def __init__(self, *, command, goals, state, variant=None, **of_item):
        super().__init__(**of_item)
        self.command, self.goals, self.state, self.variant = command, goals, state, variant
        if variant:
            self.user_properties.append(('variant', variant))

    def runtest(self):
        project.make(*self.goals)
        patience = PATIENCE * (WHOLE if os.environ.get('TEST_WHOLE') else 1)
        done = subprocess.run(['timeout', str(patience), *self.command], cwd=project.ROOT, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL,
                              env={'TEST_TURN': str(project.turn_of(self.path)), **os.environ})
        text = done.stdout.decode(errors='replace')
        log = project.BUILD / 'log' / self.nodeid.replace('::', '/')
        log.parent.mkdir(parents=True, exist_ok=True)
        log.write_text(text)
        results = Results(text, done.returncode)
        self.user_properties += [('tap', (results.passed, results.failed, results.skipped)), ('skips', results.skips)]
        if results.failed:
            raise Wrong(results.reason())

    def repr_failure(self, excinfo):
        return str(excinfo.value) if isinstance(excinfo.value, Wrong) else super().repr_failure(excinfo)

    def reportinfo(self):
        return self.path, None, self.nodeid


class UnitTest(pytest.File):
    """tests/core/ROOM/NAME.c, in all variants."""

    def collect(self):
        for variant in VARIANTS:
            for real in REALS:
                built = 'plain' if variant == 'memcheck' else variant
                program = f'build/tests/{built}/{real}/{self.path.parent.name}/{self.path.stem}'
                yield Program.from_parent(
                    self, name=f'{variant}-{real}', variant=(variant, real), command=STARTERS[variant] + [program],
                    goals=['-f', 'tests/units.mk', f'VARIANT={built}', f'REAL={real}', program],
                    state=lambda program=program: project.state_of(project.files_in(program)))


class WholeDomain(pytest.File):
    """tests/core/numbers/exhaustive/NAME.c. Of the numbers of a domain some are tried, and whose turn it is follows from the text of
    core."""

    def collect(self):
        stride = 'all' if os.environ.get('TEST_WHOLE') else '1'
        held = project.files_in('core'), project.files_in(str(self.path.parent.relative_to(project.ROOT)))
        turn = str(int(project.state_of(held)[:8], 16))
        for real in REALS:
            program = f'build/tests/plain/{real}/numbers/exhaustive/{self.path.stem}'
            yield Program.from_parent(self, name=real, command=[program, stride, turn],
                                      goals=['-f', 'tests/units.mk', 'VARIANT=plain', f'REAL={real}', program],
                                      state=lambda: project.state_of(held))


class Script(pytest.File):
    """A shell script."""

    def collect(self):
        yield Program.from_parent(self, name='script', command=['sh', str(self.path.relative_to(project.ROOT))],
                                  goals=project.TOOLS, state=lambda: project.state_of_test(self.path))


def pytest_collect_file(file_path, parent):
    kind = None
    if file_path.suffix == '.t':
        kind = Script
    elif file_path.suffix == '.c' and file_path.parents[1].name == 'core' and file_path.parents[2].name == 'tests':
        kind = UnitTest
    elif file_path.suffix == '.c' and file_path.parent.name == 'exhaustive':
        kind = WholeDomain
    return kind and kind.from_parent(parent, path=file_path)
