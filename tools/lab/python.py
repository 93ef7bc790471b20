"""isochron python: a package of Python that has the plant of a scene in it, for pip or PYTHONPATH; with --lanes a library
of many plants side by side, for tools/python/lanes.py."""
import pathlib
import re

from . import build


def run(options):
    if options.lanes:
        lanes(options)
    else:
        package(options)


def lanes(options):
    """Makes lanes.so, for this processor."""
    if options.lanes == '1':
        raise build.Wrong('--lanes 1 is one plant, and no lanes; without --lanes the package has that')
    place = pathlib.Path(options.out or pathlib.Path('build/host', options.real or 'float', build.name_of(options.scene)))
    plant = build.plant(options, 'none', place / 'lanes', isoc=['--lanes'])
    header, library = (plant.folder / 'plant.h').read_text(), plant.folder / 'lanes.so'
    without = [f'-DISO_SIDE_NO_{names}' for names in ('INPUTS', 'PARAMETERS') if not re.search(rf'^ *PLANT_{names}$', header, re.M)]
    double = ['-DISO_REAL_DOUBLE'] if plant.real == 'double' else []
    with build.progress(f'compiles {options.lanes} plants side by side'):
        build.host_program(library, [build.ROOT / 'tools/python/lanes.c', build.ROOT / 'core/numbers/self_check.c'],
                           ['-march=native', '-Wno-psabi', '-fPIC', '-fvisibility=hidden', '-shared', *double,
                            f'-DISO_LANES={options.lanes}', *without, '-iquote', plant.folder])
    print(f'library {library}')


def package(scene, quiet=False, **more):
    """Makes the package of a scene (its path, or options) in the folder `python` of its plant; returns that folder. The
    library is of the scene alone: the folder of its module has it."""
    bench = build.plant(scene, kind='python', isoc=['--python'], **more)
    for module in bench.sources.glob('*_plant'):
        library = module / 'plant.so'
        if not (library.exists() and library.samefile(bench.program)):
            library.unlink(missing_ok=True)
            library.hardlink_to(bench.program)
    if not quiet:
        print(f'package {bench.sources}')
    return bench.sources
