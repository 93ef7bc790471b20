#!/bin/sh
# What the loop takes beside the step, on the Cortex-M4F, by the trace of QEMU: `isochron ticks`; and that
# core/README.md says so.
. tests/host/test.sh
begin ticks

# ticks NAME SCENE: what isochron ticks prints, in $out/NAME; its instructions are then in variables NAME_PART.
ticks()
{
    tools/isochron ticks "$2" >"$out/$1" 2>"$out/errors"
    values "$1"
}

# board SCENE [OPTION...]: a run of a tenth of a second on the Cortex-M4F; its summary is in $out/run.
board()
{
    tools/isochron run --seconds 0.1 --target cortex-m4f "$@" >"$out/run" 2>"$out/errors"
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
    for part in loop checks interrupt port tick signals; do
        told $part "$out/$1"
        eval "$1_$part=\${told%% instructions*}"
    done
}

ticks one tests/promises/ticks/one.scene
result $? "one input, two outputs: $(tr '\n' ' ' <"$out/one")"
beside=$((one_loop + one_checks))
[ "$beside" -le 150 ]
result $? "the loop with its checks and statistics takes at most 150 instructions: $beside"
[ "$one_interrupt" -le 20 ] && [ "$one_interrupt" -gt 0 ]
result $? "the interrupt of the timer at most 20: $one_interrupt"
[ "$one_tick" = $((beside + one_port)) ] && [ "$one_tick" -le 220 ]
result $? "with the clock and the wait of the port at most 220: $one_tick"

# Its outputs are a part of `finish`.
ticks pendulum models/pendulum.scene
[ "$pendulum_tick" -le 240 ] && [ "$pendulum_tick" -gt "$one_tick" ]
result $? "a pendulum: with six outputs, and what they compute, at most 240: $pendulum_tick"

# Functions of time are equations of the scene.
ticks arm models/arm6.scene
[ "$arm_tick" -le 400 ] && [ "$arm_signals" -gt 100 ]
result $? "an arm of six joints: at most 400: $arm_tick, beside $arm_signals of its functions of time"
! grep -q signals "$out/one"
result $? "found: a scene without functions of time has none of them"

# A satellite: 11 inputs with limits, 13 states, 18 outputs.
ticks satellite tests/promises/ticks/satellite.scene
[ "$satellite_checks" -le 320 ] && [ "$satellite_checks" -gt 0 ]
result $? "the checks of 11 inputs with limits, 13 states and 18 outputs take at most 320: $satellite_checks"
stated core/README.md "With 11 inputs with limits, 13 states and 18 outputs it takes $satellite_checks."
result $? "as core/README.md says"
[ "$satellite_loop" = "$one_loop" ] && [ "$satellite_interrupt" = "$one_interrupt" ]
result $? "and all else what it takes with one: $(tr '\n' ' ' <"$out/satellite")"

# eight NAME TEXT: the table of the scene with the text eight times more, in which @ is a number.
eight()
{
    { cat tests/promises/ticks/one.scene && for i in 1 2 3 4 5 6 7 8; do printf '%s\n' "$2" | sed "s/@/$i/g"; done; } >"$out/$1.scene"
    ticks "$1" "$out/$1.scene"
}

# each MORE LESS PARTS: $each is what of the difference falls to a part, rounded.
each()
{
    each=$(((2 * ($1 - $2) + $3) / (2 * $3)))
}
eight more 'output more_@ = speed of pivot'
[ $((more_loop + more_checks)) -gt 150 ] && [ "$more_loop" -lt $((beside + 1)) ]
result $? "found: eight outputs more take longer to check"
each "$more_checks" "$one_checks" 8
of_output=$each
eight input 'input v_@
force f_@ { body bob at (0, -1, 0) m; axis (1, 0, 0); drive v_@ }'
each "$input_checks" "$one_checks" 8
of_input=$each
limited='in -1 N to 1 N
force f_@ { body bob at (0, -1, 0) m; axis (1, 0, 0); drive v_@ }'
eight limited "input v_@ = 0.5 N $limited"
each "$limited_checks" "$one_checks" 8
of_limited=$each
eight tunable 'tunable length_@ = 1 m
body arm_@ { mass 1 kg; com (0, length_@, 0) }
joint stuck_@ fixed { parent bob; child arm_@ }'
each "$tunable_checks" "$one_checks" 8
of_tunable=$each
eight states 'body arm_@ { mass 1 kg; com (0, 1, 0) m }
joint other_@ revolute { parent ground; child arm_@; axis z }'
each "$states_checks" "$one_checks" 16
by="by $each instructions for a state, $of_tunable for a tunable, $of_output for an output, $of_input for an input, with limits $of_limited"
stated core/README.md "$by."
result $? "the checks grow, as core/README.md says, $by"
# Nine inputs are then put right, that without limits among them.
eight corrected "input v_@ = 1.5 N * square(1 Hz) $limited"
each "$corrected_checks" "$limited_checks" 9
[ "$each" -ge 35 ] && [ "$each" -lt 45 ]
result $? "with limits some 40 more for each where one is put right: $each"

# least STATEMENT [MODEL]: the shortest tick of the model with it, in $least.
least()
{
    { cat "models/${2-pendulum}.scene" && echo "$1"; } >"$out/least.scene"
    board "$out/least.scene"
    told tick
    least=${told%% *}
}
least ''
without=$least
least 'overrun catch_up 3; grace 10 ticks'
[ "$least" = "$without" ]
result $? "what counts nothing in a tick that keeps its time takes nothing: $least, $without"
least 'publish next_tick'
later=$((least - without))
least histogram
stated core/README.md "With \`histogram\` a tick takes $((least - without)) instructions more on the Cortex-M4F; the others cost a tick that keeps its time nothing, but for $later of"
result $? "with histogram a tick takes $((least - without)) more, with publish next_tick $later, as core/README.md says"
least 'overrun degrade { hold; after 9 ticks }' dc_motor_bench
without=$least
least 'overrun degrade { drop bearing; hold; after 9 ticks }' dc_motor_bench
stated core/README.md "A tick of such a ladder takes $((least - without)) instructions more."
result $? "a ladder that drops an effect takes $((least - without)) more, as core/README.md says"
least 'output angle = position of pivot'
without=$least
least 'output angle = 0.01 rad * round(position of pivot / 0.01 rad)'
stated models/README.md "A rounding over the whole range of numbers takes $((least - without)):"
result $? "a rounding takes $((least - without)), as models/README.md says"
! stated core/README.md "takes $least instructions of no kind" >"$out/found" && [ -s "$out/found" ]
result $? "found: what core/README.md does not say"
# A run: the whole tick beside its step, and the trace beside the tick, which makes no tick late, lost or of another
# time, also where the period has room for the tick, and not for both. run STEP [TARGET]: the summary in $out/run.
run()
{
    tools/isochron run models/pendulum.scene --step "$1" --target "${2-cortex-m4f}" --seconds 0.1 >"$out/run" 2>"$out/errors"
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
    [ "$told" = 138 ] && [ "${tick%% *}" -gt 300 ] && [ "${mean%% *}" -lt 550 ] && [ "${tracing%%.*}" -gt 400 ]
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
        grep -v '^output' tests/promises/ticks/satellite.scene
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
    board "$out/$name.scene"
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

# of_run NAME LINE...: $least and $most are the instructions of the ticks of one.scene with these lines, and with what
# the port takes.
of_run()
{
    of_run_scene=$out/$1.scene
    shift
    { cat tests/promises/ticks/one.scene && printf '%s\n' "$@"; } >"$of_run_scene"
    board "$of_run_scene"
    told tick
    least=${told%% *} most=${told#* } most=${most%% *} && [ "${least:-0}" -gt 0 ]
}

# What is set at times. None of it is due in the run; as a control, all of it in one tick.
tunable='tunable k = 1
output shown = k'
of_run at_one "$tunable" 'at 5 s set k = 2' && one_change=$least most_of_one=$most &&
    of_run at_many "$tunable" 'repeat i from 1 to 2000 {' '    at 5 s + i * 1 ms set k = i' '}' &&
    [ $((least - one_change)) -le 40 ] && [ $((most - most_of_one)) -le 40 ]
result $? "2000 statements that set a tunable at times cost a tick at most 40 more than one: $least to $most, $one_change to $most_of_one"
of_run at_once "$tunable" 'repeat i from 1 to 20 {' '    at 50 ms set k = i' '}' && [ $((most - most_of_one)) -gt 40 ]
result $? "found: 20 that are due in one tick: $least to $most"

# Samples: what is not due costs less than half of what is.
formula='sqrt(1 + position of pivot^2) * sin(position of pivot) + exp(speed of pivot * 1 s / 10)'
of_run sampled_each "signal kept = sample($formula, every 1 ms)" 'output kept = kept' && each_tick=$least most_of_each=$most
of_run sampled_none 'output kept = 1' && no_sample=$least
of_run sampled_fifth "signal kept = sample($formula, every 5 ms)" 'output kept = kept' &&
    [ $((2 * (least - no_sample))) -lt $((each_tick - no_sample)) ]
result $? "a sample that is not due costs less than half of one in each tick: $least, $each_tick, without any $no_sample"
[ $((most - most_of_each)) -le 40 ]
result $? "and one that is due at most 40 more: $most, $most_of_each"

! build/cycles count tools/measure/cycles/cores/cortex-m4f.txt /dev/null iso_loop_tick_float </dev/null 2>"$out/errors" && grep -q 'no function iso_loop_tick_float' "$out/errors"
result $? "found: a program without a loop"
finish
