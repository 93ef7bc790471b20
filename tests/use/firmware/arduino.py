"""A plant as a library of Arduino: the commands by which the core for the AVR compiles it, from its platform.txt."""
import pathlib
import re
import subprocess

import pytest

CORE = pathlib.Path('/usr/share/arduino/hardware/arduino/avr')
MODELS = sorted(pathlib.Path('models').glob('*.scene'))
PENDULUM = pathlib.Path('models/pendulum.scene').read_text()
ROWS = [[cell.strip() for cell in line.split('|')] for line in pathlib.Path('tools/measure/library.txt').read_text().splitlines()
        if '|' in line and line[0] != '#']
BASES = {name: (signal, statements) for word, name, signal, statements in ROWS if word == 'base'}
EFFECTS = {kind: row for kind, *row in ROWS if kind != 'base'}
ROOTS = pathlib.Path('tests/isoc/formula/functions/all.scene')
SKETCH = '''#include <Arduino.h>
#include <plant_of_it.h>
#include <core/runtime/tick.h>
static plant_of_it_memory memory;
static const iso_plant swing = plant_of_it_plant(&memory);
void setup() { pinMode(13, iso_plant_start(&swing) ? OUTPUT : INPUT); }
void loop() { static uint32_t tick; (void)iso_plant_tick(&swing, tick++); }
'''
needs_the_core = pytest.mark.skipif(not CORE.exists(), reason='arduino-core-avr is not installed')


def with_effect(kind):
    base, signal, statements = EFFECTS[kind]
    own, both = BASES[base]
    return PENDULUM + both.replace('SIGNAL', signal or own) + '\n' + statements + '\n'


def properties(path):
    pairs = (line.split('=', 1) for line in path.read_text().splitlines() if '=' in line and line[0] != '#')
    return {key: value for key, value in pairs}


def recipe(language, board, source, made, includes):
    """The command of the core for a file, as arduino-cli makes it (Arduino, Platform specification)."""
    known = properties(CORE / 'platform.txt')
    of_board = {key.removeprefix(board + '.'): value for key, value in properties(CORE / 'boards.txt').items()
                if key.startswith(board + '.')}
    known |= of_board | {
        'runtime.ide.version': '10819', 'build.arch': 'AVR', 'source_file': str(source), 'object_file': str(made),
        'includes': ' '.join(f'"-I{path}"' for path in (CORE / 'cores/arduino', CORE / 'variants/standard', *includes))}
    command = known[f'recipe.{language}.o.pattern']
    while '{' in command:
        command = re.sub(r'\{([^{}]*)\}', lambda name: known[name[1]], command)
    return command


def package(isoc, scene):
    made = isoc(scene, '--name', 'plant_of_it', '--standalone')
    assert made.status == 0, made.errors
    return made.folder


def compiled(folder, language, source, *more):
    command = recipe(language, 'uno', folder / source, folder / (source + '.o'), [folder])
    return subprocess.run(' '.join((command, *more)), shell=True, capture_output=True, text=True)


def wanted(tool, path):
    """The symbols that an object does not define."""
    return set(subprocess.run([tool, '-u', path], check=True, capture_output=True, text=True).stdout.split()) - {'U'}
