"""Files that isoc writes together: if the disk refuses the name of the second, the first one is as it was, or is not there."""
import os
import subprocess

import pytest

# The n-th file that is renamed is refused.
REFUSING = '''#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
int rename(const char *old, const char *new)
{
    static int count;
    if (++count == atoi(getenv("REFUSED"))) {
        errno = EIO;
        return -1;
    }
    return renameat(AT_FDCWD, old, AT_FDCWD, new);
}
'''


@pytest.fixture
def compiled(tmp_path):
    """compiled(model, refused): the status of isoc, and the files that are there then."""
    (tmp_path / 'refuse.c').write_text(REFUSING)
    subprocess.run(['gcc', '-shared', '-fPIC', '-D_POSIX_C_SOURCE=200809L', tmp_path / 'refuse.c', '-o', tmp_path / 'refuse.so'], check=True)

    def call(model, refused=0, folder='plant'):
        done = subprocess.run(['build/isoc', f'models/{model}.scene', '-o', tmp_path / folder], capture_output=True,
                              env={**os.environ, 'REFUSED': str(refused), 'LD_PRELOAD': str(tmp_path / 'refuse.so')})
        return done.returncode, {path.name: path.read_text() for path in (tmp_path / folder).glob('*')}

    return call


@pytest.mark.parametrize('refused', [1, 2])
def test_where_a_name_is_refused_the_old_files_are_there_and_nothing_else(compiled, refused):
    status, before = compiled('pendulum')
    assert status == 0 and set(before) == {'plant.c', 'plant.h'}
    assert compiled('tree', refused) == (1, before)
    assert compiled('tree', 2, 'new') == (1, {}), 'where there were none, there are none'
    status, other = compiled('tree')
    assert status == 0 and other != before
