"""`isochron linear`: the linear model of a scene about a point, with its modes, and a Bode plot that is checked on the
plant (tools/linear/README.md)."""
import subprocess
import pathlib

from lab import build, table
from lab.build import ROOT, Wrong
from lab.draw import draw
from lab.picture.curves import bode

FILES = 'matrices.tsv', 'states.tsv', 'modes.tsv', 'linear_model.m', 'linear_model.py'


def run(options):
    folder = build.outputs('linear', options.scene, options)
    for pattern in '*.tsv', 'linear_model.*', 'point.txt', 'state.txt', 'bode.*':
        for old in folder.glob(pattern):
            old.unlink()
    # The plants are double: the point and the slopes are as exact as that.
    choices = build.isoc_options(options, real='double')
    if options.at or options.bode:
        program = driven(options, folder, choices)
    if options.at:
        done = subprocess.run([program, 'reach', str(build.nanoseconds(options.at))], stdout=subprocess.PIPE, text=True)
        if done.returncode:
            raise Wrong('the plant does not come so far')
        (folder / 'state.txt').write_text(done.stdout)
        choices += ['--state', folder / 'state.txt']
    if options.trim:
        choices += ['--trim', options.trim]
    print(build.call([build.tools('isoc'), options.scene, '-o', folder, '--linear', *choices]), end='')
    if options.bode:
        done = subprocess.run([program, 'bode', folder / 'point.txt', options.bode], capture_output=True, text=True)
        if done.returncode:
            raise Wrong(done.stderr.rstrip())
        (folder / 'bode.tsv').write_text(done.stdout)
        print(done.stderr, end='')
    for name in FILES:
        print(folder / name)
    if options.bode:
        print(folder / 'bode.tsv')
        head, *rows = table.read(folder / 'bode.tsv')
        for path in draw({folder / 'bode': bode(pathlib.Path(options.scene).stem, options.bode, rows,
                                                head[2].removeprefix('gain '))}):
            print(path)


def driven(options, folder, choices):
    """The program that runs and drives the plant in double."""
    (folder / 'plant.txt').write_text(build.call([build.tools('isoc'), options.scene, '-o', folder, *choices]))
    sources = [*ROOT.glob('tools/linear/*.c'), ROOT / 'tools/file/file.c', folder / 'plant.c',
               *ROOT.glob('core/numbers/*.c')]
    with build.progress(f'compiles {options.scene}'):
        return build.host_program(folder / 'linear', sources, ['-DISO_REAL_DOUBLE', '-DISO_UNROLL=', f'-I{folder}'])
