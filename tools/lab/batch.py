"""`isochron batch`: how many steps of a plant a core makes in a second: of one alone, and of 8, 16 and 32 side by side
(isoc --lanes), with all parts of a tick: checks of inputs, guard, outputs. Compiled for this processor, as the width of
its vectors matters. Beside them those of MuJoCo, where its library is installed, with the mechanism that isoc --mjcf
writes: RK4 of the same step, in double, without contact. Each is measured three times, in turns, and the best counts:
other work of the machine makes it slower, never faster."""
import collections
import os
import re
import subprocess

from lab import build, table
from lab.build import Wrong

LANES = 1, 8, 16, 32
MEASURE = build.ROOT / 'tools/measure'


def mujoco(options, folder):
    """The command of a run by MuJoCo, and what its model leaves out of the scene; or None, and why there is none."""
    try:
        build.host_program('headers', ['-E', MEASURE / 'mujoco.c'], (), (), stderr=subprocess.PIPE)
    except Wrong:
        return None, 'libmujoco is not installed (apt-get install libmujoco-dev)'
