#!/bin/sh
# FMUs for model exchange, by an importer of the project's own (exchange.py): its steps end where those of the plant
# end; directional derivatives are central differences, and those of isoc --linear; calls that are wrong. A scene of
# functions of time, one of slides alone, in float, a closed loop, and twenty random ones. What has no such equations is
# refused, by its line.
. tests/host/test.sh
begin exchange
one_isoc
optimised -O0
seeds=$(seq 20)
with_warnings="$CC ${FLAGS% -I.}"

# exported NAME SCENE [OPTION...]: its FMU in $out/NAME.fmu, compiled by $compiler.
compiler=$with_warnings
exported()
{
    name=$1
    scene=$2
    shift 2
    folder=$out/$name/binaries/$(uname -m)-linux
    mkdir -p "$folder"
    # shellcheck disable=SC2086
    isoc "$out/summary" "$out/said" "$scene" -o "$out/$name/sources" --fmu --real "$real" "$@" &&
        identifier=$(sed -n '/.* modelIdentifier="\([^"]*\)".*/{s//\1/p;q}' "$out/$name/sources/modelDescription.xml") &&
        (cd "$out/$name/sources" && $compiler -DFMI3_OVERRIDE_FUNCTION_PREFIX -fPIC -shared -fvisibility=hidden ./*.c \
            -o "../binaries/$(uname -m)-linux/$identifier.so") &&
        python3 -B tools/fmu/pack.py "$out/$name" "$out/$name.fmu"
}

# tried NAME SCENE MATRICES [OPTION...]: likewise, for exchange.py.
list=
tried()
{
    tried_matrices=$3
    list="$list $out/$1.fmu $tried_matrices"
    tried_name=$1
    tried_scene=$2
    shift 3
    exported "$tried_name" "$tried_scene" --exchange "$@"
}

scenes=$out/scenes
mkdir -p "$scenes"
echo 'stabilisation baumgarte' | cat - models/four_bar.scene >"$scenes/four_bar.scene"
# shellcheck disable=SC2086
python3 -B tests/isoc/linear/write_scene.py "$scenes" $seeds
good=0
isoc "$out/summary" '' models/crane.scene -o "$out/linear" --linear && tried crane models/crane.scene "$out/linear/matrices.tsv" &&
    tried euler models/double_pendulum.scene - --method euler && tried loop "$scenes/four_bar.scene" - || good=1
compiler="tcc $quick_flags"
for seed in $seeds; do
    # Every fourth one is a closed loop.
    echo 'stabilisation baumgarte' >>"$scenes/$seed.scene"
    tried "$seed" "$scenes/$seed.scene" - || good=1
done
compiler=$with_warnings
real float
tried car models/quarter_car.scene - || good=1
result $good "FMUs of 20 random scenes are built, and others with all warnings"
# shellcheck disable=SC2086
joined importer python3 -B tests/tools/fmu/exchange.py $list
joined states python3 -B tests/tools/fmu/exchange_states.py "$out/loop.fmu" "$out/crane.fmu" "$out/car.fmu"

# says WHAT: whether isoc said so of $where of the scene, first.
says()
{
    IFS= read -r said <"$out/said"
    case $said in
    "$scenes/refused.scene:$where: $1"*) ;;
    *) return 1 ;;
    esac
}

# refused WHERE WHAT LINE...: a scene of these lines has no model exchange, for this reason; and has co-simulation.
refused()
{
    where=$1
    what=$2
    shift 2
    printf '%s\n' 'step 1 ms' 'body b { mass 1 kg; com (1, 0, 0) m; inertia (1, 1, 1) kg*m^2 }' \
        'joint j revolute { parent ground; child b; axis z; continuous }' 'output q = position of j' "$@" >"$scenes/refused.scene"
    ! isoc "$out/summary" "$out/said" "$scenes/refused.scene" -o "$out/refused" --fmu --exchange &&
        [ ! -d "$out/refused" ] && says "error: no model exchange: $what" &&
        isoc "$out/summary" "$out/said" "$scenes/refused.scene" -o "$out/alone" --fmu &&
        says "warning: no model exchange, co-simulation alone: $what"
    result $? "refused: $what"
}
refused 5:12 "this previous is a value of an earlier tick; take a state" 'output o = previous(speed of j)'
refused 5:12 "this delay is a value of an earlier tick; take a state" 'output o = delay(speed of j, 10 ms)'
refused 5:12 "this sample is taken at ticks; take a state" 'output o = sample(speed of j, every 10 ms)'
refused 5:8 "the output 'e' is of a step of the method; leave it out" 'output e = local_error'
refused 5:8 "the output 'v' is of every 4th tick; leave out 'every'" 'output v = speed of j every 4 ticks'
refused 5:8 "the output 'g' counts turns at the end of each step; leave it out" 'output g = turns of j'
refused 10:8 "the memory 'hold_m' changes at ticks; take a state" \
    'effect holding {' '    memory m = 0' '    next m = m + 1' '    output o = m' '}' 'effect hold holding {}' 'output o = hold.o'
gear="joint k revolute { parent ground at (3, 0, 0) m; child c; axis z }
body c { mass 1 kg; inertia (1, 1, 1) kg*m^2 }
joint l revolute { parent ground at (6, 0, 0) m; child d; axis z; start 10 deg }
body d { mass 1 kg; inertia (1, 1, 1) kg*m^2 }"
refused 5:7 "the projection moves the states at the end of each step; take 'stabilisation baumgarte'" \
    'close g gear { first k; second l; ratio -2 }' "$gear"
refused 5:15 "the projection moves the states at the end of each step; take 'stabilisation lagrangian { omega ... }'" \
    'stabilisation lagrangian' 'close g gear { first k; second l; ratio -2 }' "$gear"

# What has co-simulation alone makes no instance for model exchange.
real double
exported alone "$scenes/refused.scene"
joined alone python3 -B tests/tools/fmu/exchange.py --alone "$out/alone.fmu"
finish
