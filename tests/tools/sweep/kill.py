# Begins a command, and kills all that it has started when so many parts of a sweep are there.
#
#     kill.py FOLDER PARTS COMMAND...
#
# Prints how many are there then; ends with 1 where the command was done before.
import glob
import os
import signal
import subprocess
import sys
import time

folder, wanted, command = sys.argv[1], int(sys.argv[2]), sys.argv[3:]


def parts():
    return len(glob.glob(folder + "/*/parts/*.tsv"))


def session(leader):
    """All processes of the session, whatever their groups are."""
    for path in glob.glob("/proc/[0-9]*/stat"):
        try:
            with open(path) as file:
                fields = file.read().rsplit(")", 1)[1].split()
        except OSError:
            continue
        if int(fields[3]) == leader:
            yield int(path.split("/")[2])


with open(os.devnull, "w") as nothing:
    child = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=nothing, stderr=nothing, start_new_session=True)
while child.poll() is None and parts() < wanted:
    time.sleep(0.01)
was_running = child.poll() is None
for _ in range(3):
    for process in session(child.pid):
        try:
            os.kill(process, signal.SIGKILL)
        except OSError:
            pass
child.wait()
print(parts())
sys.exit(0 if was_running else 1)
