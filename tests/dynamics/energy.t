#!/bin/sh
# The account of energy, the outputs energy, power and balance, of every model, a third of them each time, and of all effects of
# the library.
. tests/host/test.sh
begin dynamics_energy
optimised -O0
turn=$(turn_of 3 "${1-}" core tools/isoc models)
echo "# turn $turn of the models"
lossy=" $(grep -l '^ *loss = ' models/effects/*.scene | sed 's|.*/||; s|\.scene$||' | tr '\n' ' ')"
EXTRA=-O1
program energy.o -c tests/dynamics/energy.c && program report.o -c tests/host/report.c
result $? 'the test builds'

# account SCENE NAME [OPTION...]: the program that closes the account of a scene. Without optimisation, and by the compiler
# that takes half of the time for that.
account()
{
    text=$1
    name=$2
    shift 2
    mkdir -p "$out/$name"
    case $text in
    /*) printf 'include "%s"\n' "$text" ;;
    *) printf 'include "%s/%s"\n' "$PWD" "$text" ;;
    esac >"$out/$name.scene"
    losses=0
    for effect in $(build/isoc "$text" --effects | awk '{ print $1 "=" $2 }'); do
        case $lossy in
        *" ${effect#*=} "*)
            echo "output account_loss$losses = loss of ${effect%=*}" >>"$out/$name.scene"
            losses=$((losses + 1))
            ;;
        esac
    done
    printf 'output account_%s = %s\n' energy energy power power balance balance >>"$out/$name.scene"
    build/isoc "$out/$name.scene" -o "$out/$name" --real double --method rk4 --inputs held "$@" >"$out/$name/summary" \
        2>"$out/$name/told" &&
        clang -std=c11 -O0 -ffp-contract=off -fno-math-errno -I. $REAL_FLAG "$out/$name/plant.c" "$out/energy.o" "$out/report.o" -lm \
            -o "$out/$name/run"
}

# kind_of SCENE: what the test expects of its steps.
kind_of()
{
    if grep -q '^stabilisation lagrangian' "$1"; then
        echo singular
    elif grep -q '^ *effect ' "$1"; then
        echo corners
    else
        echo smooth
    fi
}

# closed NAME SCENE: four seconds of it, the squeezer half of one; of the ticks some hundred, where there are corners 2000.
closed()
{
    kind=$(kind_of "$2")
    seconds=$([ "$1" = squeezer ] && echo 0.5 || echo 4)
    ticks=$(awk -v seconds="$seconds" '$1 == "step" && $3 == "s" { printf "%d", seconds / $2 + 0.5 }' "$out/$1/summary")
    joined "$1" "$out/$1/run" "$kind" "$ticks" $((ticks / ($([ "$kind" = corners ] && echo 2000 || echo 200)) + 1)) "$losses"
    projected=$(sed -n 's/^# projected \([^ ]*\) J of \([^ ]*\) J$/\1 \2/p' "$out/tap")
}

for scene in models/*.scene tests/effects/all.scene; do
    [ "$scene" = tests/effects/all.scene ] || next_turn 3 || continue
    name=${scene##*/}
    name=${name%.scene}
    account "$scene" "$name"
    result $? "$name builds"
    closed "$name" "$scene"
    grep -q '^close ' "$scene" || continue
    # What the projection takes is of order h^5 in a tick: half the step leaves 1/32 in as many of them, or rounding.
    whole=$projected
    step=$(awk '$1 == "step" && $3 == "s" { print $2 / 2 "s" }' "$out/$name/summary")
    account "$scene" "$name" --step "$step" && closed "$name" "$scene"
    echo "$whole $projected" | awk '{ exit !(NF == 4 && ($3 < $1 / 16 || $3 < 1e-12 * $4)) }'
    result $? "$name: what the projection takes is $whole J, with half the step $projected J"
done

# A cable whose length is a state: what the winch gives is in the account, and is missed where the cable does not know its rate.
drum='effect drum { signal to m; state paid m = 6 m; rate paid = reel; let reel = (to - paid) / (0.2 s); output paid; output reel }
effect winder drum { to winch }'
for reel in 'winder.reel' '0 m/s'; do
    { echo "$drum" && sed "s|length winch$|length winder.paid; reel $reel|" models/crane.scene; } >"$out/drum.scene"
    account "$out/drum.scene" reeled
    if [ "$reel" = winder.reel ]; then
        closed reeled "$out/drum.scene"
    else
        ! "$out/reeled/run" corners 3000 7 "$losses" >"$out/tap" && grep -q '^not ok 1 - balance' "$out/tap"
        result $? 'found: a cable that does not know that its length changes'
    fi
done

# planted SCENE KIND SED: the scene finds its effect of that kind so changed: its balance is none.
planted()
{
    name=$(basename "$1" .scene)_$2
    { sed "$3" "models/effects/$2.scene" && sed "s|^include \"|include \"$PWD/$(dirname "$1")/|" "$1"; } >"$out/$name.planted.scene"
    ! sed "$3" "models/effects/$2.scene" | cmp -s - "models/effects/$2.scene" &&
        account "$out/$name.planted.scene" "$name" && ! "$out/$name/run" corners 3000 7 "$losses" >"$out/tap" &&
        grep -q '^not ok 1 - balance' "$out/tap"
    result $? "found in $2: $3"
}
planted models/dc_motor_bench.scene dc_motor 's/effort on shaft = constant/effort on shaft = 1.000001 * constant/'
planted models/dc_motor_bench.scene friction 's/loss = -effort/loss = effort/'
grep -q '^not ok 2 - 2 losses give no energy' "$out/tap"
result $? 'found in friction: a loss that gives energy'
planted models/cart_pole_drive.scene stop 's|stiffness \* (above - below)^2 / 2|stiffness * (above - below)^2 / 3|'
planted tests/effects/all.scene cogging 's/(1 - cos(angle))/(1 - cos(angle)) * 1.001/'
planted models/arm_drive.scene flexible_gear 's|effort / ratio) / rotor|effort) / rotor|'
planted models/balancer.scene contact 's/ball = cross(arm, push)/ball = cross(push, arm)/'
planted models/crane.scene cable 's|tension / distance \* gap|1.000001 * tension / distance * gap|'
planted models/crane.scene cable 's/loss = (tension - stiffness \* stretch)/loss = (stiffness * stretch - tension)/'
planted models/quadrotor_sih.scene propeller 's/(0 N, 0 N, lift)/(0 N, 0 N, 1.00001 * lift)/'
planted models/quadrotor_sih.scene drag 's/loss = -dot(force, v)$/loss = 0 W/'
finish
