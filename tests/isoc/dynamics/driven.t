#!/bin/sh
# Motions and speeds that are prescribed as functions of time, and the efforts that they take, against formulas by hand.
. tests/host/test.sh
begin driven
one_isoc
optimised -O0
ours="tests/isoc/dynamics/driven.c tests/host/report.c"

# driven NAME SCENE [OPTION...]: the program of a scene.
driven()
{
    name=$1
    text=$2
    shift 2
    # shellcheck disable=SC2086
    isoc "$out/$name.summary" '' "$text" -o "$out/$name" --real "$real" "$@" &&
        program "$name.run" $ours "$out/$name/plant.c"
}

# In double, eight digits. In float a speed keeps the roundings of the last 1/(alpha h) = 20 steps, some 10 epsilons of
# at most 9 m/s, of which the stabilisation makes 2 alpha times that: 6e-4 N or N m, of 0.6 kg at the crank and 2 kg in
# the lift.
for demand in 'float 1ms 1e-6 1e-3' 'double 125us 1e-8 1e-8'; do
    # shellcheck disable=SC2086
    set -- $demand
    real "$1"
    driven "$1" tests/isoc/dynamics/driven.scene --step "$2"
    result $? "driven builds in $1"
    joined "driven in $1 with $2" "$out/$1.run" "$3" "$4"
done

# halved METHOD ORDER STEP HALF OUTPUT...: half the step divides an error by 2^ORDER, to a quarter of that.
halved()
{
    driven "$1-whole" tests/isoc/dynamics/driven.scene --method "$1" --step "$3"
    driven "$1-half" tests/isoc/dynamics/driven.scene --method "$1" --step "$4"
    method=$1
    order=$2
    shift 4
    for output; do
        "$out/$method-whole.run" "$output" >"$out/whole" && "$out/$method-half.run" "$output" | paste "$out/whole" - |
            awk -v order="$order" '{ print; exit !($1 > 0.75 * 2 ^ order * $2 && $1 < 1.25 * 2 ^ order * $2) }' >"$out/errors"
        result $? "$method, order $order: half the step makes $(cat "$out/errors") of $output"
    done
}

# The curvature of a ramp has corners at its points. Steps that end there keep the order of a one-step method that does
# not look ahead; any other has order four, or three, only where there are none.
halved rk4 4 250us 125us slider lift pull speed twist
halved abm4 4 500us 250us slider table twist
halved ab4 4 250us 125us table twist
halved bdf4 4 500us 250us slider table twist
halved rosenbrock 3 500us 250us slider table twist

# Control: points between the steps.
driven between tests/isoc/dynamics/driven.scene --step 160us
whole=$("$out/rk4-whole.run" lift) && between=$("$out/between.run" lift) &&
    awk -v a="$between" -v b="$whole" 'BEGIN { exit !(a > 100 * b) }'
result $? "control: where a ramp's points lie between the steps of 160 us, the lift is off by $between, not $whole"

# A gear whose ratio is one of whole numbers holds the angles of continuous joints, up to whole turns; any other only
# their speeds, so that what is pulled off stays off.
back=$("$out/rk4-whole.run" pulled) && awk -v off="$back" 'BEGIN { exit !(off ~ /^[0-9]/ && off <= 1e-8) }'
result $? "a geared spindle that was turned by 0.01 rad comes back to $back"
sed 's/ratio -2 /ratio -2.0000001 /' tests/isoc/dynamics/driven.scene >"$out/odd.scene"
driven odd "$out/odd.scene" && off=$("$out/odd.run" pulled) && awk -v off="$off" 'BEGIN { exit !(off > 0.009 && off < 0.011) }'
result $? "control: with another ratio it stays off by $off"

# The gains of Baumgarte that follow the step: no method is unstable with them. Euler's speed, at up to 240 rad/s^2,
# lags by that many rad/s times 1 ms; what grows passes any limit.
sed 's/^stabilisation.*/stabilisation baumgarte/' tests/isoc/dynamics/driven.scene >"$out/own_gains.scene"
within='BEGIN { exit !(off ~ /^[0-9]/ && off <= 0.24) }'
for method in $(build/isoc --methods | sed -n 's/^| \([a-z0-9_]*\) | [0-9] .*/\1/p'); do
    driven "own-$method" "$out/own_gains.scene" --method "$method" &&
        off=$("$out/own-$method.run" speed) && awk -v off="$off" "$within"
    result $? "$method with gains that follow the step: speed off by $off"
done

# Control: twice the gain of a speed is too much for the method that is least stable.
sed 's/^stabilisation.*/stabilisation baumgarte { alpha 200 Hz; beta 100 Hz }/' tests/isoc/dynamics/driven.scene >"$out/strong.scene"
driven strong "$out/strong.scene" --method abm4_pec && off=$("$out/strong.run" speed) && ! awk -v off="$off" "$within"
result $? "control: abm4_pec with twice the gain: speed off by $off"
finish
