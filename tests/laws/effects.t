#!/bin/sh
# Random effects, ten in a scene, against an interpreter of their text: states, memories, their starts, the past of formulas,
# noise, functions of time, tables, comparisons, a tunable that changes, by euler, heun and rk4, in float and in double.
#
# usage: effects.t [all]. The numbers of a scene by turns; with `all` of ten.
. tests/host/test.sh
begin laws
one_isoc

# compare REAL ROWS [PLANTED]: the numbers of the scene $seed against the interpreter's.
compare()
{
    python3 -B tests/laws/effects.py compare "$seed" "$@"
}

# rows REAL: those of the plant of the scene $seed.
rows()
{
    real "$1"
    rm -f "$out/rows"
    python3 -B tests/laws/effects.py write "$seed" "$out/effects.scene"
    isoc "$out/summary" '' "$out/effects.scene" -o "$out/plant" --real "$1" &&
        optimised -O0 && EXTRA="-I$out/plant" program show tests/laws/rows.c "$out/plant/plant.c" && "$out/show" 24 >"$out/rows"
}

# sets_each PLANT: each derivative of a state once.
sets_each()
{
    states=$(awk '$1 == "states" { print $2 }' "$out/summary")
    grep -o 'dx\[[A-Z0-9_]*\] = ' "$1" | sort | uniq -c | awk -v states="$states" '$1 != 1 { bad = 1 } END { exit bad || NR != states }'
}

for seed in 0 1 2 3 4 5 6 7 8 9; do
    python3 -B tests/laws/effects.py write "$seed" "$out/effects.scene"
    isoc "$out/summary" '' "$out/effects.scene" -o "$out/plant" && sets_each "$out/plant/plant.c"
    result $? "seed $seed: each derivative is set once"
done
sed '0,/dx\[[A-Z0-9_]*\] = /{//d}' "$out/plant/plant.c" >"$out/one_less.c"
sed '0,/dx\[[A-Z0-9_]*\] = /{//p}' "$out/plant/plant.c" >"$out/one_twice.c"
! sets_each "$out/one_less.c" && ! sets_each "$out/one_twice.c"
result $? "found: a derivative that is left out, and one that is set twice"

turn=$(turn_of 10 "${1-}" core tools/isoc)
echo "# effects: turn $turn of 10"
for seed in 0 1 2 3 4 5 6 7 8 9; do
    case $turn in
    all | "$seed") ;;
    *) continue ;;
    esac
    for number in float double; do
        rows $number && compare $number "$out/rows"
        result $? "$number: ten random effects of seed $seed are what their text says"
    done
done

# A scene that has all of these, against an interpreter with a defect.
seed=1
rows double
for planted in previous delay sample next noise; do
    compare double "$out/rows" $planted >"$out/found"
    [ $? -eq 1 ] && grep -q ' [1-9][0-9]* off$' "$out/found"
    result $? "found: another meaning of $planted, $(sed -n 's/.*decided, //p' "$out/found")"
done
finish
