#!/bin/sh
# Runs that go wrong end with a message of the guard that names state and tick, status 1, and the outputs of the last
# good tick: explicit methods on a stiff bushing at 1 kHz; forces that are not a number, infinite, or 1e38; a state that
# is driven out of range. An input that is not finite does not come so far. The plant is, but for a wheel at the end,
# tests/promises/hard/guarded.c: states are 0 free, 1 bushing, and their speeds 2 and 3.
. tests/host/test.sh
. tests/host/project.sh
begin hard_guard
one_isoc
optimised -O0

# build NAME SOURCE [FLAG...]: the program $out/NAME of this plant in C. What all have in common is compiled once for
# each type of numbers, as one file.
build()
{
    build_name=$1
    build_source=$2
    shift 2
    [ -f "$out/$real.o" ] || {
        printf '#include "%s"\n' core/runtime/loop.c core/application/stream.c core/numbers/self_check.c port/host/*.c port/unix/console.c \
            core/application/main.c >"$out/common.c"
        EXTRA=-Wno-shadow program "$real.o" -c "$out/common.c"
    }
    EXTRA="$*" program "$build_name" "$build_source" "$out/$real.o"
}

# run PROGRAM SECONDS: its summary is in $out/output, its table $csv. Returns its status, which is also in $status.
run()
{
    csv=$out/trace.csv
    build/trace -o "$out" -- "$out/$1" "$2" >"$out/output" 2>"$out/errors" </dev/null
    status=$?
    return $status
}

# How core calls the methods.
build/isoc --methods | awk '$1 == "|" && $2 ~ /^[a-z0-9_]+$/ { print "kernel_" $2 "=ISO_" toupper($2) }' >"$out/kernels"
# shellcheck disable=SC1091
. "$out/kernels"

# guarded METHOD SECONDS FAULT [REAL]: runs the plant with this fault.
guarded()
{
    real "${4:-float}"
    guarded_program=guarded_${real}_$1
    [ -f "$out/$guarded_program" ] || eval build "$guarded_program" tests/promises/hard/guarded.c "-DISO_METHOD=\$kernel_$1" "-DISO_METHOD_NAME=$1"
    FAULT=$3 run "$guarded_program" "${2}000000000"
}

# stops STATE TICK: the last run was stopped there; states and ticks are regular expressions. The table ends with
# finite outputs of the tick before, and the summary counts no more.
stops()
{
    found=$(awk -v why="$why" -v names="$names" -v states="$1" -v ticks="$2" '
        FILENAME == ARGV[1] && /^trace: guard state / {
            state = $4
            tick = substr($8, 1, length($8) - 1)
            is_told = $0 == "trace: guard state " state " " $5 " at tick " tick ": it is " why && (state " " $5) ~ ("^(" names ")$")
        }
        FILENAME == ARGV[2] && $1 == "ticks" { counted = $2 }
        FILENAME == ARGV[3] { rows = FNR - 1; last = tolower($0) }
        END {
            print state, tick
            exit !(is_told && state ~ ("^" states "$") && tick ~ ("^" ticks "$") && counted == tick - 1 && rows == tick && last !~ /nan|inf/)
        }' "$out/errors" "$out/output" "$csv") && [ "$status" -eq 1 ]
    is_stopped=$?
    tick=${found#* }
    return $is_stopped
}

why='not finite'
names='0 free|1 bushing|2 free_speed|3 bushing_speed'

# stiff METHOD REAL
stiff()
{
    guarded "$1" 1 '' "$2"
    stops '[13]' '[0-9]+'
    expect $? "$1 in $2 on 1e8 N/m at 1 kHz: stopped at state ${found% *}, tick $tick"
}

for method in euler heun rk4 ab4 semi_implicit abm4 abm4_pec abm4_pecece; do
    stiff $method float
done
stiff euler double
stiff rk4 double
for method in bdf4 rosenbrock; do
    guarded $method 1 '' && tail -n 1 "$csv" | awk -F, '$3 ^ 2 > 1e-24 { exit 1 }'
    expect $? "control: $method runs on, and comes to rest"
done

# Which state shows it first: the speed alone, where the position follows from speeds that know nothing of it yet.
for method in euler:3 heun:1 rk4:1 ab4:3 semi_implicit:1 abm4:3 bdf4:1 rosenbrock:1; do
    for fault in not_a_number infinite; do
        guarded ${method%:*} 1 "soft bushing $fault"
        stops "${method#*:}" 101
        expect $? "$fault into ${method%:*}: stopped at state ${found% *}, tick $tick"
    done
done

guarded rk4 1 soft
sound=$(value hash)
for fault in not_a_number infinite; do
    guarded rk4 1 "soft input $fault" && [ "$(value hash)" = "$sound" ] && [ "$(value inputs_held)" -eq 900 ]
    expect $? "$fault as an input: held at its last good value, and counted"
done

# follows: from 0.2 s on the free body's position is that of 1e38 N from 0.1 s on, to 0.1 %
# and what a method of order one lags behind.
follows()
{
    awk -F, -v h=0.001 'NR > 1 && $1 > 0.2 { t = $1 - 0.1; want = 0.5e38 * t * t; n++
        if (($2 / want - 1) ^ 2 > (0.001 + h / t) ^ 2) exit 1 } END { if (!n) exit 1 }' "$csv"
}

# 1e38 N on 1 kg: in float the position passes 3.4e38 m after 2.61 s; six times a speed, the sum of a method's slopes,
# before. Six times the force itself is beyond float, so that rk4 stops at once.
for method in euler heun semi_implicit ab4 abm4 bdf4 rosenbrock; do
    guarded $method 4 'soft enormous'
    stops 0 '[0-9]+' && [ "$tick" -le 2710 ] && follows
    expect $? "1e38 N into $method: right until it is stopped at state ${found% *}, tick $tick"
done
guarded rk4 4 'soft enormous'
stops 2 101
expect $? "1e38 N into rk4: stopped at state ${found% *}, tick $tick"
guarded rk4 4 'soft enormous' double && follows
expect $? "control: in double there is room for it"

# wheel SPEED OPTION METHOD: a wheel that turns evenly, its angle in the sine of an unbalance; step 1 ms.
wheel()
{
    cat >"$out/wheel.scene" <<END
step 1 ms
body rotor {
    mass 1 kg
    com (0, 0.1, 0) m
}
joint shaft revolute {
    parent ground
    child rotor
    axis z
    speed $1 rad/s
    $2
}
output angle = position of shaft
END
    isoc "$out/summary" '' "$out/wheel.scene" --method "$3" -o "$out/wheel" && build wheel_program "$out/wheel/plant.c" &&
        run wheel_program 20000000
}
real float

# 950 rad in a tick: the 10th ends at 9500, the 11th at 10450 rad, beyond the domain of the sine.
why='out of range'
names='0 shaft'
for method in rk4 ab4 bdf4 adams; do
    wheel 950000 '' $method
    stops 0 11
    expect $? "an angle beyond 10000 rad with $method: stopped at state ${found% *}, tick $tick"
done
wheel -950000 '' rk4
stops 0 11
expect $? "and one below -10000 rad"
wheel 950000 continuous rk4
[ $status -eq 0 ] && [ "$(value ticks)" = 20 ]
expect $? "control: a continuous joint turns on"
finish
