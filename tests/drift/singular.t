#!/bin/sh
# Mechanisms whose closures lose rank, in float for 20 s, with the augmented Lagrangian as it is by itself: their energy,
# which nothing takes, stays within 0.1 %. With multipliers alone the parallelogram is torn where its rods lie on one line:
# then its energy goes, or the guard stops it.
. tests/host/test.sh
. tests/host/project.sh
begin drift/singular
project
. tools/drift/common.sh

# swing MODEL STABILISATION: runs the model so; $csv is then the table.
swing()
{
    SCENE=models/$1.scene
    stabilised "$2" >"$out/$1-$2.scene"
    call run SCENE="$PWD/$out/$1-$2.scene" SECONDS=20
    status=$?
    csv=$out/project/$(value trace)
    return $status
}

# column NAME: which one of the table it is.
column()
{
    head -n 1 "$csv" | tr , '\n' | grep -nx "$1" | cut -d : -f 1
}

# kept: whether the energy stays within 0.1 % of the first row's. Prints by what part it changes.
kept()
{
    awk -F, -v e="$(column energy)" '
        NR == 2 { first = $e }
        NR > 1 { change = ($e / first - 1) ^ 2; most = change > most ? change : most; n++ }
        END { printf "%.1e\n", sqrt(most); exit !(n == 20001 && sqrt(most) <= 0.001) }' "$csv"
}

# passes ANGLE: how often the angle, in rad, goes through a multiple of pi.
passes()
{
    awk -F, -v a="$(column "$1")" 'function half(x) { x /= 3.14159265358979; return x < 0 ? int(x) - 1 : int(x) }
        NR > 2 && half($a) != last { n++ }
        NR > 1 { last = half($a) }
        END { print n + 0 }' "$csv"
}

for model in parallelogram:crank_angle n_four_bar:angle; do
    angle=${model#*:}
    model=${model%:*}
    swing $model lagrangian && change=$(kept) && [ "$(passes $angle)" -ge 10 ]
    expect $? "$model passes $(passes $angle) times where its rods lie on one line: energy within $change"
    for stabilisation in baumgarte projection; do
        if swing $model $stabilisation; then
            ! change=$(kept) && told="energy within $change"
        else
            told=$(grep -Eo 'guard state .* it is (not finite|out of range)$' "$out/errors")
        fi
        expect $? "control: $model, $stabilisation: $told"
    done
done

# Five equations of rank four wherever it is; its rods turn from one end to the other.
swing bricard lagrangian && change=$(kept) &&
    awk -F, -v y="$(column p4_y)" 'NR > 1 { low = $y < low ? $y : low; high = $y > high ? $y : high }
        END { exit !(high - low > 1) }' "$csv"
expect $? "bricard moves: energy within $change"
! swing bricard baumgarte && grep -q 'rank 4 of 5' "$out/errors"
expect $? "control: bricard, baumgarte: refused"
finish
