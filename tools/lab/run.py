"""isochron run: runs a scene, writes its trace, and prints a summary."""
import shutil
import pathlib
import sys

from . import build


def run(options):
    if options.snapshot or options.restore:
        raise build.Wrong('snapshots are not here yet')
    bench = build.plant(options)
    for line in bench.said.splitlines():
        if line.startswith(('assembled ', 'dead_position ')):
            print(line, flush=True)
    bench.run(options.seconds, script=options.script, quiet=False)
    bench.ended()
    if options.keep:
        keep(bench.folder, options.keep)


def keep(folder, name):
    """Keeps a run under a name, for isochron compare."""
    kept = pathlib.Path('build/runs', name)
    kept.mkdir(parents=True, exist_ok=True)
    for file in ('trace.csv', 'units.csv', 'summary.txt'):
        shutil.copy(folder / file, kept)
