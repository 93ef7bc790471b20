"""isochron batch has a row for one plant, and for 8, 16 and 32 side by side; it finds a lane with other bits."""
import os
import subprocess

from harness.project import ROOT

PENDULUM = ROOT / 'models/pendulum.scene'


def test_a_row_for_each_number_of_lanes(isochron):
    of = isochron('batch', PENDULUM, EACH='0.001', CFLAGS='-O1')
    assert of.status == 0, of.errors
    assert [row[0] for row in of.rows[2:6]] == ['1', '8', '16', '32']
    assert all('million' in row[1] for row in of.rows[2:])
    has_mujoco = not subprocess.run(['cc', '-E', '-x', 'c', '-'], input='#include <mujoco/mujoco.h>\n', text=True,
                                    capture_output=True).returncode
    assert has_mujoco == (of.rows[-1][0].startswith('MuJoCo') and of.rows[-1][0].endswith(', one in double, RK4'))


def test_found_lanes_that_compute_with_other_constants_and_no_mujoco(isochron, tmp_path):
    (tmp_path / 'mujoco').mkdir()
    (tmp_path / 'mujoco/mujoco.h').write_text('#error "none"\n')
    off = ROOT / 'tests/isoc/emit/lanes/off.h'
    assert os.path.exists(off)
    of = isochron('batch', PENDULUM, EACH='0.001', CFLAGS=f'-O1 -include {off} -I{tmp_path}')
    assert of.status == 1 and 'a lane has other bits than the plant alone' in of.errors
    assert 'No row of MuJoCo: libmujoco is not installed' in of.printed
