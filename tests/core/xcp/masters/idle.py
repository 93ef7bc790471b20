"""Clients of a plant's calibration of which one is idle: it gives way when another waits, and only then. Prints TAP.

    idle.py CALIBRATION SECONDS

An idle client is closed after so many SECONDS."""
import sys
import time

import master

ADDRESS, SECONDS = sys.argv[1], int(sys.argv[2])
HOST, PORT = ADDRESS.split(":")[1:]


def result(number, good, name):
    print("%s %d - %s" % ("ok" if good else "not ok", number, name), flush=True)


def is_closed(stream):
    """Waits for the end of the stream."""
    return stream.recv(1) == b""


# Alone, a client may be idle for longer: then it is still served.
alone = master.Master(ADDRESS, False)
alone.connect()
time.sleep(SECONDS + 1)
alone.status()
result(1, True, "a client that is alone stays connected")
alone.close()

# An idle one gives way.
idle = master.connect(ADDRESS)
waiting = master.Master(ADDRESS, False)
waiting.connect()
result(2, is_closed(idle), "an idle client is closed, and the one that waits is served")

# One that sends commands does not. Where the machine stops this program for as long, nothing is shown, and it begins
# anew.
while True:
    other = master.connect(ADDRESS)
    longest, last, begin = 0.0, time.monotonic(), time.monotonic()
    try:
        while time.monotonic() < begin + SECONDS + 1:
            waiting.status()
            now = time.monotonic()
            longest, last = max(longest, now - last), now
        good = True
    except (OSError, master.Refused):
        good = False
    other.close()
    if good or longest < SECONDS / 2:
        break
    waiting = master.Master(ADDRESS, False)
    waiting.connect()
result(3, good, "a client that sends commands stays, while another waits")
print("1..3")
