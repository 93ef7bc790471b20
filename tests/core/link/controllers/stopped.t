#!/bin/sh
# `overrun stop` over the link: the tick that overran is in the hash, in the outputs that the controller gets, and in
# the table, as it is in a run without a wire; and the port is put into its safe state once in both.
. tests/host/test.sh
begin link_stopped
real float
optimised -O0
common="core/numbers/*.c core/runtime/*.c core/application/stream.c"
{ cat tests/core/runtime/overruns/pendulum.scene && echo 'overrun stop; grace 20 ticks'; } >"$out/plant.scene"
(echo slow 10 2ms && echo slow 77 1500us) >"$out/script"

# The simulated port says on the standard error that it was made safe.
awk 'function put() { print; if (/^void iso_port_safe/) { getline < outputs; print; print "    (void)fputs(\"safe\\n\", stderr);" } }
    BEGIN { outputs = "port/none/outputs.h"; print "#include <stdio.h>" }
    /^#include "port\/none\/outputs.h"/ { while ((getline < outputs) > 0) put(); next }
    { print }' port/host/sim.c >"$out/sim.c"

build/isoc "$out/plant.scene" -o "$out/plant" --link >"$out/summary" &&
    EXTRA=-D_POSIX_C_SOURCE=200809L program join tests/core/link/controllers/join.c &&
    program alone "$out/plant/plant.c" $common core/application/main.c "$out/sim.c" port/host/script.c port/unix/console.c &&
    program linked "$out"/plant/*.c $common core/link/*.c "$out/sim.c" port/host/script.c port/unix/*.c
result $? "the plant is built, without a link and with one"

# run NAME COMMAND...: its table, its summary and what it says in $out/NAME; it fails, as a run that an overrun stops
# does.
run()
{
    name=$1
    shift
    mkdir -p "$out/$name"
    ! PYTHONPATH=$out/plant build/trace -o "$out/$name" -- "$@" >"$out/$name/summary" 2>"$out/$name/errors" &&
        grep -qx 'trace: stopped by the overrun of tick 77' "$out/$name/errors" &&
        [ "$(grep -cx safe "$out/$name/errors")" -eq 1 ]
}
run by_itself "$out/alone" 1000000000 "$out/script"
result $? "without a wire tick 77 is the last, and the port is made safe"
# The controller's line goes beside the stream of the run.
cat >"$out/controller" <<S
#!/bin/sh
exec python3 tests/core/link/controllers/stopped.py >"$out/said"
S
chmod +x "$out/controller"
run on_the_wire "$out/join" "$out/linked" 1000000000 "$out/script" -- "$out/controller"
result $? "and over the link"
hash=$(sed -n 's/^hash //p' "$out/by_itself/summary")
[ -n "$hash" ] && [ "$(sed -n 's/^hash //p' "$out/on_the_wire/summary")" = "$hash" ]
result $? "both have the hash $hash"
cmp "$out/by_itself/trace.csv" "$out/on_the_wire/trace.csv" && [ "$(wc -l <"$out/on_the_wire/trace.csv")" -eq 79 ]
result $? "and the same table"
grep -qx "tick 77 ticks 77 hash $hash" "$out/said"
result $? "the controller has the outputs of the last tick, and the hash: $(cat "$out/said")"

# Control: another tick that overruns has another hash.
echo slow 78 1500us >"$out/script"
! run other "$out/join" "$out/linked" 1000000000 "$out/script" -- "$out/controller" &&
    [ "$(sed -n 's/^hash //p' "$out/other/summary")" != "$hash" ]
result $? "found: one tick more"
finish
