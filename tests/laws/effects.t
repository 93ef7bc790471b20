#!/bin/sh
# Random effects, ten in a scene, against an interpreter of their text: states, memories, their starts, the past of formulas,
# noise, functions of time, tables, comparisons, a tunable that changes, by euler, heun and rk4, in float and in double.
#
# usage: effects.t [all]. A scene by turns; with `all` ten.
. tests/host/test.sh
begin laws

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
    build/isoc "$out/effects.scene" -o "$out/plant" --real "$1" >"$out/summary" &&
        optimised -O0 && EXTRA="-I$out/plant" program show tests/laws/rows.c "$out/plant/plant.c" && "$out/show" 24 >"$out/rows"
}

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
