#!/bin/sh
# TARGET=posix: the plant of the host in real time. It has the same bits, whatever the system does to its ticks; nothing
# is said of how long anything takes.
. tests/host/test.sh
. tests/host/project.sh
begin link/posix
project

isochron run models/double_pendulum.scene --target host --seconds 0.3 && hash=$(value hash)
expect $? "isochron run models/double_pendulum.scene --target host"
cp "$out/project/build/host/float/double_pendulum/trace.csv" "$out/host.csv"
isochron run models/double_pendulum.scene --target posix --seconds 0.3 && [ "$(value hash)" = "$hash" ]
expect $? "--target posix has the same hash"
cmp -s "$out/project/build/posix/float/double_pendulum/trace.csv" "$out/host.csv"
result $? "and the same trace"
[ "$(value ticks)" = 300 ] && [ "$(value lost)" -lt 300 ] && [ "$(value late)" -le 300 ] && [ "$(value overruns)" -le $(($(value late) + 1)) ]
expect $? "the account: 300 ticks, of which $(value lost) lost, $(value late) late, $(value overruns) overruns"
! isochron run models/double_pendulum.scene --target posix --script script && grep -q 'script has no effect on posix' "$out/errors"
expect $? "--script is refused"

# Stopped four times for 0.2 s of its 2 s, from its first bytes on, when it cannot be further ahead than a page: at
# least 199 ticks are due each time, all but one reported with a later one. Those pass that are due while it writes its
# trace, if it is stopped there.
plant=$out/project/build/posix/float/double_pendulum/program
mkdir -p "$out/stalled"
cat >"$out/stall.py" <<'S'
import fcntl, os, shutil, signal, subprocess, sys, time
ends = os.pipe()
fcntl.fcntl(ends[1], 1031, 4096)  # F_SETPIPE_SZ
plant = subprocess.Popen([sys.argv[1], "2000000000"], stdout=ends[1])
os.close(ends[1])
stream = open(ends[0], "rb", buffering=0)
sys.stdout.buffer.write(stream.read(2048))
for _ in range(4):
    plant.send_signal(signal.SIGSTOP)
    time.sleep(0.2)
    plant.send_signal(signal.SIGCONT)
    time.sleep(0.05)
shutil.copyfileobj(stream, sys.stdout.buffer)
sys.exit(plant.wait())
S
build/trace -o "$out/stalled" -- python3 "$out/stall.py" "$plant" >"$out/output" 2>"$out/errors" && [ "$(value ticks)" = 2000 ] &&
    [ "$(value lost)" -ge 150 ] && [ "$(value late)" -ge "$(value lost)" ]
expect $? "stopped for 0.2 s, four times: $(value lost) ticks were lost, and caught up"
head -n 302 "$out/stalled/trace.csv" | cmp -s - "$out/host.csv"
expect $? "with the same trace"

# Whoever is allowed neither a real-time priority nor to lock memory is told of both, and runs.
cat >"$out/humble.sh" <<'S'
ulimit -l 0
ulimit -r 0 2>/dev/null
if [ "$(id -u)" -eq 0 ]; then
    exec setpriv --reuid 65534 --clear-groups --bounding-set=-all --inh-caps=-all "$@"
fi
exec "$@"
S
cp "$plant" "$out/plant" && chmod 755 "$out/plant"
sh "$out/humble.sh" "./$out/plant" 1000000 2>"$out/errors" >"$out/output"
status=$?
[ $status -eq 0 ] && grep -q '^posix: no SCHED_FIFO (.*): other programs can make ticks late$' "$out/errors" &&
    grep -q '^posix: no mlockall (.*): memory that is paged out can make ticks late$' "$out/errors"
expect $? "what it was not allowed stands on the standard error"
finish
