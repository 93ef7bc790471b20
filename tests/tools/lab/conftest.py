"""Pictures of the laboratory, and what is read back of them."""
import subprocess
import types

import pytest

from harness import project


@pytest.fixture(scope='session')
def shows(tmp_path_factory):
    """shows(svg, (points, how), ...): what is wrong with a picture: nothing, if it shows these points, rows of panel,
    curve, abscissa and ordinate, as tests/tools/lab/picture/main.c reads them, and no text of it is cut off."""
    folder = tmp_path_factory.mktemp('picture')
    program = folder / 'picture'
    sources = sorted((project.ROOT / 'tests/tools/lab/picture').glob('*.c'))
    subprocess.run(['gcc', '-std=c11', '-O1', '-D_POSIX_C_SOURCE=200809L', '-I', project.ROOT, *sources, '-o', program,
                    '-lm'],
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
def drawn(laboratory, tmp_path):
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
