#!/bin/sh
# Generated plants of mechanisms with loops and joints of several freedoms against the independent dynamics.
. tests/host/test.sh
begin mechanism
one_isoc
turn=$(turn_of 3 "${1-}")
echo "# turn $turn of the larger mechanisms"
optimised -O0
. tests/isoc/dynamics/solver.sh

# pure NAME: compiles the scene without what is added to the equations of motion to hold the closures, which would act
# on the rounding of the states.
pure()
{
    pure_scene=models/$1.scene
    [ -f "$pure_scene" ] || pure_scene=tests/isoc/mechanism/$1.scene
    sed -e 's/^stabilisation \(baumgarte\|projection\)$/stabilisation none/' \
        -e 's/^stabilisation lagrangian$/stabilisation lagrangian { omega 1 mHz }/' \
        "$pure_scene" >"$out/$1.scene"
    isoc "$out/summary" '' "$out/$1.scene" -o "$out/$1" --real "$real" && [ -s "$out/$1/plant.c" ]
}

# against_table NAME: the plant against the table of that name.
against_table()
{
    # shellcheck disable=SC2086
    pure "$1" && program "$1.compare" "tests/isoc/mechanism/table_$1.c" "$out/$1/plant.c" $compare
    result $? "$1 builds in $real"
    joined "$1 in $real" "$out/$1.compare"
}

for real in float double; do
    real $real
    compare
    for name in ball_chain satellite stage slot four_bar slider_crank; do
        against_table $name
    done
    # The larger ones take seconds, and show nothing in float that the others would not.
    [ $real = float ] || for name in squeezer bricard stewart; do
        ! next_turn 3 || against_table $name
    done
done
# folds STABILISATION LIMIT: in the real of now the parallelogram, which swings through the positions where its closure
# loses rank, folds: its cranks come apart by more than LIMIT (rad), or its energy changes by more than that part.
folds()
{
    sed "s/^stabilisation .*/stabilisation $1/" models/parallelogram.scene >"$out/swing.scene"
    isoc "$out/summary" '' "$out/swing.scene" -o "$out/swing" --real "$real" &&
        program swing.run tests/reference/columns.c "$out/swing/plant.c" &&
        "$out/swing.run" crank_angle follower_angle energy >"$out/swing.txt" || return 1
    told=$(awk -v limit="$2" '
        function size(x) { return x < 0 ? -x : x }
        NR == 1 { start = $3 }
        size($1 - $2) > apart { apart = size($1 - $2) }
        size($3 / start - 1) > energy { energy = size($3 / start - 1) }
        END { printf "%.1e rad apart, energy off by %.1e\n", apart, energy; exit !(NR == 50 && (apart > limit || energy > limit)) }
    ' "$out/swing.txt")
}

# The root of the rounding: so much of the closures is left where the penalty takes over.
for limit in float:3.5e-4 double:1.5e-8; do
    real ${limit%%:*}
    told=
    ! folds lagrangian "${limit#*:}" && [ -n "$told" ]
    result $? "parallelogram in $real: $told, at most ${limit#*:}"
    folds 'lagrangian { omega 1 Hz }' "${limit#*:}"
    result $? "control: held less, a parallelogram folds: $told"
done
finish
