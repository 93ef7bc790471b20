#!/bin/sh
# Inputs that change at every tick, held and smooth: the order of every method, the samples in the plant's memory, what
# isoc warns of, the same bits and one count on host and board.
. tests/host/test.sh
. tests/host/project.sh
. tests/host/bits.sh
begin inputs
one_isoc
mkdir -p "$out/hash" "$out/plant" "$out/run"
rm -f "$out/hand"
scene=tests/isoc/plant/inputs/loop.scene
optimised -O0

# orders NAME PLANT: the program of a plant, whose orders it measures.
orders()
{
    EXTRA="-DPLANT=\"$2\"" program "$1.run" tests/isoc/plant/inputs/order.c tests/core/methods/order/plant.c tests/host/report.c "$out/general.o"
}
program general.o -c tests/general.c

isoc /dev/null '' $scene -o "$out/order" --real double && orders order "$out/order/plant.c"
result $? "the plant builds"
joined order "$out/order.run"

# Equations that are not affine in an input: rosenbrock needs its rate to one order more, and isoc sees that.
{
    cat $scene
    echo 'effect square { joint rail; signal pull N; effort on rail = pull * pull / 2 N }'
    echo 'effect curve square { rail rail; pull force }'
} >"$out/curved.scene"
isoc /dev/null '' "$out/curved.scene" -o "$out/curved" --real double --method rosenbrock &&
    orders curved "$out/curved/plant.c"
result $? "the plant with a square builds"
joined curved "$out/curved.run" "force squared"
sed '/curved = true/d' "$out/curved/plant.c" >"$out/curved/affine.c" && ! cmp -s "$out/curved/affine.c" "$out/curved/plant.c" &&
    orders affine "$out/curved/affine.c" &&
    ! "$out/affine.run" "taken as affine" >"$out/output"
expect $? "control: $(tail -n 3 "$out/output" | head -n 1)"
! isoc /dev/null '' $scene -o "$out/curved" --method rosenbrock || ! grep -q curved "$out/curved/plant.c"
result $? "efforts are affine: rosenbrock takes one evaluation for the rate"

# Three plants in one program: with inputs that are held, smooth, and smooth with a jump.
sed 's/ smooth$//' $scene >"$out/held.scene"
sed 's/ smooth$/ smooth jump 1 N*m/; s/force smooth jump 1 N.m/force smooth jump 1 N/' $scene >"$out/jump.scene"
for method in rk4 rosenbrock; do
    rm -rf "$out/three" && isoc /dev/null '' "$out/held.scene" --name held --method $method -o "$out/three" --real double &&
        isoc /dev/null '' $scene --name smooth --method $method -o "$out/three" --real double &&
        isoc /dev/null '' "$out/jump.scene" --name jump --method $method -o "$out/three" --real double &&
        EXTRA="-I$out/three" program "three_$method.run" tests/isoc/plant/inputs/three.c "$out/three"/*.c tests/host/report.c
    result $? "three plants with $method build"
    joined "$method" "$out/three_$method.run"
done

# A plant by hand: half the step divides the error by 16, to a tenth of that.
for step in 0.01 0.005; do
    EXTRA="-DISO_STEP=$step" program hand.run tests/isoc/plant/inputs/hand.c && "$out/hand.run" >>"$out/hand"
done
awk '{ error[NR] = $1 } END { print error[1], error[2]; exit !(NR == 2 && error[1] > 14.4 * error[2] && error[1] < 17.6 * error[2]) }' \
    "$out/hand" >"$out/errors"
expect $? "by hand, rk4: half the step makes $(cat "$out/errors")"

# warned METHOD SCENE PATTERN: isoc accepts the scene, and says this; nothing, if there is no pattern.
warned()
{
    isoc /dev/null "$out/errors" "$2" --method "$1" -o "$out/warned" &&
        if [ -n "$3" ]; then grep -q "^$2:[0-9]*:7: warning: .*$3" "$out/errors"; else [ ! -s "$out/errors" ]; fi
    expect $? "$1, $(basename "$2" .scene): ${3:-no warning}"
}

for method in euler heun rk4 semi_implicit rosenbrock; do
    warned $method "$out/held.scene" ''
done
for method in ab4 abm4 abm4_pec abm4_pecece; do
    warned $method "$out/held.scene" "'force' is held, and $method has a history: .* order one; take rk4, or 'input force smooth'"
    warned $method $scene ''
done
warned bdf4 "$out/held.scene" "order one; take rosenbrock"
warned adams "$out/held.scene" "order two; take rk4"
{ cat $scene && echo 'checked yes'; } >"$out/checked.scene"
warned bdf4 "$out/checked.scene" "without that of the extrapolated input 'force'; take rosenbrock"
warned abm4_pec "$out/checked.scene" "without that of the extrapolated input 'force'; take abm4"
for method in rk4 ab4 abm4 abm4_pecece rosenbrock; do
    warned $method "$out/checked.scene" ''
done

# noise SCENE PLACE PATTERN: the same with ab4, of noise outside of inputs: at a place of its second line.
noise()
{
    { echo 'effect shove { joint along; signal by N; effort on along = by }' && echo "$1" && cat $scene; } >"$out/noise.scene"
    isoc /dev/null "$out/errors" "$out/noise.scene" --method ab4 -o "$out/warned" &&
        if [ -n "$2" ]; then grep -q "^$out/noise.scene:2:$2: warning: $3" "$out/errors"; else [ ! -s "$out/errors" ]; fi
    expect $? "ab4, noise: ${3:-no warning where the motion does not depend on it}"
}
gust='effect wind gust { mean 1 m/s; sigma 1 m/s; length 10 m; speed 2 m/s }'
noise "$gust; effect drift drag { on cart; area 1 m^2; wind_x wind.value }" 8 \
    "the noise of the effect 'wind' changes at every tick .* ab4 is of order one; take rk4"
noise 'effect push shove { along rail; by 1 N * noise(3) }' 42 'the noise changes at every tick'
noise "$gust; output wind = wind.value" ''

# The word held is the default.
mkdir -p "$out/said" && sed 's/ smooth$/ held/' $scene >"$out/said/loop.scene"
isoc /dev/null '' "$out/said/loop.scene" --method rk4 -o "$out/one" && sed 's/ held / /; s/ held$//' "$out/one/plant.c" >"$out/said.c" &&
    isoc /dev/null '' "$out/held.scene" --method rk4 -o "$out/two" && sed 's/held[.]scene/loop.scene/; s/"held"/"loop"/' "$out/two/plant.c" |
    cmp -s - "$out/said.c"
result $? "held is what an input is by itself"

# The same bits, and one count: functions of time as samples.
sed 's/^input force smooth/& = 8 N * sin(5 Hz)/; s/^input torque smooth/input torque = 1 N*m * sin(2 Hz)/' $scene >"$out/waves.scene"
real float
optimised -O2
for where in 'host host cc -O0' 'board mps2 arm-none-eabi-gcc -O2'; do
    # shellcheck disable=SC2086
    variant $where
    for method in rk4 abm4 bdf4 rosenbrock adams; do
        same "$out/waves.scene" $method
    done
done
finish
