#!/bin/sh
# Effects: what they compute, against a closed form and against the same in other words; and that what is not used costs
# nothing.
. tests/host/test.sh
begin effects
one_isoc
optimised -O0

for number in float double; do
    real $number
    isoc "$out/$number.summary" '' tests/isoc/effects/motor.scene -o "$out/$number" --real $number &&
        EXTRA="-DPLANT=\"$out/$number/plant.c\"" program motor.$number tests/isoc/effects/motor.c tests/host/report.c
    joined $number "$out/motor.$number"
done

# watched NUMBER PROGRAM: memcheck finds nothing in it; by turns, or with the argument `all` in every one.
turn=$(turn_of 6 "${1-}" core models/effects tests/isoc/effects)
echo "# turn $turn of 6 of memcheck, of 2 of methods, of 3 of pairs of scenes"
watched()
{
    [ "$turn" != all ] && [ "$turn" -ne "$1" ] && return
    valgrind --quiet --error-exitcode=99 "$out/$2" >"$out/tap" 2>&1
    result $? "memcheck finds nothing in $2"
}
watched 0 motor.float
watched 1 motor.double

real double
isoc "$out/pair.summary" '' tests/isoc/effects/pair.scene -o "$out/pair" --real double &&
    EXTRA="-DPLANT=\"$out/pair/plant.c\"" program pair.run tests/isoc/effects/pair.c tests/host/report.c
joined pair "$out/pair.run"
watched 2 pair.run

isoc "$out/measured.summary" '' tests/isoc/effects/measured.scene -o "$out/measured" --real double &&
    EXTRA="-DPLANT=\"$out/measured/plant.c\"" program measured.run tests/isoc/effects/measured.c tests/host/report.c
joined accelerometer "$out/measured.run"
watched 3 measured.run

# cell MODEL JOINT CONNECTION BODY [EDIT]: load cells in a joint and in another connection of a model, to which a plate
# is welded; EDIT is of sed.
cell()
{
    plate='body plate { mass 0.4 kg; com (10, 0, 30) mm; inertia (1e-3, 2e-3, 1.5e-3) kg*m^2 }'
    mount="joint mount fixed { parent $4 at (0, 0, 56) mm rotate 30 deg about x; child plate }"
    printf '%s\n' "$plate" "$mount" >"$out/plate.scene"
    sed "s/JOINT/$2/; s/CONNECTION/$3/; ${5-}" "models/$1.scene" "$out/plate.scene" tests/isoc/effects/cell.scene >"$out/$1.scene"
    isoc "$out/$1.summary" '' "$out/$1.scene" -o "$out/$1" --real "$real" &&
        EXTRA="-DPLANT=\"$out/$1/plant.c\"" program cell.run tests/isoc/effects/cell.c tests/host/report.c
}
for number in float double; do
    real $number
    cell arm6 elbow mount flange
    joined "load cell, arm6, $number" "$out/cell.run"
    cell four_bar motor_shaft rocker_pin rocker
    joined "load cell, four_bar, $number" "$out/cell.run"
done
cell arm6 elbow mount flange 's/next felt = /&1.000001 * /; s/next turned = /&-/; s/next passed = /&1.000001 * /'
"$out/cell.run" >"$out/tap"
test "$(grep -c '^not ok [123]' "$out/tap")" = 3
result $? 'found: a load cell a millionth off, and a moment on the other side'

# creep_of NAME: $creep is what the summary of this plant says of it, in m/s.
creep_of()
{
    creep=
    while read -r word of creep_value unit; do
        [ "$word $of $unit" != 'stable drag.creep m/s' ] || creep=$creep_value
    done <"$out/$1.summary"
    [ -n "$creep" ]
}

# friction METHOD: a block with friction as steep as the method allows.
friction()
{
    isoc "$out/friction.summary" "$out/told" tests/isoc/effects/friction.scene -o "$out/friction" --method "$1" --real "$real" &&
        creep_of friction &&
        EXTRA="-DPLANT=\"$out/friction/plant.c\" -DCREEP=$creep" program friction.run tests/isoc/effects/friction.c \
            tests/host/report.c
    joined "$1, $real" "$out/friction.run"
}
real float
for method in euler heun rk4 semi_implicit ab4 abm4 bdf4 rosenbrock; do
    ! next_turn 2 || friction $method
done
real double
friction rk4
friction bdf4
watched 4 friction.run

# slip SCENE: a block that sticks and slips.
slip()
{
    isoc "$out/slip.summary" '' "$1" -o "$out/slip" --real "$real" &&
        creep_of slip &&
        EXTRA="-DPLANT=\"$out/slip/plant.c\" -DCREEP=$creep" program slip.run tests/isoc/effects/slip.c tests/host/report.c
}
for number in float double; do
    real $number
    slip tests/isoc/effects/slip.scene
    joined "slip, $number" "$out/slip.run"
done
sed 's/static 4 N/static 4.01 N/' tests/isoc/effects/slip.scene >"$out/slip.scene"
slip "$out/slip.scene"
! "$out/slip.run" >"$out/tap" && grep -q '^not ok 1' "$out/tap"
result $? 'found: a hundredth newton more at rest'

# stop METHOD TOLERANCE [SCENE]: a block between stops, as stiff as the method allows. The tolerance is what an impact
# falls short of at most (models/README.md), over a rest of 0.8.
stop()
{
    isoc "$out/stop.summary" '' "${3-tests/isoc/effects/stop.scene}" -o "$out/stop" --method "$1" --real "$real" &&
        EXTRA="-DPLANT=\"$out/stop/plant.c\" -DTOLERANCE=$2" program stop.run tests/isoc/effects/stop.c tests/host/report.c
    joined "${3:+two bumpers, }$1, $real" "$out/stop.run"
}
real float
for method in euler:0.02 heun:0.0145 rk4:0.0065 semi_implicit:0.0145 ab4:0.0145 bdf4:0.0145; do
    ! next_turn 2 || stop ${method%:*} ${method#*:}
done
real double
stop rk4 0.0065
sed 's/stop { along rail; lower -0.1 m; upper 0.15 m;/bumper { along rail; place 0.15 m;/p; s/ends bumper/start bumper/
    s/place 0.15 m/side -1; place -0.1 m/' tests/isoc/effects/stop.scene >"$out/bumpers.scene"
stop rk4 0.0065 "$out/bumpers.scene"
watched 5 stop.run

# plant NAME LINES...: compiles the scene of these lines.
plant()
{
    plant_name=$1
    shift
    printf '%s\n' "$@" >"$out/$plant_name.scene"
    isoc "$out/$plant_name.summary" '' "$out/$plant_name.scene" -o "$out" --name "$plant_name" --real double
}

# same NAME: whether the plants `old` and `other` end every tick with the same bits.
same()
{
    program same tests/isoc/effects/same.c "$out/old.c" "$out/other.c" && "$out/same"
    result $? "$1"
}
EXTRA="-I$out"

# The library: an effect that comes with isoc is what the same definition in the scene is; its errors have its path.
sed '/^effect dc_motor {/,/^}/d' tests/isoc/effects/motor.scene >"$out/library.scene"
cat models/effects/dc_motor.scene "$out/library.scene" >"$out/own_text.scene"
for of in library own_text; do
    isoc "$out/summary" '' "$out/$of.scene" -o "$out" --name $of && sed "s/$of/x/gI; s|/\\*.*\\*/||" "$out/$of.c" >"$out/$of.text"
done
cmp "$out/library.text" "$out/own_text.text"
result $? 'an effect of the library is its definition in the scene'
sed 's/2 Ohm/0 Ohm - 2 Ohm/' "$out/library.scene" >"$out/wrong.scene"
! isoc /dev/null "$out/errors" "$out/wrong.scene" -o "$out" &&
    grep -q 'requires in line [0-9]* of models/effects/dc_motor.scene: require resistance >= 0' "$out/errors"
result $? 'what an effect of the library requires is told with its line'

pendulum='gravity (0, -9.81, 0) m/s^2
step 1 ms
body bob { mass 1 kg; com (0, -1, 0) m }
output angle = position of pivot'
joint='joint pivot revolute { parent ground; child bob; axis z; start 1 rad'
viscous='effect viscous { joint along; value factor N*m*s/rad; effort on along = -factor * speed of along }'
input='input push = 0.3 N*m * sin(2 Hz)'

# own WORDS DEFINITION USE: a scene with words in its joint, and with an effect instead.
own()
{
    for method in rk4 semi_implicit bdf4; do
        next_turn 3 || continue
        plant old "$pendulum" "method $method" "$input" "$joint; $1 }"
        plant other "$pendulum" "method $method" "$input" "$joint }" "$2" "$3"
        same "$method: '$1' of a joint is the same as an effect"
    done
}
own 'drive push' 'effect driven { joint along; signal by like effort of along; effort on along = by }' \
    'effect motor driven { along pivot; by push }'
input=
own 'spring 5 N*m/rad rest 10 deg' 'effect elastic {
    joint along; value stiffness N*m/rad; value rest like position of along
    effort on along = -stiffness * (position of along - rest)
}' 'effect coil elastic { along pivot; stiffness 5 N*m/rad; rest 10 deg }'
own 'damping 0.1 N*m*s/rad' "$viscous" 'effect bearing viscous { along pivot; factor 0.1 N*m*s/rad }'

# A function of time in a formula is that of an input that the effect reads, with the same new starts of a method with a
# history.
driven='effect driven { joint along; signal by; effort on along = 0.3 N*m * by }'
cp tests/isoc/plant/inputs/road.csv "$out"
for of in 'time / 1 s' 'step(0.3 s)' 'square(7 Hz)' 'prbs(7, 10 ms)' 'chirp(1 Hz, 9 Hz, 1 s)' 'file "road.csv"'; do
    next_turn 3 || [ "$of" = 'file "road.csv"' ] || continue
    head="$pendulum
method ab4
$joint }"
    plant old "$head" "input push = $of" "$driven" 'effect motor driven { along pivot; by push }'
    plant other "$head" "effect driven { joint along; effort on along = 0.3 N*m * ($of) }" 'effect motor driven { along pivot }'
    same "$of in a definition"
    plant other "$head" "$driven" "signal push = $of" 'effect motor driven { along pivot; by push }'
    same "$of in a signal"
done 2>"$out/told"
plant other "$head" "$driven" 'signal push = 1.01 * file "road.csv"' 'effect motor driven { along pivot; by push }' 2>"$out/told"
program same tests/isoc/effects/same.c "$out/old.c" "$out/other.c" && ! "$out/same"
result $? 'found: another function of time'
plant old "$pendulum
method bdf4
$joint; damping 0.1 N*m*s/rad }" 2>"$out/told"

plant other "$pendulum
method bdf4
$joint }
$viscous
effect bearing viscous { along pivot; factor 0.11 N*m*s/rad }"
! "$out/same" || program same tests/isoc/effects/same.c "$out/old.c" "$out/other.c" && ! "$out/same"
result $? 'found: a tenth more damping'

cp "$out/old.c" "$out/kept.c"
plant old "$pendulum
method bdf4
$joint; damping 0.1 N*m*s/rad }
$viscous"
cmp "$out/old.c" "$out/kept.c"
result $? 'an effect that is defined and not used leaves the plant as it is'

# Faults and tunables that are set at ticks, with a method that restarts then; and values from the command line.
motor='step 0.25 ms
input volts V = 6 V
tunable load = 10 mN*m*s/rad
body rotor { mass 1 kg; inertia (1, 1, 1) g*m^2 }
joint shaft revolute { parent ground; child rotor; axis z; damping load }
effect drive dc_motor { shaft shaft; supply volts; resistance 2 Ohm; inductance 20 mH; constant 50 mN*m/A }
output current = drive.current'
for method in rk4 ab4; do
    plant old "$motor" "method $method"
    plant other "$motor" "method $method" 'at 25 ms set drive.open = 1; at 50 ms set drive.open = 0' \
        'at 75 ms set load = 20 mN*m*s/rad'
    program switched tests/isoc/effects/switched.c "$out/old.c" "$out/other.c" && "$out/switched"
    result $? "$method: what the scene sets at a tick is what the program sets before it"
done
plant old "${motor%load = 10*}load = 12${motor#*load = 10}"
cp "$out/old.c" "$out/kept.c"
printf '%s\n' "$motor" >"$out/old.scene"
isoc "$out/summary" '' "$out/old.scene" -o "$out" --name old --real double --set 'load = 6 mN*m*s/rad * 2'
sed 's|/\*.*\*/||' "$out/old.c" >"$out/old.text"
sed 's|/\*.*\*/||' "$out/kept.c" | cmp - "$out/old.text"
result $? '--set is another value in the scene'
! isoc /dev/null "$out/errors" "$out/old.scene" -o "$out" --set 'lod = 1' &&
    grep -q "^--set:1:1: error: no constant, tunable or fault is called 'lod' (did you mean 'load'?)" "$out/errors"
result $? '--set of an unknown name is told'
for fault in drive_open drive.open; do
    isoc "$out/summary" "$out/errors" "$out/old.scene" -o "$out" --name old --set "$fault = 1" &&
        sed -n '/defaults\[/,/}/p' "$out/old.c" | grep -q 'R(1.0)'
    result $? "--set $fault = 1: the fault is there from the start"
done
! isoc /dev/null "$out/errors" "$out/old.scene" -o "$out" --set 'drive.open = 2' &&
    grep -q "^--set:1:14: error: 'drive.open' is from 0 to 1" "$out/errors"
result $? '--set of a fault beyond its range is told'
! isoc /dev/null "$out/errors" "$out/old.scene" -o "$out" --set 'drive.opn = 1' &&
    grep -q "^--set:1:1: .* called 'drive.opn' (did you mean 'drive.open'?)" "$out/errors"
result $? '--set of an unknown fault is told'

# A force along an axis of its body, with a moment about it, is that of the statement `force`.
drone='gravity (0, 0, -9.81) m/s^2
step 1 ms
input thrust N = 10 N + 4 N * sin(1 Hz)
body frame { mass 1 kg; com (0.01, 0.02, 0) m; inertia (10, 12, 14) g*m^2 }
joint air free { parent ground; child frame; start rotate 20 deg about x; spin (1, 2, 3) rad/s }
output place = position of frame'
plant old "$drone
force rotor { body frame at (0.2, 0.1, 0) m; axis z; drive thrust; moment 16 mm }"
plant other "$drone
effect rotor {
    body on; signal thrust N; value lever m
    force on on in body = (0, 0, thrust); moment on on in body = (0, 0, lever * thrust)
}
effect first rotor { on frame at (0.2, 0.1, 0) m; thrust thrust; lever 16 mm }"
same 'a force of an effect in the axes of its body is that of the statement force'
plant other "$drone
effect rotor {
    body on; signal thrust N; value lever m
    force on on = thrust * z_axis of on; moment on on in ground = lever * thrust * z_axis of on
}
effect first rotor { on frame at (0.2, 0.1, 0) m; thrust thrust; lever 16 mm }"
program near tests/isoc/effects/near.c tests/host/report.c "$out/old.c" "$out/other.c" && joined 'in the axes of the ground' "$out/near"

# A vector that is kept is three numbers, with the bits of three.
parts='effect pull {
    body on
    memory far_x m = 0 m; next far_x = far_x + 0.01 * dot(position of on, (1, 0, 0))
    memory far_y m = 1 m; next far_y = far_y + 0.01 * dot(position of on, (0, 1, 0))
    memory far_z m = 2 m; next far_z = far_z + 0.01 * dot(position of on, (0, 0, 1))
    state slow_x m/s = 1 m/s; rate slow_x = (dot(velocity of on, (1, 0, 0)) - slow_x) / 20 ms
    state slow_y m/s = 0 m/s; rate slow_y = (dot(velocity of on, (0, 1, 0)) - slow_y) / 20 ms
    state slow_z m/s = 0 m/s; rate slow_z = (dot(velocity of on, (0, 0, 1)) - slow_z) / 20 ms
    force on on = -1 N/m * (far_x, far_y, far_z) - 2 N*s/m * (slow_x, slow_y, slow_z)
}'
whole='effect pull {
    body on
    memory far m = (0, 1, 2) m; next far = far + 0.01 * position of on
    state slow m/s = (1, 0, 0) m/s; rate slow = (velocity of on - slow) / 20 ms
    force on on = -1 N/m * far - 2 N*s/m * slow
}'
pulled='force first { body frame; axis x; drive thrust }
effect pulled pull { on frame at (0.1, 0, 0) m }'
plant old "$drone" "$parts" "$pulled"
plant other "$drone" "$whole" "$pulled"
same 'a vector that is kept has the bits of three numbers'
plant other "$drone" "${whole%(0, 1, 2) m*}(0, 1, 2.01) m${whole#*(0, 1, 2) m}" "$pulled"
! program same tests/isoc/effects/same.c "$out/old.c" "$out/other.c" || ! "$out/same"
result $? 'found: another start of it'
finish
