#!/bin/sh
# Generated plants of mechanisms with loops and joints of several freedoms against the independent dynamics.
. tests/host/test.sh
begin mechanism
. tests/dynamics/solver.sh

# scene_of NAME: its file.
scene_of()
{
    for folder in models tests/mechanism; do
        [ ! -f "$folder/$1.scene" ] || echo "$folder/$1.scene"
    done
}

# pure NAME: compiles the scene without what is added to the equations of motion to hold the closures, which would act on the
# rounding of the states.
pure()
{
    mkdir -p "$out/$1"
    sed -e 's/^stabilisation \(baumgarte\|projection\)$/stabilisation none/' \
        -e 's/^stabilisation lagrangian$/stabilisation lagrangian { omega 1 mHz }/' \
        "$(scene_of "$1")" >"$out/$1/$1.scene"
    build/isoc "$out/$1/$1.scene" -o "$out/$1" --real "$real" >"$out/$1/summary" && [ -s "$out/$1/plant.c" ]
}

# against_table NAME: the plant against the table of that name.
against_table()
{
    # shellcheck disable=SC2086
    pure "$1" && program "$1.compare" "tests/mechanism/table_$1.c" "$out/$1/plant.c" $compare
    result $? "$1 builds in $real"
    joined "$1 in $real" "$out/$1.compare"
}

for real in float double; do
    real $real
    compare
    for name in ball_chain satellite stage four_bar slider_crank squeezer bricard stewart; do
        against_table $name
    done
done
finish
