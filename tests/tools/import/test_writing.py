"""Where a scene cannot be written, isochron import says so and ends with 1; what was there stays, and nothing else is left."""
import os
import pathlib
import resource
import subprocess

import pytest

ROBOT = 'tests/tools/import/arm.urdf'
ALL = ['tools/isochron', 'import', ROBOT]
# The old way: the file is open, and so empty, before its text is there.
AT_ONCE = ['python3', '-c', 'import subprocess, sys; text = subprocess.run(sys.argv[1:4], capture_output=True).stdout\n'
           'open(sys.argv[5], "wb").write(text)', *ALL]


def run(command, most_bytes=None, **more):
    """As on a disk that has room for so many bytes."""
    def limit():
        if most_bytes is not None:
            resource.setrlimit(resource.RLIMIT_FSIZE, (most_bytes, most_bytes))

    return subprocess.run(command, preexec_fn=limit, stderr=subprocess.PIPE, text=True, **more)


@pytest.fixture
def scene(tmp_path):
    path = tmp_path / 'arm.scene'
    path.write_text('as it was\n')
    return path


def assert_kept(path):
    assert path.read_text() == 'as it was\n' and os.listdir(path.parent) == [path.name]


def test_a_full_disk(scene):
    made = run([*ALL, '-o', scene], most_bytes=1000)
    assert made.returncode == 1
    assert made.stderr == f'import: error: {scene} cannot be written: File too large\n'
    assert_kept(scene)


def test_found_one_that_writes_at_once(scene):
    run([*AT_ONCE, '-o', scene], most_bytes=1000)
    with pytest.raises(AssertionError):
        assert_kept(scene)


@pytest.mark.parametrize('place, why', [('none/arm.scene', 'No such file or directory'), ('.', 'Is a directory')])
def test_no_such_place(tmp_path, place, why):
    made = run([*ALL, '-o', tmp_path / place])
    assert made.returncode == 1 and made.stderr == f'import: error: {tmp_path / place} cannot be written: {why}\n'
    assert os.listdir(tmp_path) == []


@pytest.mark.parametrize('options, what', [([], 'scene'), (['-o', 'arm.scene'], 'report')])
def test_a_pipe_that_is_closed_and_a_full_device(tmp_path, options, what):
    words = [pathlib.Path(ALL[0]).resolve(), ALL[1], pathlib.Path(ROBOT).resolve()]
    reader, writer = os.pipe()
    os.close(reader)
    for out, why in ((writer, 'Broken pipe'), (os.open('/dev/full', os.O_WRONLY), 'No space left on device')):
        made = run([*words, *options], stdout=out, cwd=tmp_path)
        os.close(out)
        assert made.returncode == 1 and made.stderr == f'import: error: the {what} cannot be printed whole: {why}\n'
    if options:  # the scene is whole, and only the report is not seen
        assert (tmp_path / 'arm.scene').read_text().endswith('output energy = energy\n')


def test_through_a_link_into_the_file_with_its_mode(tmp_path):
    path, link = tmp_path / 'arm.scene', tmp_path / 'link.scene'
    path.write_text('')
    path.chmod(0o640)
    link.symlink_to(path)
    assert run([*ALL, '-o', link], stdout=subprocess.DEVNULL).returncode == 0
    assert link.is_symlink() and path.stat().st_mode & 0o777 == 0o640 and path.stat().st_size > 1000


def test_a_warning_is_seen_beside_a_scene_that_is_printed(tmp_path):
    odd = tmp_path / 'odd.urdf'
    odd.write_text(pathlib.Path(ROBOT).read_text().replace('izz="0.01"', 'izz="0.09"'))
    made = run(['tools/isochron', 'import', odd], stdout=subprocess.PIPE)
    assert made.returncode == 0 and 'as_given' in made.stdout
    assert made.stderr.startswith('- warning: no body has the inertia of upper: its largest principal moment is 6.09 % larger')
