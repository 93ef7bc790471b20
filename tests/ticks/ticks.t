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
[ "$(value one tick)" = $((beside + $(value one port))) ] && [ "$(value one tick)" -le 240 ]
result $? "with the clock and the wait of the port at most 240: $(value one tick)"

# A satellite: 11 inputs with limits, 13 states, 18 outputs.
ticks satellite tests/ticks/satellite.scene
[ "$(value satellite checks)" -le 320 ] && [ "$(value satellite checks)" -gt 0 ]
result $? "the checks of 11 inputs with limits, 13 states and 18 outputs take at most 320: $(value satellite checks)"
[ "$(value satellite loop)" = "$(value one loop)" ] && [ "$(value satellite interrupt)" = "$(value one interrupt)" ]
result $? "and all else what it takes with one: $(tr '\n' ' ' <"$out/satellite")"

{ cat tests/ticks/one.scene && for i in 1 2 3 4 5 6 7 8; do echo "output more_$i = speed of pivot"; done; } >"$out/more.scene"
ticks more "$out/more.scene"
[ $(($(value more loop) + $(value more checks))) -gt 150 ] && [ "$(value more loop)" -lt $((beside + 1)) ]
result $? "found: eight outputs more take longer to check"
# A run: the whole tick beside its step, and the trace beside the tick, which makes no tick late, lost or of another time, also where
# the period has room for the tick, and not for both.
# run STEP [TARGET]: the summary in $out/run; `told KEY` is what it says.
run()
{
    make -s run SCENE=models/pendulum.scene STEP="$1" TARGET="${2-cortex-m4f}" SECONDS=0.1 >"$out/run" 2>"$out/errors"
}
told()
{
    sed -n "s/^$1 //p" "$out/run" | head -n 1
}
for step in 1ms 50us; do
    run $step && [ "$(told late) $(told lost) $(told overruns)" = '0 0 0' ]
    result $? "a step of $step: no tick is late"
    tick=$(told tick)
    [ "$(told instructions_per_step)" = 137 ] && [ "${tick%% *}" -gt 400 ] && [ "$(echo "$tick" | cut -d ' ' -f 2)" -lt 650 ] &&
        [ "$(told tracing | cut -d . -f 1)" -gt 400 ]
    result $? "of $(told instructions_per_step) instructions, with a tick of $tick; its trace takes $(told tracing)"
done
run 10us && [ "$(told late)" -gt 0 ] && [ "$(told overruns)" -gt 0 ]
result $? "found: a step of 10us is shorter than a tick: $(told late) late, $(told overruns) overruns"
run 1ms host && [ -n "$(told hash)" ] && ! grep -qE '^(execution|margin|tick|tracing|instructions_per_step) ' "$out/run"
result $? "what is not measured on the host is not told"

# What nothing reads costs nothing: an inertial unit of which the spin alone is shown, and a gyro that has nothing else.
# unit NAME KIND OUTPUT...: the satellite with it; its bits and its tick in $unit.
unit()
{
    name=$1
    kind=$2
    shift 2
    {
        grep -v '^output' tests/ticks/satellite.scene
        printf 'output %s = unit.%s\n' spin_x spin_x spin_y spin_y spin_z spin_z "$@"
        printf 'input n%d = noise(%d)\n' 1 1 2 2 3 3
        echo "effect unit $kind { on bus; spin_bias 1 mrad/s; spin_density 0.01 deg/s/sqrt(Hz); noise_4 n1; noise_5 n2; noise_6 n3 }"
        [ "$kind" = imu ] || echo 'effect gyro {
            body on; value spin_bias rad/s; value spin_density rad/s/sqrt(Hz); signal noise_4; signal noise_5; signal noise_6
            let turned = spin of on + spin_bias * (1, 1, 1) + spin_density * sqrt(0.5 / step) * (noise_4, noise_5, noise_6)
            memory turn rad/s = turned; next turn = turned
            output spin_x = dot(turn, (1, 0, 0)); output spin_y = dot(turn, (0, 1, 0)); output spin_z = dot(turn, (0, 0, 1))
        }'
    } >"$out/$name.scene"
    make -s run SCENE="$out/$name.scene" TARGET=cortex-m4f SECONDS=0.1 >"$out/run" 2>"$out/errors"
    unit="$(told hash) $(told tick)"
}
unit gyro gyro
gyro=$unit
unit spin imu
[ "$unit" = "$gyro" ] && [ "${gyro%% *}" != "" ]
result $? "the unused half of an inertial unit costs nothing: $unit, a gyro alone $gyro"
unit force imu force_x force_x
[ "${unit#* }" != "${gyro#* }" ]
result $? "found: one that is used: $unit"

! build/cycles count tools/measure/cycles/cores/cortex-m4f.txt /dev/null iso_loop_tick_float </dev/null 2>"$out/errors" && grep -q 'no function iso_loop_tick_float' "$out/errors"
result $? "found: a program without a loop"
finish
