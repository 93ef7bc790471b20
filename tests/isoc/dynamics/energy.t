#!/bin/sh
# The account of energy, the outputs energy, power and balance, of every model, and of all effects of the library.
. tests/host/test.sh
begin dynamics_energy
one_isoc
quick

# with PATTERN FILE...: $with is a list of those that have a line like it, each between spaces.
with()
{
    with=" $(grep -l -- "$@" | tr '\n' ' ')"
}
with '^ *loss = ' models/effects/*.scene
lossy=$with
scenes="$(echo models/*.scene) tests/isoc/effects/all.scene"
# shellcheck disable=SC2086
with '^stabilisation lagrangian' $scenes
singular=$with
# shellcheck disable=SC2086
with '^ *effect ' $scenes
cornered=$with
# shellcheck disable=SC2086
with '^close ' $scenes
looped=$with

EXTRA=-O1
program energy.o -c tests/isoc/dynamics/energy.c && program report.o -c tests/host/report.c
result $? 'the test builds'

# account SCENE NAME [OPTION...]: the program that closes the account of a scene.
account()
{
    text=$1
    name=$2
    shift 2
    case $text in
    /*) printf 'include "%s"\n' "$text" ;;
    *) printf 'include "%s/%s"\n' "$PWD" "$text" ;;
    esac >"$out/$name.scene"
    losses=0
    isoc "$out/effects" '' "$text" --effects
    while read -r effect effect_kind rest; do
        case $lossy in
        *"/$effect_kind.scene "*)
            echo "output account_loss$losses = loss of $effect" >>"$out/$name.scene"
            losses=$((losses + 1))
            ;;
        esac
    done <"$out/effects"
    printf 'output account_%s = %s\n' energy energy power power balance balance >>"$out/$name.scene"
    isoc "$out/$name.summary" "$out/told" "$out/$name.scene" -o "$out/$name" --real double --method rk4 --inputs held "$@" &&
        "$CC" $FLAGS $REAL_FLAG "$out/$name/plant.c" "$out/energy.o" "$out/report.o" -lm \
            -o "$out/$name/run"
}

# kind_of SCENE: in $kind what the test expects of its steps.
kind_of()
{
    kind=smooth shown=200
    case $cornered in
    *" $1 "*) kind=corners shown=2000 ;;
    esac
    case $singular in
    *" $1 "*) kind=singular shown=200 ;;
    esac
}

# closed NAME SCENE: four seconds of it, the squeezer half of one; of the ticks some hundred, where there are corners
# 2000. $half is half of its step, in seconds, $projected what the projection took of the energy, and that.
closed()
{
    kind_of "$2"
    seconds=4
    [ "$1" != squeezer ] || seconds=0.5
    awk -v seconds="$seconds" '$1 == "step" && $3 == "s" { printf "%d %s\n", seconds / $2 + 0.5, $2 / 2 }' "$out/$1.summary" >"$out/ticks"
    read -r ticks half <"$out/ticks"
    joined "$1" "$out/$1/run" "$kind" "$ticks" $((ticks / shown + 1)) "$losses"
    projected=
    while read -r hash word taken unit of energy rest; do
        [ "$hash $word $unit $of $rest" != '# projected J of J' ] || projected="$taken $energy"
    done <"$out/tap"
}

for scene in $scenes; do
    name=${scene##*/}
    name=${name%.scene}
    account "$scene" "$name"
    result $? "$name builds"
    closed "$name" "$scene"
    case $looped in
    *" $scene "*) ;;
    *) continue ;;
    esac
    # What the projection takes is of order h^5 in a tick: half the step leaves 1/32 in as many of them, or rounding.
    whole=$projected
    account "$scene" "$name" --step "${half}s" && closed "$name" "$scene"
    echo "$whole $projected" | awk '{ exit !(NF == 4 && ($3 < $1 / 16 || $3 < 1e-12 * $4)) }'
    result $? "$name: what the projection takes is $whole J, with half the step $projected J"
done

# A cable whose length is a state: what the winch gives is in the account, and is missed where the cable does not know
# its rate.
drum='effect drum { signal to m; state paid m = 6 m; rate paid = reel; let reel = (to - paid) / (0.2 s); output paid; output reel }
effect winder drum { to winch }'
cornered="$cornered$out/drum.scene "
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
    name=${1##*/}
    name=${name%.scene}_$2
    sed "$3" "models/effects/$2.scene" >"$out/effect.scene"
    sed "s|^include \"|include \"$PWD/${1%/*}/|" "$out/effect.scene" "$1" >"$out/$name.planted.scene"
    ! cmp -s "$out/effect.scene" "models/effects/$2.scene" &&
        account "$out/$name.planted.scene" "$name" && ! "$out/$name/run" corners 3000 7 "$losses" >"$out/tap" &&
        grep -q '^not ok 1 - balance' "$out/tap"
    result $? "found in $2: $3"
}
planted models/dc_motor_bench.scene dc_motor 's/effort on shaft = constant/effort on shaft = 1.000001 * constant/'
planted models/dc_motor_bench.scene friction 's/loss = -effort/loss = effort/'
grep -q '^not ok 2 - 2 losses give no energy' "$out/tap"
result $? 'found in friction: a loss that gives energy'
planted models/cart_pole_drive.scene stop 's|stiffness \* depth^2 / 2|stiffness * depth^2 / 3|'
planted tests/isoc/effects/all.scene cogging 's/(1 - cos(angle))/(1 - cos(angle)) * 1.001/'
planted models/arm_drive.scene flexible_gear 's|effort / ratio) / rotor|effort) / rotor|'
planted models/balancer.scene contact 's/ball = cross(arm, push)/ball = cross(push, arm)/'
planted models/crane.scene cable 's|tension / distance \* gap|1.000001 * tension / distance * gap|'
planted models/crane.scene cable 's/loss = (tension - stiffness \* stretch)/loss = (stiffness * stretch - tension)/'
planted models/quadrotor_sih.scene propeller 's/(0 N, 0 N, lift)/(0 N, 0 N, 1.00001 * lift)/'
planted models/quadrotor_sih.scene drag 's/loss = -dot(force, v)$/loss = 0 W/'
finish
