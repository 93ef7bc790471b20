"""isochron import: turns robots of URDF and MJCF into scenes, tools/import."""
import os
import sys

from . import build


def run(options):
    os.execv(sys.executable, [sys.executable, '-B', build.ROOT / 'tools/import', *options.words])
