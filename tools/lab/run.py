"""isochron run: runs a scene, writes its trace, and prints a summary."""
import os
import pathlib
import shutil

from . import build


def run(options):
    build.check(vars(options))
    if options.snapshot or options.restore:
        bench = build.plant(options, kind='recorded', isoc=['--link'], files={'request.c': request(options)})
    else:
        bench = build.plant(options)
    for line in bench.said.splitlines():
        if line.startswith(('assembled ', 'dead_position ')):
            print(line, flush=True)
    bench.run(options.seconds, script=options.script, quiet=False)
    if not options.restore:       # isoc does not know the tunables of a snapshot
        bench.ended()
    if options.keep:
        keep(bench.folder, options.keep)


def request(options):
    """The request of a run, in C (core/snapshots/request.h): the snapshot to begin at, and the tick of one to take."""
    if options.scene.endswith('.c'):
        raise build.Wrong('a plant in C has no snapshots of its runs: they are for scenes')
    at = f'UINT64_C({options.snapshot})' if options.snapshot else 'ISO_REQUEST_NONE'
    head = '#include "core/snapshots/request.h"\n\n'
    if not options.restore:
        return f'{head}const iso_request iso_the_request = {{.at = {at}}};\n'
    snapshot = pathlib.Path(options.restore).read_bytes() if os.path.exists(options.restore) else b''
    if not snapshot.startswith(b'ISOS'):
        raise build.Wrong(f'--restore {options.restore} is no snapshot; isochron run --snapshot TICK writes one')
    return (f'{head}static const unsigned char from[] = {{{", ".join(map(str, snapshot))}}};\n\n'
            f'const iso_request iso_the_request = {{.at = {at}, .from = from, .from_bytes = sizeof from}};\n')


def keep(folder, name):
    """Keeps a run under a name, for isochron compare."""
    kept = pathlib.Path('build/runs', name)
    kept.mkdir(parents=True, exist_ok=True)
    for file in ('trace.csv', 'units.csv', 'summary.txt'):
        shutil.copy(folder / file, kept)
