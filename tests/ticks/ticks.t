#!/bin/sh
# What the loop takes beside the step, on the Cortex-M4F, by the trace of QEMU: `make ticks`.
. tests/host/test.sh
begin ticks

# ticks NAME SCENE: the table of make ticks, for `value`.
ticks()
{
    make -s ticks SCENE="$2" >"$out/$1" 2>"$out/errors"
}

# value NAME KEY: instructions.
value()
{
    sed -n "s/^$2 \([0-9]*\) instructions.*/\1/p" "$out/$1"
}

ticks one tests/ticks/one.scene
result $? "one input, two outputs: $(tr '\n' ' ' <"$out/one")"
beside=$(($(value one loop) + $(value one checks)))
[ "$beside" -le 150 ]
result $? "the loop with its checks and statistics takes at most 150 instructions: $beside"
[ "$(value one interrupt)" -le 20 ] && [ "$(value one interrupt)" -gt 0 ]
result $? "the interrupt of the timer at most 20: $(value one interrupt)"
[ "$(value one tick)" = $((beside + $(value one port))) ] && [ "$(value one tick)" -le 230 ]
result $? "with the clock and the wait of the port at most 230: $(value one tick)"

{ cat tests/ticks/one.scene && for i in 1 2 3 4 5 6 7 8; do echo "output more_$i = speed of pivot"; done; } >"$out/more.scene"
ticks more "$out/more.scene"
[ $(($(value more loop) + $(value more checks))) -gt 150 ] && [ "$(value more loop)" -lt $((beside + 1)) ]
result $? "found: eight outputs more take longer to check"
! build/cycles iso_loop_tick_float /dev/null </dev/null 2>"$out/errors" && grep -q 'no function iso_loop_tick_float' "$out/errors"
result $? "found: a program without a loop"
finish
