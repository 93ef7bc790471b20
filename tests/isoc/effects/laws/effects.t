#!/bin/sh
# Random effects, ten in a scene, against an interpreter of their text: states, memories, their starts, the past of
# formulas, noise, functions of time, tables, comparisons, a tunable that changes, by euler, heun and rk4, in float and
# in double.
. tests/host/test.sh
begin laws
one_isoc
quick

# written: the scene $seed.
written()
{
    python3 -B tests/isoc/effects/laws/effects.py write "$seed" "$out/effects.scene"
}

# compare REAL ROWS [PLANTED]: the numbers of the scene $seed against the interpreter's.
compare()
{
    python3 -B tests/isoc/effects/laws/effects.py compare "$seed" "$@"
}

# rows REAL: those of the plant of the scene that was written last.
rows()
{
    real "$1"
    rm -f "$out/rows"
    isoc "$out/summary" '' "$out/effects.scene" -o "$out/plant" --real "$1" &&
        EXTRA="-I$out/plant" program show tests/isoc/effects/laws/rows.c "$out/plant/plant.c" && "$out/show" 24 >"$out/rows"
}

# sets_each PLANT: each derivative of a state once.
sets_each()
{
    states=$(awk '$1 == "states" { print $2 }' "$out/summary")
    grep -o 'dx\[[A-Z0-9_]*\] = ' "$1" | sort | uniq -c | awk -v states="$states" '$1 != 1 { bad = 1 } END { exit bad || NR != states }'
}

for seed in 0 1 2 3 4 5 6 7 8 9; do
    written
    for number in float double; do
        rows $number && compare $number "$out/rows"
        result $? "$number: ten random effects of seed $seed are what their text says"
    done
    sets_each "$out/plant/plant.c"
    result $? "seed $seed: each derivative is set once"
done
sed '0,/dx\[[A-Z0-9_]*\] = /{//d}' "$out/plant/plant.c" >"$out/one_less.c"
sed '0,/dx\[[A-Z0-9_]*\] = /{//p}' "$out/plant/plant.c" >"$out/one_twice.c"
! sets_each "$out/one_less.c" && ! sets_each "$out/one_twice.c"
result $? "found: a derivative that is left out, and one that is set twice"

# A scene that has all of these, against an interpreter with a defect.
seed=1
written
rows double
for planted in previous delay sample next noise; do
    compare double "$out/rows" $planted >"$out/found"
    [ $? -eq 1 ] && grep -q ' [1-9][0-9]* off$' "$out/found"
    result $? "found: another meaning of $planted, $(sed -n 's/.*decided, //p' "$out/found")"
done
finish
