"""The program of a plant with painted.c in place of main: painted.py PLANT.o TARGET PROGRAM [FLAG...], in the copy of the
project."""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path('tools').resolve()))
from lab import build  # noqa: E402

plant, target, program, *flags = sys.argv[1:]
port = build.port(target)
objects = [name for name in port.facts['OBJECTS'].split() if not name.endswith('application/main.o')]
build.call([*port.compile, *flags, '-c', 'tests/promises/determinism/painted.c', '-o', 'painted.o'])
build.call([*port.link, plant, 'painted.o', *objects, *port.libraries.split(), '-o', program])
