#!/bin/sh
# Closed loops near singular positions: no run gains or loses energy without a word. Loops that a seeded generator
# draws, in double and in float: either the energy stays within `bound` of it, or the run tells of a singular position;
# with `near hold` it stays in either case.
. tests/host/test.sh
. tests/host/project.sh
begin singular
one_isoc
project
seeds=40
seconds=5
quick

# What a run that tells nothing may lose in 5 s in double: rk4 loses up to 3e-4 of it in a passing in which the pivots
# change by a factor of 1.25 in a step, the most that is not told. The float adds its rounding, a few ulp of 1.0 in each
# of the steps at random: 5000^0.5 * 10 * 6e-8.
bound_double=1e-3
bound_float=1.05e-3
# With `near hold` the steps that are told lose nothing; those beside each of them, which are not, up to a part of 1e-4.
beside=1e-4

# built SCENE REAL STABILISATION: $out/run.
built()
{
    printf 'include "%s"\nstabilisation %s\n' "$PWD/$1" "$3" >"$out/built.scene" && real "$2" &&
        isoc "$out/built.summary" '' "$out/built.scene" -o "$out/built" --real "$2" ${formulation:+--formulation "$formulation"} &&
        program run tests/isoc/closure/singular/passing.c "$out/built/plant.c"
}

# passes SCENE REAL STABILISATION BOUND [EACH]: sets $change, $near_ticks, $guard, and $bounded: within or beyond.
# Succeeds where it is within the bound, and EACH for each of the ticks that are told.
passes()
{
    near_ticks=0
    guard=none
    built "$1" "$2" "$3" && "$out/run" $seconds "$4" ${5+"$5"} >"$out/passed" || return
    read -r change near_ticks guard bounded <"$out/passed"
    [ "$bounded" = within ]
}

# bound_of REAL: $bound.
bound_of()
{
    bound=$bound_double
    [ "$1" = double ] || bound=$bound_float
}

told=0
wrong=0
python3 tests/isoc/closure/singular/draw.py "$out" $seeds
for seed in $(seq 0 $((seeds - 1))); do
    for type in double float; do
        bound_of $type
        passes "$out/drawn_$seed.scene" $type projection $bound
        status=$?
        [ "$near_ticks" -eq 0 ] || told=$((told + 1))
        [ $status -eq 0 ] || wrong=$((wrong + 1))
        [ $status -eq 0 ] || [ "$near_ticks" -gt 0 ]
        result $? "seed $seed, $type: energy within $change, $near_ticks ticks near a singular position"
        if [ "$near_ticks" -gt 0 ]; then
            passes "$out/drawn_$seed.scene" $type 'projection { near hold }' $bound $beside && [ "$guard" = good ]
            result $? "seed $seed, $type, near hold: energy within $change, $near_ticks ticks near a singular position"
        fi
    done
done
[ "$wrong" -gt 0 ] && [ "$told" -ge "$wrong" ]
result $? "control: without the watch $wrong of these runs are wrong without a word; $told are told of"

# The four-bar whose follower is 0.1 mm longer than its crank, at 1 ms; then in steps that resolve the passing.
near=tests/isoc/closure/singular/near_dead.scene
! passes $near double projection $bound_double && [ "$near_ticks" -gt 0 ]
result $? "control: near_dead loses $change of its energy; $near_ticks ticks near a singular position"
passes $near double 'projection { near hold }' 1e-5 && [ "$near_ticks" -gt 0 ]
result $? "near_dead, near hold: energy within $change"
sed 's/^step .*/&\nsubsteps 8/' $near >"$out/short.scene"
passes "$out/short.scene" double projection $bound_double && [ "$near_ticks" -eq 0 ]
result $? "near_dead with 8 sub-steps: $near_ticks ticks near a singular position, energy within $change"
passes $near double 'projection { near stop }' $bound_double && [ "$guard" = near ]
result $? "near_dead, near stop: the guard ends it, energy within $change till then"

# Through the singular position itself, in float: the parallelogram, and by the loop and its summary.
sed '/^stabilisation/d' models/parallelogram.scene >"$out/flat.scene"
isochron run "$PWD/$out/flat.scene" --seconds 5
value near_singular | grep -q '^[0-9]* from 0\.[0-9]* s in follower_pin$'
expect $? "parallelogram, projection: near_singular $(value near_singular)"
for stabilisation in 'projection { near hold }' lagrangian 'projection { near count }'; do
    built "$out/flat.scene" float "$stabilisation" && program starts tests/isoc/closure/singular/starts.c "$out/built/plant.c" &&
        finite=$("$out/starts" 20 25) && case $stabilisation in *count*) [ "$finite" -eq 0 ] ;; *) [ "$finite" -eq 25 ] ;; esac
    result $? "parallelogram, $stabilisation: $finite of 25 starts stay finite for 20 s$(case $stabilisation in *count*) echo ' (control)' ;; esac)"
done
echo 'stabilisation projection { near hold }' >>"$out/flat.scene"
sed 's/near hold/near stop/' "$out/flat.scene" >"$out/stop.scene"
! isochron run "$PWD/$out/stop.scene" --seconds 5 &&
    grep -q '^trace: guard at tick [0-9]*: near a singular position of closure follower_pin$' "$out/errors"
expect $? "parallelogram, near stop: $(grep -o 'guard at tick.*' "$out/errors")"

# Two mechanisms of another generator: a loop that gained 28 times its energy in 100 s without a word, and a tree with a
# gear, of many freedoms, in float.
for drawn in 'random_loop_5 double 100' 'random_tree_0 float 5' 'random_tree_0 double 5'; do
    set -- $drawn
    bound_of "$2"
    seconds=$3
    passes "tests/isoc/closure/singular/$1.scene" "$2" projection $bound || [ "$near_ticks" -gt 0 ]
    result $? "$1, $2, $3 s: energy within $change, $near_ticks ticks near a singular position"
done

# Legs that are eliminated one by one have one quantity that is watched, in the place of their pivots.
formulation=legs
for type in double float; do
    bound_of $type
    ! passes tests/isoc/closure/singular/two_legs.scene $type projection $bound && [ "$near_ticks" -gt 0 ]
    result $? "control: two_legs, $type, loses $change of its energy; $near_ticks ticks near a singular position"
    passes tests/isoc/closure/singular/two_legs.scene $type 'projection { near hold }' $bound $beside && [ "$near_ticks" -gt 0 ]
    result $? "two_legs, $type, near hold: energy within $change, $near_ticks ticks near a singular position"
    # Of twelve light fingers the product of all pivots would leave the range of float.
    passes tests/isoc/closure/singular/hand.scene $type projection $bound && [ "$near_ticks" -eq 0 ]
    result $? "hand, $type: energy within $change, $near_ticks ticks near a singular position"
done
formulation=

# Six pivots of closures of light or heavy bodies, whose product as it is would leave the range of float.
for mass in 1e-9 1 1e9; do
    sed "/^stabilisation/d; s/1 kg/$mass kg/" models/bricard.scene >"$out/scaled.scene"
    seconds=2
    passes "$out/scaled.scene" float lagrangian inf
    [ "$guard" = good ] && [ "$near_ticks" -eq 0 ]
    result $? "bricard of $mass kg, float: $near_ticks ticks near a singular position"
done

# The option may be left out of a block.
built $near double 'projection { iterations 2 }' && built $near double 'lagrangian { penalty 1e5 kg }'
result $? "blocks without near"

# What cannot be held is refused.
refused()
{
    ! isoc "$out/refused.summary" "$out/refused.errors" "$1" -o "$out/refused" && grep -q "$2" "$out/refused.errors"
    result $? "refused: $2"
}
sed '/^method/d; $a method ab4\nstabilisation projection { near hold }' $near >"$out/history.scene"
refused "$out/history.scene" 'near hold needs a method without a history'
{ cat tests/core/methods/compensated/driven.scene && echo 'stabilisation projection { near hold }'; } >"$out/motion.scene"
refused "$out/motion.scene" "near hold needs closures that do no work: 'drive' is a motion"
{ cat $near && echo 'stabilisation lagrangian { omega 10 Hz; near stop }'; } >"$out/drawn_in.scene"
refused "$out/drawn_in.scene" 'only a projection watches for singular positions'

# Far from singular positions nothing is told.
python3 tests/isoc/closure/singular/draw.py "$out" 3 0.3
for seed in 0 1 2; do
    passes "$out/drawn_$seed.scene" double projection $bound_double && [ "$near_ticks" -eq 0 ]
    result $? "control: kind $seed, 0.3 m from a singular position: $near_ticks ticks near one, energy within $change"
done
finish
