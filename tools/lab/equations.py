"""isochron equations: the equations of a scene for a reader, with the names of plant.c."""
from . import build


def run(options):
    file = build.outputs('equations', options.scene, options) / ('equations.tex' if options.format == 'latex' else 'equations.txt')
    build.call([build.tools('isoc'), options.scene, *build.isoc_options(options), '--equations', options.format, '-o', file])
    print(f'equations {file}')
