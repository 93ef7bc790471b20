#!/bin/sh
# What the loop takes beside the step, on the Cortex-M4F, by the trace of QEMU: `make ticks`.
. tests/host/test.sh
begin ticks

# ticks NAME SCENE: the table of make ticks, whose instructions are then in variables NAME_PART.
ticks()
{
    make -s ticks SCENE="$2" >"$out/$1" 2>"$out/errors"
    values "$1"
}

# told KEY [FILE]: what that says in $told; of several lines the first.
told()
{
    told=
    while read -r told_key told_rest; do
        [ "$told_key" != "$1" ] || {
            told=$told_rest
            return
        }
    done <"${2-$out/run}"
}

# values NAME: its instructions, in variables NAME_PART.
values()
{
    for part in loop checks interrupt port tick; do
        told $part "$out/$1"
        eval "$1_$part=\${told%% instructions*}"
    done
}

ticks one tests/ticks/one.scene
result $? "one input, two outputs: $(tr '\n' ' ' <"$out/one")"
beside=$((one_loop + one_checks))
[ "$beside" -le 150 ]
result $? "the loop with its checks and statistics takes at most 150 instructions: $beside"
[ "$one_interrupt" -le 20 ] && [ "$one_interrupt" -gt 0 ]
result $? "the interrupt of the timer at most 20: $one_interrupt"
[ "$one_tick" = $((beside + one_port)) ] && [ "$one_tick" -le 240 ]
result $? "with the clock and the wait of the port at most 240: $one_tick"

# A satellite: 11 inputs with limits, 13 states, 18 outputs.
ticks satellite tests/ticks/satellite.scene
[ "$satellite_checks" -le 320 ] && [ "$satellite_checks" -gt 0 ]
result $? "the checks of 11 inputs with limits, 13 states and 18 outputs take at most 320: $satellite_checks"
[ "$satellite_loop" = "$one_loop" ] && [ "$satellite_interrupt" = "$one_interrupt" ]
result $? "and all else what it takes with one: $(tr '\n' ' ' <"$out/satellite")"

{ cat tests/ticks/one.scene && printf 'output more_%d = speed of pivot\n' 1 2 3 4 5 6 7 8; } >"$out/more.scene"
ticks more "$out/more.scene"
[ $((more_loop + more_checks)) -gt 150 ] && [ "$more_loop" -lt $((beside + 1)) ]
result $? "found: eight outputs more take longer to check"
# A run: the whole tick beside its step, and the trace beside the tick, which makes no tick late, lost or of another
# time, also where the period has room for the tick, and not for both. run STEP [TARGET]: the summary in $out/run.
run()
{
    make -s run SCENE=models/pendulum.scene STEP="$1" TARGET="${2-cortex-m4f}" SECONDS=0.1 >"$out/run" 2>"$out/errors"
}

# amiss: $amiss is how many ticks were late, lost and too long.
amiss()
{
    amiss=
    for part in late lost overruns; do
        told $part
        amiss="$amiss $told"
    done
}
for step in 1ms 50us; do
    run $step && amiss && [ "$amiss" = ' 0 0 0' ]
    result $? "a step of $step: no tick is late"
    told tick
    tick=$told
    mean=${tick#* }
    told tracing
    tracing=$told
    told instructions_per_step
    [ "$told" = 135 ] && [ "${tick%% *}" -gt 400 ] && [ "${mean%% *}" -lt 650 ] && [ "${tracing%%.*}" -gt 400 ]
    result $? "of $told instructions, with a tick of $tick; its trace takes $tracing"
done
run 10us && amiss
late=${amiss# }
[ "${late%% *}" -gt 0 ] && [ "${late##* }" -gt 0 ]
result $? "found: a step of 10us is shorter than a tick: ${late%% *} late, ${late##* } overruns"
run 1ms host && told hash && [ -n "$told" ] && ! grep -qE '^(execution|margin|tick|tracing|instructions_per_step) ' "$out/run"
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
    told hash
    unit=$told
    told tick
    unit="$unit $told"
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
