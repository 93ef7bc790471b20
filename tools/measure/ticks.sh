#!/bin/sh
# The cost of a tick of the loop beside the step and the equations of the plant, on the Cortex-M4F: instructions, and
# the cycles that they mean (tools/measure/cycles.c), of the last of ten ticks. `loop` is core/runtime/loop.c, `checks`
# the checks of inputs, states and outputs, `port` the port's clock and the wait for the tick, `tick` their sum;
# `interrupt` is the timer's. Where outputs or samples are not of each tick, or tunables are set at times, `finish` is
# all behind the step, the memories and the outputs with it: in the least and in the longest of the ten ticks.
#
# Called by `make ticks` for the program $PROGRAM, which $EXEC runs.
set -u
dir=${PROGRAM%/*}
core=tools/measure/cycles/cores/cortex-m4f.txt
plant="step derivative held_derivative prepare complete prepared_derivative output prepared_output drive advance settle"
port="iso_port_wait iso_port_clock iso_port_read_float iso_port_publish_float"

arm-none-eabi-objdump -d "$PROGRAM" >"$dir/listing" || exit 1
plant="$plant $(sed -n 's/.*<\(output_every_[0-9]*\)>:$/\1/p' "$dir/listing")"
$EXEC -singlestep -d nochain,exec 2>"$dir/exec" >/dev/null || exit 1

# count NAME FUNCTION [LEFT_OUT...]: a line with the name, then those of its instructions and its cycles.
count()
{
    echo "of $1"
    shift
    build/cycles count $core "$dir/listing" "$@" <"$dir/exec"
}

# shellcheck disable=SC2086
{
    count tick iso_loop_tick_float $plant tick_interrupt
    count no_port iso_loop_tick_float $plant tick_interrupt $port
    count loop iso_loop_tick_float $plant tick_interrupt $port amiss admit finish finish_on_rung
    count interrupt tick_interrupt
} | awk '
    $1 == "of" { of = $2; wanted += 2 }
    $1 == "instructions" { instructions[of] = $2; wanted-- }
    $1 == "cycles" { cycles[of] = $2; wanted-- }
    function show(name, i, c) { printf "%s %d instructions %d cycles\n", name, i, c }
    function less(name, a, b) { show(name, instructions[a] - instructions[b], cycles[a] - cycles[b]) }
    END {
        if (wanted) exit 1
        show("loop", instructions["loop"], cycles["loop"])
        less("checks", "no_port", "loop")
        less("port", "tick", "no_port")
        show("tick", instructions["tick"], cycles["tick"])
        show("interrupt", instructions["interrupt"], cycles["interrupt"])
    }' || exit 1
finish=$(sed -n 's/.*<\(finish\(_on_rung\)*\)>:$/\1/p' "$dir/listing" | sort | tail -n 1)
[ -z "$finish" ] || build/cycles count --range $core "$dir/listing" "$finish" <"$dir/exec" |
    awk '{ number[NR] = $2 }
        END { if (number[1] != number[2]) printf "finish %d to %d instructions\n", number[1], number[2] }'
