#!/bin/sh
# isochron link and isochron hil: a plant and a controller in processes of their own. The plant has the hash that it has
# without a wire, the table has the inputs, and whatever goes wrong is told and leaves no process.
. tests/host/test.sh
. tests/host/project.sh
begin link/make
project
unoptimised clang
optimised -O0

# What hil does, for 1.2 s: the fault is not in them.
isochron hil --seconds 1.2 --target host && read_value stood: && [ -n "$value" ]
expect $? "isochron hil --target host: stood: $value"
read_value hash && hash=$value
awk '{ line[NR] = $0 } END { exit line[NR - 3] !~ \
    /^exchanges 1200, median [0-9.e-]+ ms, of which the controller [0-9.e-]+ ms, missed 0$/ }' "$out/output"
expect $? "its last line is: exchanges $(value exchanges)"
read_value exchange_max && longest=$value
# The longest exchange has the controller's longest part in it, but for that of the last tick, which nothing follows.
awk '$1 == "exchange_max" { whole = $2 } $1 == "controller_max" { part = $2 } END { exit !(part > 0 && whole >= part) }' "$out/output"
result $? "the longest exchange, $longest, has the controller's longest part in it, $(value controller_max)"
cp "$out/project/build/hil/host/float/trace.csv" "$out/project/build/hil/host/float/units.csv" "$out"
csv=$out/trace.csv
awk -v names=t,counts,place,pole,cart,current,stop,volts -v units=s,1,m,rad,m,A,N,V '
    FNR == 1 && NR == 1 && $0 == names { named = 1 }
    FNR == NR { rows++ }
    { last = $0 }
    END { exit !(named && rows == 1202 && last == units) }' "$csv" "$out/units.csv"
expect $? "the table has the input, volts, behind the outputs"
for picture in svg png; do
    [ -s "$out/project/build/hil/host/float/trace.$picture" ]
    result $? "trace.$picture is drawn"
done

# The inputs of the table, given to the same plant without a wire: the same hash. Row k has the inputs of the step from
# k to k + 1.
cat >"$out/replay.c" <<'C'
#include "cart_pole.h"
#include "core/runtime/hash.h"
#include "core/runtime/tick.h"
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
int main(void)
{
    static cart_pole_memory memory;
    const iso_plant plant = cart_pole_plant(&memory);
    uint64_t hash = ISO_HASH_START;
    char line[1024];
    iso_plant_start(&plant);
    if (fgets(line, sizeof line, stdin) == NULL) {
        return 1;
    }
    for (uint32_t tick = 0; tick < 1200 && fgets(line, sizeof line, stdin) != NULL; tick++) {
        plant.u[CART_POLE_U_VOLTS] = strtof(strrchr(line, ',') + 1, NULL);
        if (iso_plant_tick(&plant, tick) < CART_POLE_STATES) {
            return 1;
        }
        hash = iso_hash_reals(hash, plant.x, CART_POLE_STATES);
    }
    printf("%016" PRIx64 "\n", hash);
    return 0;
}
C
real float
EXTRA="-I$out/alone -Wno-conversion"
build/isoc models/hil/cart_pole.scene -o "$out/alone" --name cart_pole >/dev/null &&
    program replay "$out/replay.c" "$out/alone/cart_pole.c" && [ "$("$out/replay" <"$csv")" = "$hash" ]
result $? "the inputs of the table, given to the plant without a wire, have the same hash, $hash"
awk -F, -v OFS=, 'NR == 600 { $NF += 0.001 } { print }' "$csv" >"$out/changed.csv"
[ "$("$out/replay" <"$out/changed.csv")" != "$hash" ]
result $? "found: an input that differs"

# On the board in QEMU, over its serial line.
isochron hil --seconds 1.2 && printed hash "$hash" && read_value instructions_per_step && [ "$value" -gt 0 ] && read_value exchanges &&
    case $value in '1200, '*' missed 0') ;; *) false ;; esac
expect $? "isochron hil on the Cortex-M4F has the hash of the host: stood: $(value stood:)"

# The same by isochron link, and in real time.
cp "$out/project/build/hil/host/float/controller" "$out/controller"
linked=$out/project/build/hil/host/float/linked

# link OPTION...: isochron link of the same plant with this controller.
link()
{
    isochron link models/hil/cart_pole.scene --seconds 1.2 --controller "$PWD/$out/controller" "$@"
}
link && printed hash "$hash"
expect $? "isochron link has the same hash"
link --target posix --keep posix && printed hash "$hash" && [ -s "$out/project/build/runs/posix/trace.csv" ]
expect $? "--target posix has the same hash; --keep keeps the run"
# How many inputs come in time is the system's: each tick had one that was new, or missed it.
link --target posix --mode free && printed ticks 1200 && read_value link_inputs && inputs=$value && read_value exchanges &&
    [ $((inputs + ${value##*missed })) -ge 1200 ]
expect $? "--mode free: $inputs inputs for 1200 ticks; $value"
link --step 2ms
[ $? -ne 0 ] && says 'link: the controller ended with status 1'
expect $? "a controller of another plant is refused"

# Without an end: the controller ends the run, by `stop`, or by closing its link; in C and in Python.
cat >"$out/endless.c" <<'C'
#include "cart_pole_link.h"
int main(int argc, char **argv)
{
    static cart_pole_link plant;
    bool good = cart_pole_open(&plant, NULL) && cart_pole_start(&plant, argc > 2 ? ISO_CLIENT_FREE : ISO_CLIENT_LOCKSTEP, 0);
    while (good && plant.client.tick < (uint64_t)atoi(argv[1])) {
        good = cart_pole_exchange(&plant);
    }
    return !good || (argc == 2 && !cart_pole_stop(&plant));
}
C
cat >"$out/endless.py" <<'P'
import sys
import cart_pole_link as plant

with plant.Link() as link:
    link.start("free" if len(sys.argv) > 2 else "lockstep", 0)
    while link.tick < int(sys.argv[1]):
        link.exchange()
    if len(sys.argv) == 2:
        link.stop()
P
EXTRA="-D_POSIX_C_SOURCE=200809L -I$linked" program endless "$out/endless.c"
result $? "a controller that goes on"
for controller in "$PWD/$out/endless" "python3 $PWD/$out/endless.py"; do
    isochron link models/hil/cart_pole.scene --seconds 0 --controller "$controller 10100" &&
        printed ticks 10100 && printed link_inputs 10100 && read_value trace && [ "$(wc -l <"$out/project/$value")" -eq 10102 ]
    expect $? "--seconds 0: more than the 10 s of today, until ${controller##*/} stops"
    isochron link models/hil/cart_pole.scene --seconds 0 --target posix --controller "$controller 300 free" && read_value ticks &&
        [ "$value" -ge 300 ]
    expect $? "--seconds 0, free: until ${controller##*/} closes its link, at tick $value"
done
isochron link models/hil/cart_pole.scene --seconds 10 --controller "$PWD/$out/endless 10100" && status=0 || status=1
[ $status -eq 1 ] && printed ticks 10000
expect $? "found: a run with an end"

# Without --controller it waits: here for one that comes after two that go again.
cat >"$out/wait.sh" <<'S'
(cd "$1" && exec tools/isochron link models/hil/cart_pole.scene --seconds 1.2) >"$2/output" 2>"$2/errors" </dev/null &
until ISOCHRON_LINK=$(sed -n 's/^link: waiting for a controller with ISOCHRON_LINK=//p' "$2/errors") && [ -n "$ISOCHRON_LINK" ]; do
    kill -0 $! || exit 1
    sleep 0.05
done
export ISOCHRON_LINK
"$2/controller" </dev/null
wait $!
S
sh "$out/wait.sh" "$out/project" "$out" && printed hash "$hash"
expect $? "without --controller: it prints the address, and one that comes there has the same hash"

# What happens to a run happens at its tick 100, since the controller does it.
# at_100 NAME STATEMENT: a controller that does this then.
at_100()
{
    sed -e '1i #include <signal.h>\n#include <unistd.h>' \
        -e "s/^    while (good) {/&\n        if (plant.client.tick == 100) {\n            $2;\n        }/" models/hil/controller.c >"$out/$1.c" &&
        EXTRA="-D_POSIX_C_SOURCE=200809L -I$linked" program "$1" "$out/$1.c"
    result $? "a controller for $1"
}
at_100 killed 'raise(SIGKILL)'
at_100 halted 'raise(SIGSTOP)'
at_100 interrupting 'kill(getppid(), SIGINT)'
at_100 terminating 'kill(getppid(), SIGTERM)'
# told TEXT STATUS PATIENCE COMMAND: the run with this controller, which may send nothing for so many seconds, fails
# with the status, and says TEXT.
told()
{
    "$out/project/build/link" -o "$out" --header "$linked/cart_pole_link.h" --patience "$3" --controller "$4" -- \
        "$out/project/build/trace" -o "$out" -- "$linked/program" 100000000000 >"$out/output" 2>"$out/errors" </dev/null
    status=$?
    [ $status -eq "$2" ] && { [ -z "$1" ] || says "$1"; }
    expect $? "told, with '$1', status $status: $4"
}
told 'the controller ended with status 1 and has exchanged nothing' 1 600 false
told 'the controller ended and has exchanged nothing' 1 600 true
told 'the controller ended with status 127' 1 600 "$out/absent"
told 'the controller has not connected for 1 s' 1 1 'sleep 100'
told 'nothing comes any more: the controller has ended, the plant waits at tick 100' 1 600 "exec $out/killed"
told 'nothing comes any more: plant and controller both wait at tick 100' 1 3 "exec $out/halted"
told '' 130 600 "exec $out/interrupting"
told '' 143 600 "exec $out/terminating"
"$out/project/build/link" -o "$out" --header "$linked/cart_pole_link.h" --controller "$out/controller" -- \
    sh -c 'exit 7' >"$out/output" 2>"$out/errors" </dev/null
[ $? -eq 1 ] && grep -qx 'link: the plant ended with status 7' "$out/errors"
expect $? "a plant that ends is told"
! grep -lsaE "$out/project/build/.*/[l]inked/program|$out/([c]ontroller|[k]illed|[h]alted|[i]nterrupting|[t]erminating)" /proc/[0-9]*/cmdline >"$out/alive"
expect $? "none of them has left a process"
isochron link models/hil/cart_pole.scene --mode free --target host && status=0 || status=1
[ $status -eq 1 ] && says '--mode free needs time that is real'
expect $? "--mode free is refused on the host"
isochron link models/oscillator.c --controller true && status=0 || status=1
[ $status -eq 1 ] && says 'a plant in C has no link'
expect $? "a plant in C is refused"

# A pole that falls is told from one that stands.
awk -F, -v OFS=, 'NR == 900 { $4 = 0.036 } { print }' "$csv" >"$out/fallen.csv"
! python3 -B -c 'import sys; sys.path.insert(0, "tools"); from lab import hil; sys.exit(hil.stood(sys.argv[1]))' "$out/fallen.csv" >"$out/output" && grep -q '^fell: pole within 2.06 deg' "$out/output"
result $? "found: a pole that is 2.06 deg off at the end"
awk -F, -v OFS=, 'NR == 100 { $5 = -0.4 } { print }' "$csv" >"$out/fallen.csv"
! awk -F, -f models/hil/stood.awk "$out/fallen.csv" >"$out/output"
result $? "found: a cart at its stop"
finish
