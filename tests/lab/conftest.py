"""Commands of isochron in a folder of their own, and pictures that are read back."""
import os
import subprocess
import sys
import types

import pytest

from harness import project

sys.path.insert(0, str(project.ROOT / 'tools'))


@pytest.fixture(scope='module')
def isochron(tmp_path_factory):
    """isochron(command, ...): what it prints. With `refused` it must end with status 1 and say this, and no traceback.
    `isochron.folder` is where it works, `isochron.said` what the last call said."""
    project.make('tools', 'build/regions')
    folder = tmp_path_factory.mktemp('isochron')

    def call(*words, refused=None, **environment):
        done = subprocess.run([sys.executable, project.ROOT / 'tools/isochron', *map(str, words)], cwd=folder, text=True,
                              capture_output=True, stdin=subprocess.DEVNULL, env={**os.environ, **environment})
        call.said = done.stderr
        if refused is None:
            assert done.returncode == 0, done.stderr[-3000:]
        else:
            assert done.returncode == 1 and refused in done.stderr and 'Traceback' not in done.stderr, done.stderr[-3000:]
        return done.stdout

    call.folder = folder
    return call


@pytest.fixture(scope='session')
def shows(tmp_path_factory):
    """shows(svg, (points, how), ...): what is wrong with a picture: nothing, if it shows these points, rows of panel,
    curve, abscissa and ordinate, as tests/picture/main.c reads them, and no text of it is cut off."""
    folder = tmp_path_factory.mktemp('picture')
    program = folder / 'picture'
    sources = sorted((project.ROOT / 'tests/picture').glob('*.c'))
    subprocess.run(['gcc', '-std=c11', '-O1', '-D_POSIX_C_SOURCE=200809L', '-I', project.ROOT, *sources, '-o', program, '-lm'],
                   check=True)

    def read(svg, *expected):
        words = [program, svg]
        for number, (points, how) in enumerate(expected):
            file = folder / f'points{number}'
            file.write_text(''.join('\t'.join(map(str, row)) + '\n' for row in points))
            words += [file, how]
        done = subprocess.run(words, capture_output=True, text=True)
        return '' if done.returncode == 0 else done.stdout[:2000] + done.stderr[:2000] or 'it is wrong'

    return read


@pytest.fixture
def drawn(tmp_path):
    """drawn(picture): the svg of a picture of the laboratory; of the text of its commands too."""
    from lab import draw

    def of(picture, name='drawn'):
        if isinstance(picture, str):
            width, height = picture.split('\n', 1)[0].split()[2:]
            text, picture = picture, types.SimpleNamespace(width=int(width), height=float(height))
            picture.text = lambda: text
        draw.draw({tmp_path / name: picture}, png=False)
        return tmp_path / f'{name}.svg'

    return of
