#!/bin/sh
# Plants side by side have the bits of plants alone: isoc --lanes with -DISO_LANES, 4 to 32 lanes, by gcc and clang, in
# float and in double. Each lane has its own start, inputs that change, also to no number, tunables and faults, restarts
# of the method, and in some the guard ends it. Models, each with another method, and random scenes
# (tests/promises/random/write_scene.py), by turns; with `all` every model that is not large, and ten random scenes:
#
#     tests/isoc/emit/lanes/lanes.t all
. tests/host/test.sh
begin lanes
one_isoc
turn=$(turn_of 10 "${1-}")
echo "# turn $turn"
# Vectors of any width are compiled for any processor. What gcc says of calling conventions is of functions that it
# inlines.
FLAGS="$FLAGS -Wno-psabi"
$CC $FLAGS -c tests/isoc/emit/lanes/compare.c -o "$out/compare.o" || exit 1

# side_by_side SCENE METHOD REAL LANES COMPILER TICKS: the program that compares; $planted changes its plant in lanes.
side_by_side()
{
    real "$3"
    isoc "$out/summary" "$out/errors" "$1" -o "$out/plant" --method "$2" --real "$3" --lanes || return
    cp "$out/plant/plant.c" "$out/plant/lanes.c"
    [ -z "${planted-}" ] || sed -i "$planted" "$out/plant/lanes.c"
    # shellcheck disable=SC2086
    (FLAGS=$(echo "$FLAGS" | sed 's/ -O2 / -O0 /') &&
        "$5" $FLAGS $REAL_FLAG -DPLANT="\"$out/plant/plant.c\"" -c tests/isoc/emit/lanes/run.c -o "$out/alone.o" &&
        "$5" $FLAGS $REAL_FLAG -DISO_LANES="$4" -DPLANT="\"$out/plant/lanes.c\"" -c tests/isoc/emit/lanes/run.c -o "$out/lanes.o" &&
        "$CC" "$out/compare.o" "$out/alone.o" "$out/lanes.o" -o "$out/compare") || return
    "$out/compare" "$4" "$6" >"$out/said"
}

# lanes SCENE METHOD REAL LANES COMPILER TICKS
lanes()
{
    side_by_side "$@"
    status=$?
    [ $status -eq 0 ] || sed 's/^/# /' "$out/errors" "$out/said"
    result $status "$(basename "$1" .scene), $2, $3, $4 lanes, $5: $(tail -n 1 "$out/said")"
}

# Every kind of thing that a lane has for itself happens in these.
lanes models/cart_pole_drive.scene abm4 float 16 gcc 600
grep -q 'restarts [1-9].*stopped [1-9]' "$out/said"
result $? "lanes restarted, and lanes were stopped"
lanes tests/isoc/effects/all.scene rk4 double 8 clang 400
grep -q 'restarts [1-9].*stopped [1-9].*held [1-9]' "$out/said"
result $? "lanes restarted, lanes were stopped, and inputs were held"

# The energy that is held near a singular position.
{ cat tests/isoc/closure/singular/near_dead.scene && echo 'stabilisation projection { near hold }'; } >"$out/near_hold.scene"
lanes "$out/near_hold.scene" rk4 float 8 gcc 400
grep -q 'stopped [1-9].*near [1-9]' "$out/said"
result $? "lanes came near a singular position, after others were stopped"

# Events in lanes, each at its own time.
lanes tests/isoc/events/events.scene rk4 float 16 gcc 600
lanes tests/isoc/events/events.scene heun double 4 clang 300
lanes tests/isoc/events/holds.scene rk4 float 8 gcc 400

# A step that is made again, in the lanes where its error leaps, as the cart meets the wall.
cat >"$out/wall.scene" <<'END'
step 1 ms
checked yes
body cart { mass 1 kg }
joint rail prismatic { parent ground; child cart; axis x; speed 1 m/s }
effect wall { joint along; effort on along = -10 kN/m * max(position of along - 0.1 m, 0) }
effect hit wall { along rail }
output place = position of rail
END
lanes "$out/wall.scene" ab4 double 8 gcc 400
grep -q 'restarts [1-9]' "$out/said"
result $? "lanes made steps again"

# The other models, each with a method, a number type and a compiler.
number=0
while read -r scene method; do
    number=$((number + 1))
    real=float compiler=gcc
    [ $((number % 2)) -ne 0 ] || real=double
    [ $((number % 3)) -ne 0 ] || compiler=clang
    ! next_turn 10 || lanes "models/$scene.scene" "$method" $real 4 $compiler 200
done <<END
arm6 abm4
arm_drive euler
balancer bdf4
bricard ab4
cart_pole rosenbrock
crane heun
dc_motor_bench abm4_pecece
double_pendulum rk4
four_bar abm4_pec
gyroscope semi_implicit
hopper bdf4
n_four_bar ab4
parallelogram rosenbrock
pendulum semi_implicit
pump heun
quadrotor abm4_pecece
quadrotor_sih rk4
quarter_car abm4
rigid_body euler
slider_crank bdf4
squeezer ab4
top rosenbrock
tree semi_implicit
END
seeds=1 first=$turn
[ "$turn" != all ] || seeds=10 first=0
for seed in $(seq "$first" $((first + seeds - 1))); do
    python3 tests/promises/random/write_scene.py "$seed" >"$out/random_$seed.scene"
    lanes "$out/random_$seed.scene" "$(sed -n 's/^method //p' "$out/random_$seed.scene")" float 32 gcc 200
done

# Controls: one lane of many that computes with another number, and one whose restart is that of all.
planted='/^static void derivative_by_sines(/,/^}/s/^    dx\[.*DRIVE_CURRENT\] = .*/&\n    dx[PLANT_X_DRIVE_CURRENT][5] *= 1.000001f;/'
! side_by_side models/cart_pole_drive.scene rk4 float 16 gcc 20 && grep -q '^# lane 5' "$out/said" &&
    [ "$(grep -c '^# lane' "$out/said")" -eq 1 ]
result $? "found: lane 5 of 16 with another derivative"
planted='/^static iso_flag discontinuity(/,/^}/s/return found;/return iso_mask_where(iso_any(found));/'
! side_by_side models/cart_pole_drive.scene abm4 float 4 gcc 100
result $? "found: a restart of one lane is one of all"
planted=

# A folder that compiles alone, with flags that say nothing of fused products.
isoc "$out/summary" '' models/cart_pole.scene -o "$out/alone" --name cart --standalone --lanes &&
    (cd "$out/alone" && $CC -std=c11 -O2 -Wall -Wextra -Wpedantic -Werror -Wno-psabi -fno-math-errno -DISO_LANES=16 -I. -c cart.c -o cart.o)
result $? "lanes in a folder that compiles alone"

# What has no lanes.
refused()
{
    ! isoc "$out/summary" "$out/errors" "$@" --lanes -o "$out/refused" && [ ! -d "$out/refused" ]
}
refused models/pendulum.scene --method adams && grep -q 'each plant with adams' "$out/errors"
result $? "refused: adams, by its name"
sed 's/^step .*/&\noverrun degrade { method euler; after 10 ticks }/' models/pendulum.scene >"$out/degrade.scene"
refused "$out/degrade.scene" && grep -q 'overrun is for the loop' "$out/errors"
result $? "refused: a method that changes in one plant alone"
refused models/cart_pole.scene --link && grep -q 'leave out --lanes' "$out/errors"
result $? "refused: a link"
isoc "$out/summary" '' models/pendulum.scene -o "$out/plant" --lanes &&
    ! $CC $FLAGS -DISO_LANES=5 -fsyntax-only "$out/plant/plant.c" 2>"$out/errors" && grep -q 'ISO_LANES is 2, 4, 8' "$out/errors"
result $? "refused: five lanes"

# The text with --lanes, compiled without, is the plant alone.
same=0
for scene in double_pendulum four_bar; do
    for option in "" --lanes; do
        # shellcheck disable=SC2086
        isoc "$out/summary" '' models/$scene.scene -o "$out/plant" --method abm4 $option &&
            "$CC" $FLAGS -c "$out/plant/plant.c" -o "$out/same$option.o" || same=1
    done
    cmp "$out/same.o" "$out/same--lanes.o" || same=1
done
result $same "compiled without lanes, both texts of a plant are the same to the last byte"
finish
