#!/bin/sh
# Sampled time (tools/isoc/README.md): what rows 0 to 7 have of memories, pasts, starts, functions of time and settings,
# worked out by hand; and the order of each method with a delay in the equations.
. tests/host/test.sh
begin sampled
one_isoc
optimised -O0

# rows NAME ROW...: of the scene on standard input; each row is its outputs.
rows()
{
    name=$1
    shift
    {
        echo 'step 1 ms'
        while IFS= read -r line; do
            printf '%s\n' "$line"
        done
    } >"$out/rows.scene"
    isoc "$out/summary" '' "$out/rows.scene" -o "$out/rows.plant" --real $real &&
        EXTRA="-DPLANT=\"$out/rows.plant/plant.c\"" program rows tests/isoc/plant/sampled/rows.c && "$out/rows" >"$out/shown"
    begins "$@"
    same=$?
    result $same "$real: $name"
    [ $same -eq 0 ] || head -n $# "$out/shown" | sed 's/^/# /'
}

# begins ROW...: whether these are the first rows in $out/shown.
begins()
{
    begins=0
    for row; do
        IFS= read -r shown <&3 && [ "$shown" = "$row" ] || begins=1
    done 3<"$out/shown"
    return $begins
}
cart='body b { mass 1 kg }; joint j prismatic { parent ground; child b; axis x; start 1 m; speed 1 m/s }'
counter='effect counter { memory n = 5; next n = n + 1; output n }; effect c counter { }'

for number in float double; do
    real $number
    rows 'previous, delay and sample of a memory' '5 5 5 5' '6 5 5 5' '7 6 5 5' '8 7 6 8' '9 8 7 8' '10 9 8 8' '11 10 9 11' <<END
$cart; $counter
output n = c.n; output p = previous(c.n); output d = delay(c.n, 2 ms); output s = sample(c.n, every 3 ms)
END
    rows 'with a start of their own' '0 1 2 3 1' '5 0 2 3 2' '6 5 0 3 3' '7 6 5 8 4' '8 7 6 8 5' <<END
$cart; $counter; signal m = previous(c.n, 0); signal count = 1 + previous(count, 0)
output a = m; output p = previous(m, 1); output d = delay(m, 2 ms, 2); output s = sample(c.n, every 3 ms, 3); output c = count
END
    rows 'of each other, and in a next' '5 5 5 5' '6 5 5 5' '7 5 5 5' '8 6 5 8' '9 7 5 8' '10 8 8 8' '11 9 8 11' <<END
$cart; $counter
effect follow { signal x; memory m = x; next m = sample(x, every 3 ms); output m }
effect f follow { x c.n }
output n = c.n; output pp = previous(previous(c.n)); output ds = delay(sample(c.n, every 3 ms), 2 ms); output sp = sample(delay(c.n, 1 ms) + 1 - 1 * (c.n < 6), every 3 ms)
END
    rows 'functions of time and a setting are those of the row' '0 0 1 0' '1 1 1 0' '2 3 2 0' '3 6 2 1' '4 10 2 2' <<END
$cart; tunable k = 1
effect sum { signal x; memory s = 0; next s = s + x; output s }
effect all sum { x time / 1 ms }
at 2 ms set k = 2
output now = time / 1 ms; output s = all.s; output k = k; output late = delay(time / 1 ms, 2 ms)
END
    rows 'starts follow from one another' '1 3 4 2' '1 3 4 2' '1 3 4 2' <<END
body b { mass 1 kg }; joint j prismatic { parent ground; child b; axis x; start 1 m }
tunable two = 2
effect chain { joint along; value k; memory c = b + a; next c = c; memory b = a + k; next b = b; memory a = position of along / 1 m; next a = a
  state z = k * 1; rate z = 0 Hz; output a; output b; output c; output z }
effect e chain { along j; k two }
output a = e.a; output b = e.b; output c = e.c; output z = e.z
END
done

real float
sensed='1.99951172 2.00195312 1111 -0.5'
rows 'sensors begin with what they sense' "$sensed" "$sensed" <<END
body b { mass 2 kg; inertia (0.1, 0.2, 0.3) kg*m^2 }
joint j revolute { parent ground; child b; axis z; start 200 deg; speed 1 rad/s }
input i A = 2 A
effect c current_sense { current i; range 5 V }
effect a adc { input i; lower -10 A; upper 10 A }
effect e encoder { shaft j; lines 500 }
effect u imu { on b at (0.5, 0, 0) m }
output c = c.value; output a = a.value; output e = e.count; output fx = u.force_x
END
cp "$out/rows.plant/plant.c" "$out/rows.plant/good.c"
sed 's/    begin_1(memory);/    (void)memory, (void)begin_1;/' "$out/rows.plant/good.c" >"$out/rows.plant/plant.c"
! cmp -s "$out/rows.plant/good.c" "$out/rows.plant/plant.c" &&
    EXTRA="-DPLANT=\"$out/rows.plant/plant.c\"" program rows tests/isoc/plant/sampled/rows.c && "$out/rows" >"$out/shown" &&
    ! begins "$sensed" "$sensed"
result $? 'found: sensors without their starts'

printf '%s\n' 'step 1 ms' "$cart" 'effect a { signal x; memory m = x; next m = x; output m }' 'effect one a { x two.m }' \
    'effect two a { x one.m }' 'output m = one.m' >"$out/loop.scene"
isoc "$out/summary" "$out/errors" "$out/loop.scene" -o "$out/loop"
[ $? -eq 1 ] && grep -q 'algebraic loop' "$out/errors" && [ ! -e "$out/loop" ]
result $? 'starts that need each other are refused'
printf '%s\n' 'step 1 ms' "$cart" 'signal m = 1 + sample(m, every 5 ms, 0)' 'output m = m' >"$out/loop.scene"
isoc "$out/summary" "$out/errors" "$out/loop.scene" -o "$out/loop"
[ $? -eq 1 ] && grep -q 'loop.scene:3:.*algebraic loop' "$out/errors" && [ ! -e "$out/loop" ]
result $? 'so is a sample that needs itself'

# delayed METHOD STEP EFFORT: the error of x'' = -w^2 x(t - tau).
real double
delayed()
{
    printf '%s\n' "step $2 ms" "method $1" 'body b { mass 1 kg }' \
        'joint j prismatic { parent ground; child b; axis x; start 1 m }' \
        'effect pull { joint along; memory none N = 0 N; next none = none' "effort on along = $3 }" 'effect p pull { along j }' \
        'output x = position of j' >"$out/delay.scene"
    isoc "$out/summary" "$out/errors" "$out/delay.scene" -o "$out/delay.plant" --real double &&
        EXTRA="-DPLANT=\"$out/delay.plant/plant.c\" -DTAU=0.04L" program delay tests/isoc/plant/sampled/delay.c && "$out/delay"
}
# order METHOD POWER EFFORT: the errors with 10 and 5 ms fall by a power of two that is at most 0.3 less than this, or
# 0.5 more.
order()
{
    { delayed "$1" 10 "$3" && delayed "$1" 5 "$3"; } >"$out/errors_of"
    awk -v power="$2" '
        { error[NR] = $1 }
        END {
            found = error[2] > 0 ? log(error[1] / error[2]) / log(2) : "none"
            print found
            exit !(found >= power - 0.3 && found <= power + 0.5)
        }' "$out/errors_of" >"$out/found"
    falls=$?
    read -r found <"$out/found"
    result $falls "$1: the error falls with the power $found of the step, of about $2"
}
at_stages='-25 N/m * delay(position of along, 40 ms)'
for method in 'euler 1' 'semi_implicit 1' 'heun 2' 'rosenbrock 3' 'rk4 4' 'ab4 4' 'abm4 4' 'bdf4 4'; do
    order "${method% *}" "${method#* }" "$at_stages"
    case $method in
    heun* | rosenbrock* | rk4*) measured="\`${method% *}\` $(printf %.2f "$found")${measured:+, $measured}" ;;
    esac
done
stated tools/isoc/README.md "$measured"
result $? "tools/isoc/README.md has these powers"
held='-25 N/m * delay(position of along + none / 25 N * 1 m, 40 ms)'
order rk4 1.1 "$held" # the control: not of order four
grep -q 'delay.scene:.*constant within a step, and so half a step longer' "$out/errors"
result $? 'a delay of a memory too is constant within a step: isoc warns'
delayed rk4 5 "$at_stages" >"$out/shown"
[ ! -s "$out/errors" ]
result $? 'of a state alone it acts at each stage: no warning'
# memories OUTPUT: of a pendulum with a unit of which this is shown.
memories()
{
    printf '%s\n' 'gravity (0, -9.81, 0) m/s^2' 'step 1 ms' 'body bob { mass 1 kg; com (0, -1, 0) m }' \
        'joint pivot revolute { parent ground; child bob; axis z; start 90 deg }' 'effect unit imu { on bob at (0, -1, 0) m }' "output shown = $1" >"$out/read.scene"
    build/isoc "$out/read.scene" -o "$out/read" | sed -n 's/^memories //p'
}
[ "$(memories unit.spin_z)" = 1 ] && ! grep -q 'derivative(dx' "$out/read/plant.c" && [ "$(memories 'unit.spin_z + unit.force_x / (1 m/s)')" = 2 ] &&
    grep -q 'derivative(dx' "$out/read/plant.c"
result $? 'of a unit only the components that are read are there'
finish
