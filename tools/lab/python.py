"""isochron python: a package of Python that has the plant of a scene in it, for pip or PYTHONPATH."""
import shutil

from . import build


def run(options):
    package(options)


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
