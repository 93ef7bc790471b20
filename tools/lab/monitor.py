"""isochron monitor: the terminal of measurement and calibration over XCP, tools/monitor."""
import os

from . import build


def run(options):
    monitor = build.tools('monitor')
    os.execv(monitor, [monitor, *options.words])
