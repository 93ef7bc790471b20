#!/bin/sh
# The recipes of tests/use/recipes/README.md, done literally: each patch of tests/use/recipes changes at most two files,
# of a statement and a policy at most five, which the recipe names, and what it adds works: a method, a kind of joint, a
# kind of output, a kind of closure, a function, a statement, a policy. Without the patches nothing of it is known.
. tests/host/test.sh
. tests/host/project.sh
begin check/recipes
project
unoptimised clang
cat >"$out/project/pin_slot.scene" <<'SCENE'
# A bar with a pin in a slot: it slides along x and turns about y, without gravity.
step 1 ms

body bar {
    mass 2 kg
    inertia (0.01, 0.01, 0.01) kg*m^2
}

joint slot pin_slot {
    parent ground rotate 90 deg about z
    child bar
    axis x
    second y
    start at 10 mm rotate 20 deg
    speed 1 m/s
    spin 3 rad/s
}

output slide = position of slot_slide
output turn = position of slot_turn
output turning = angular_velocity of bar
effect brake { body on; moment on on = -1 N*m*s * angular_velocity of on * (time > 5 s) }
effect late_brake brake { on bar }
output twice = 2 * angular_velocity of bar along x
SCENE

# Of 2 kg and 0.02 kg m^2 about the thread; a turn advances it by 0.1 m: what falls is (2 + 0.02 / lead^2) kg, lead 0.1
# m / 2 pi.
cat >"$out/project/swivel_nut.scene" <<'SCENE'
gravity (0, 0, -9.81) m/s^2
step 1 ms
body nut {
    mass 2 kg
    inertia (0.02, 0.02, 0.02) kg*m^2
}
joint thread swivel_nut {
    parent ground
    child nut
    axis z
    second x
    pitch 100 mm
    start rotate 0 deg rotate 0 deg
}
output place = position of nut
SCENE
! isochron run pin_slot.scene && says "'pin_slot'"
expect $? "without the patches: the kind of joint is unknown"
! isochron run models/double_pendulum.scene --method ralston && says "no method is called 'ralston'"
expect $? "without the patches: the method is unknown"

sed 's/^close rocker_pin line/close rocker_pin cylindrical/' models/four_bar.scene >"$out/project/cylindrical.scene"
cat >>"$out/project/cylindrical.scene" <<'SCENE'
output speed_of_two = hypotenuse(dot(velocity of coupler, (1, 0, 0)), dot(velocity of coupler, (0, 1, 0)))
output speed_of_pin = norm(velocity of coupler)
SCENE
! isochron run cylindrical.scene && says "'cylindrical'"
expect $? "without the patches: the kind of closure is unknown"
sed 's/ cylindrical {/ line {/' "$out/project/cylindrical.scene" >"$out/project/plain.scene"
! isochron run plain.scene && says "'hypotenuse'"
expect $? "without the patches: the function is unknown"

{ cat models/double_pendulum.scene && echo 'buoyancy 0.5'; } >"$out/project/buoyant.scene"
! isochron run buoyant.scene && says "'buoyancy'"
expect $? "without the patches: the statement is unknown"
{ cat models/double_pendulum.scene && echo 'overrun stop_twice'; } >"$out/project/twice.scene"
! isochron run twice.scene && says "'stop_twice'"
expect $? "without the patches: the policy is unknown"

readme=$(cat tests/use/recipes/README.md)
for recipe in tests/use/recipes/*.patch; do
    files='' changed=0 unnamed=''
    while read -r kind file _; do
        [ "$kind" = +++ ] || continue
        file=${file#b/}
        changed=$((changed + 1))
        files="$files $file"
        case $readme in
        *"$file"* | *"${file%/*}/NAME.${file##*.}"*) ;;
        *) unnamed="$unnamed $file" ;;
        esac
    done <"$recipe"
    case $recipe in
    */statement.patch | */policy.patch) most=5 ;;
    *) most=2 ;;
    esac
    [ $changed -gt 0 ] && [ $changed -le $most ]
    result $? "$recipe changes $changed files:$files"
    [ -z "$unnamed" ]
    result $? "tests/use/recipes/README.md names them$unnamed"
    patch -d "$out/project" -p1 <"$recipe" >"$out/output" 2>"$out/errors"
    expect $? "$recipe applies"
done

# cell ROW COLUMN: $cell is that of the table of the last run; -1 is the last row.
cell()
{
    read_value trace && cell=$(awk -F, -v row="$1" -v column="$2" '
        FNR == 1 { for (i = 1; i <= NF; i++) if ($i == column) at = i; next }
        FNR == row + 2 { value = $at; exit }
        { value = $at }
        END { print value }' "$out/project/$value")
}

# near ROW COLUMN VALUE...: whether these cells of it have these values within 1e-9.
near()
{
    read_value trace && awk -F, -v wanted="$*" '
        BEGIN { count = split(wanted, word, " ") }
        FNR == 1 { for (i = 1; i <= NF; i++) at[$i] = i; next }
        { for (i = 1; i < count; i += 3) if ((word[i] == FNR - 2 || word[i] == -1) && word[i + 1] in at) has[i] = $at[word[i + 1]] }
        END {
            for (i = 1; i < count; i += 3) good += has[i] != "" && (has[i] - word[i + 2]) ^ 2 <= 1e-18
            exit count == 0 || good != count / 3
        }' "$out/project/$value"
}

isochron run pin_slot.scene --seconds 1 --real double
expect $? "a scene with the new joint and the new output runs"
near -1 slide 1.01 -1 turn 3.34906585040
expect $? "the joint slides 1 m and turns by 3 rad in 1 s"
# The second axis of the joint, y, is -x of the ground.
near -1 turning_x -3 -1 turning_y 0 0 turning_x -3
expect $? "the angular velocity is in the axes of the ground"
near -1 twice -6 0 twice -6
expect $? "a formula has it, and so has an effect"

isochron run swivel_nut.scene --seconds 1 --real double
expect $? "a scene with the other new joint runs"
cell -1 place_z
near -1 place_z "$(awk 'BEGIN { lead = 0.1 / 6.283185307179586; printf "%.12f", -0.5 * 9.81 * 2 / (2 + 0.02 / lead ^ 2) }')"
expect $? "its thread advances as it falls: $cell m"

# In the plane such a closure holds what one on a line does.
isochron run models/four_bar.scene --seconds 1 --real double && cell -1 crank_angle && crank=$cell &&
    isochron run cylindrical.scene --seconds 1 --real double
expect $? "a scene with the new closure and the new function runs"
near -1 crank_angle "$crank" && ! near 0 crank_angle "$crank"
expect $? "the closure holds a linkage as it does without: the crank is at $crank"
(cd "$out/project" && make -s build/show && build/isoc cylindrical.scene --shape) >"$out/shape" && "$out/project/build/show" scene it "$out/shape" >"$out/shown" &&
    ! build/show scene it "$out/shape" >"$out/shown" 2>"$out/said" && grep -qx "show: no closure is called 'cylindrical'" "$out/said"
expect $? "a picture has it, by what it holds; control: without the patch no closure is called so"
cell 0 speed_of_pin && first=$cell && cell -1 speed_of_pin &&
    near 0 speed_of_two "$first" -1 speed_of_two "$cell" && ! near 0 speed_of_pin "$cell"
expect $? "the function gives the speed of a point: $cell"

# Half of gravity taken away is half of gravity, to the bit.
sed 's/^gravity .*/gravity (0, -4.905, 0) m\/s^2/' models/double_pendulum.scene >"$out/project/half.scene"
isochron run half.scene --seconds 1 && read_value hash && half=$value && isochron run buoyant.scene --seconds 1 && printed hash "$half"
expect $? "a scene with the new statement runs: $half"
isochron run models/double_pendulum.scene --seconds 1 && ! printed hash "$half"
expect $? "control: without it the scene moves otherwise"

# One overrun is counted, two in a row end the run.
printf 'slow 5 1500us\nslow 7 1500us\n' >"$out/project/apart.script"
printf 'slow 5 1500us\nslow 7 1500us\nslow 8 1500us\n' >"$out/project/row.script"
isochron run twice.scene --seconds 1 --script apart.script && printed ticks 1000 && printed overruns 2
expect $? "a scene with the new policy runs on behind $value overruns"
! isochron run twice.scene --seconds 1 --script row.script && grep -x 'trace: stopped by the overrun of tick 8' "$out/errors" >"$out/said" && read -r said <"$out/said"
expect $? "two in a row end it: $said"

# state_error METHOD STEP: $error is that of the first angle of the double pendulum after 1 s, in double; the reference
# is rk4 with a step that is short enough.
state_error()
{
    isochron run models/double_pendulum.scene --method "$1" --step "$2" --real double --seconds 1 && read_value state &&
        error=$(awk -v a="${value%% *}" -v b="$reference" 'BEGIN { printf "%.3e", (a < b ? b - a : a - b) }')
}

isochron run models/double_pendulum.scene --method rk4 --step 100us --real double --seconds 1
expect $? "the double pendulum with rk4"
read_value state && reference=${value%% *}
state_error ralston 2ms && whole=$error && state_error ralston 1ms && half=$error
expect $? "the double pendulum with the new method"
awk -v whole="$whole" -v half="$half" 'BEGIN { exit !(half > 0 && whole > 3.5 * half && whole < 4.5 * half) }'
result $? "its error is of order 2: $whole at a step of 2 ms, $half at 1 ms"

# What isoc says of it follows from its kernel: every method of two stages and order two has the stability of heun.
cat >"$out/project/stiff.scene" <<'SCENE'
gravity (0, -9.81, 0) m/s^2
step 10 ms
body b {
    mass 1 kg
    com (0, -1, 0) m
}
joint p revolute {
    parent ground
    child b
    axis z
    start 10 deg
    spring 400000 N*m/rad
    damping 40 N*m*s/rad
}
effect drag friction { along p; sliding 1 N*m }
effect ends stop { along p; lower -1 rad; upper 1 rad; impact 1 rad/s }
output a = position of p
SCENE

# advice METHOD: compiles the scene with it; the warnings are in $out/advice, the summary in $out/summary.
advice()
{
    "$out/project/build/isoc" "$out/project/stiff.scene" -o "$out/stiff" --method "$1" >"$out/summary" 2>"$out/advice"
}

# stable METHOD: $stable is its largest step of the last advice.
stable()
{
    stable=
    while IFS= read -r line; do
        case $line in
        *[\ ,]"$1 "*) stable=${line##*[\ ,]"$1 "} && stable=${stable%%,*} && return ;;
        esac
    done <"$out/advice"
}

# advised METHOD: whether what isoc says of the new method is what it says of this one.
advised()
{
    advice "$1" && sed "s/too fast for $1 /too fast for ralston /" "$out/advice" | diff - "$out/ralston.advice" >"$out/diff" &&
        [ "$(grep '^stable' "$out/summary")" = "$(grep '^stable' "$out/ralston")" ]
}
advice ralston && grep -q 'too fast for ralston with a step of 10 ms' "$out/advice" && grep -q '^stable drag.creep' "$out/summary" && grep -q '^stable ends.stiffness' "$out/summary" &&
    stable ralston && of_ralston=$stable && [ -n "$of_ralston" ] && stable rk4 && [ "$of_ralston" != "$stable" ] &&
    stable heun && [ "$of_ralston" = "$stable" ]
expect $? "isoc warns of it where it is too fast, with its largest step: $of_ralston, of heun $stable"
cp "$out/summary" "$out/ralston"
cp "$out/advice" "$out/ralston.advice"
advised heun
expect $? "what isoc says of it, and the effects that follow from its step, are those of heun"
! advised rk4
result $? "control: those of rk4 are others"
isochron run stiff.scene --method ralston --step 1ms --seconds 1
expect $? "a run with a step that it holds"
! isochron run stiff.scene --method ralston --seconds 1 && says guard
expect $? "the guard stops a run with the step that it warns of"

# Methods of three and of six stages: all that the others of one step have.
(cd "$out/project" && make -s -f tests/units.mk VARIANT=plain REAL=float build/tests/plain/float/methods/tableau &&
    build/tests/plain/float/methods/tableau) >"$out/output" 2>"$out/errors" &&
    grep -q '^ok .* - ssprk3$' "$out/output" && grep -q '^ok .* - butcher5$' "$out/output" && ! grep '^not ok' "$out/output"
expect $? "their tables meet the conditions of their orders, by the test of all tables"
state_error ssprk3 2ms && whole=$error && state_error ssprk3 1ms && half=$error &&
    awk -v whole="$whole" -v half="$half" 'BEGIN { exit !(whole > 7 * half && whole < 9 * half) }'
expect $? "of three stages, order 3: $whole at a step of 2 ms, $half at 1 ms"
state_error butcher5 8ms && whole=$error && state_error butcher5 4ms && half=$error &&
    awk -v whole="$whole" -v half="$half" 'BEGIN { exit !(whole > 28 * half && whole < 36 * half) }'
expect $? "of six stages, order 5: $whole at a step of 8 ms, $half at 4 ms"

# on_board METHOD: $count instructions of a step of the double pendulum on the Cortex-M4F; the hash is that of the host.
on_board()
{
    isochron run models/double_pendulum.scene --method "$1" --seconds 1 && read_value hash && host=$value &&
        isochron run models/double_pendulum.scene --method "$1" --seconds 1 --target cortex-m4f && printed hash "$host" && read_value instructions_per_step && count=$value
}
on_board heun && heun=$count && on_board rk4 && rk4=$count && on_board ssprk3 && [ "$count" -gt "$heun" ] && [ "$count" -lt "$rk4" ]
expect $? "a step of three stages takes as many instructions as it has stages: heun $heun, ssprk3 $count, rk4 $rk4"
on_board butcher5 && [ "$count" -gt "$rk4" ]
expect $? "and of six: $count, with the bits of the host"

for method in ssprk3 butcher5; do
    { cat models/double_pendulum.scene && echo 'checked yes; output e = local_error'; } >"$out/project/checked.scene"
    isochron run models/double_pendulum.scene --method $method --seconds 1 && read_value hash && plain=$value &&
        isochron run checked.scene --method $method --seconds 1 && printed hash "$plain" && read_value local_error &&
        awk -v error="$value" 'BEGIN { exit !(error > 0 && error < 1e-4) }'
    expect $? "$method, checked: the same bits, local error $value"
    { cat models/double_pendulum.scene && echo "overrun degrade { method euler; hold; after 10 ticks }"; } >"$out/project/ladder.scene"
    isochron run ladder.scene --method $method --seconds 1 && printed hash "$plain"
    expect $? "$method on a ladder: the same bits"
    { cat models/double_pendulum.scene && echo "overrun degrade { method $method; after 10 ticks }"; } >"$out/project/ladder.scene"
    isochron run ladder.scene --method rk4 --seconds 1
    expect $? "$method as a rung"
    "$out/project/build/isoc" models/double_pendulum.scene --method $method --lanes -o "$out/lanes" >"$out/output" 2>"$out/errors" &&
        (cd "$out/project" && $CC $FLAGS -DISO_LANES=4 -Wno-psabi -c "../lanes/plant.c" -o "../lanes.o") 2>"$out/errors"
    expect $? "$method in lanes"
done

# Sub-steps of a fast state: of order two where the method has that.
cat >"$out/project/fast.scene" <<'SCENE'
gravity (0, -9.81, 0) m/s^2
step 4 ms
body b { mass 1 kg; com (0, -1, 0) m }
joint p revolute { parent ground; child b; axis z; start 60 deg }
effect relax {
    joint shaft
    state z = 0 rad/s
    rate z = (speed of shaft - z) / 1 ms
    effort on shaft = -1 N*m*s/rad * z
}
effect slow relax { shaft p; substeps 8 }
output a = position of p
SCENE
# fast_error METHOD STEP: $error is that of the angle after 1 s.
fast_error()
{
    isochron run fast.scene --method "$1" --step "$2" --real double --seconds 1 && read_value state &&
        error=$(awk -v a="${value%% *}" -v b="$reference" 'BEGIN { printf "%.3e", (a < b ? b - a : a - b) }')
}
isochron run fast.scene --method rk4 --step 50us --real double --seconds 1 && read_value state && reference=${value%% *}
for method in ssprk3 butcher5; do
    fast_error $method 500us && whole=$error && fast_error $method 250us && half=$error &&
        awk -v whole="$whole" -v half="$half" 'BEGIN { exit !(whole > 3.6 * half) }'
    expect $? "$method, sub-steps of a fast state: $whole at a step of 500 us, $half at 250 us"
done
sed 's/substeps 8/substeps 6/' "$out/project/fast.scene" >"$out/project/six.scene" &&
    { ! "$out/project/build/isoc" "$out/project/six.scene" --method butcher5 -o "$out/fast" 2>"$out/errors" >"$out/output" &&
        grep -q 'with butcher5 the number of sub-steps is a multiple of 4' "$out/errors"; }
result $? "a number of sub-steps that does not lead to its stages is refused"

# families: the families of the legend of a report with these methods.
families()
{
    (cd "$out/project" && PYTHONPATH=tools TEST_BUILT=yes python3 -c '
import sys
from lab.methods import known_methods
from lab.picture.work_precision import work_precision
rows = [["float", method, "0.001", "1000", "1e-3", "-", "100", "1e5", "-"] for method in sys.argv[1:]]
print(work_precision("NAME", 1, rows, known_methods()).text())' "$@") >"$out/report.gnuplot"
    sed -n "s/^set label [0-9]* '\(.*\):' at 85, .*/\1/p" "$out/report.gnuplot" | tr '\n' ','
}
[ "$(families ralston euler)" = "one step," ] && [ "$(families ralston unheard_of)" = "one step,others," ]
result $? "a report draws it with the methods of one step"
finish
