"""Plants of the host that wait for a tool of measurement and calibration."""
import contextlib
import os
import re
import signal
import subprocess
import time

from harness.project import ROOT

CART = ROOT / 'tests/core/xcp/masters/cart.scene'
# Of a test that waits for an event.
PATIENCE = 1800


def until(process, happened):
    """Waits until this is so, for as long as the process lives; what it gives."""
    while not (found := happened()):
        assert process.poll() is None, 'it has ended'
        time.sleep(0.02)
    return found


@contextlib.contextmanager
def waiting(program, folder, kind='tcp', command=(), words=(), waits=False):
    """A plant whose controller's channel is a socket in the folder, and its calibration a free port: the address of that. It
    is ended behind this, or waited for."""
    controller, said = folder / 'controller', folder / 'said'
    controller.unlink(missing_ok=True)
    with open(said, 'w') as errors, open(folder / 'summary', 'w') as output:
        process = subprocess.Popen(
            [str(word) for word in (*command, program, *words)], stdin=subprocess.DEVNULL, stdout=output, stderr=errors,
            env={**os.environ, 'ISOCHRON_CONTROLLER': f'unix:{controller}', 'ISOCHRON_CALIBRATION': f'{kind}:0'})
    try:
        port = until(process, lambda: re.search(f' waiting at ({kind}:.*)\n', said.read_text()))[1]
        until(process, controller.exists)
        yield port
        if waits:
            process.wait(PATIENCE)
    finally:
        if process.poll() is None:
            process.send_signal(signal.SIGTERM)
            process.wait()
