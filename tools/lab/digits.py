"""`isochron digits`: the digits that reference solutions are met with, as the tests measure them."""
import os
import subprocess

from lab import build, table
from lab.build import ROOT, Wrong

HEAD = ['reference', 'real', 'step', 'until', 'largest error', 'digits', 'demanded', 'energy off by, J', 'demanded']


def run(_):
    build.make('build/isoc build/tests/requests')
    rows = []
    for test, kept in ('reference', 'reference'), ('mechanisms', 'reference_mechanisms'):
        with build.progress(f'runs tests/reference/{test}.t'):
            done = subprocess.run(['sh', f'tests/reference/{test}.t'], cwd=ROOT, capture_output=True, text=True,
                                  env={**os.environ, 'MAKES_DIGITS': 'yes'})
        if done.returncode:
            raise Wrong('\n'.join(line for line in done.stdout.splitlines() if line.startswith('not ok')))
        rows += table.read(ROOT / f'build/tests/{kept}/digits', '|')
    table.show(HEAD, (row[1:-1] for row in rows), 'lllrrrrrr')
