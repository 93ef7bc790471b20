#!/bin/sh
# make compare: what it prints of two runs is what awk computes from their tables, and runs that cannot be compared are
# refused with a reason.
. tests/host/test.sh
. tests/host/project.sh
begin link/compare
project

call run SCENE=models/pendulum.scene SECONDS=0.5 KEEP=a && [ "$(value ticks)" = 500 ]
expect $? "make run KEEP=a prints the summary"
runs=$out/project/build/runs
cmp -s "$runs/a/trace.csv" "$out/project/build/host/float/pendulum/trace.csv" && sed -n "/^scene /,\$p" "$out/output" | cmp -s - "$runs/a/summary.txt" &&
    [ -s "$runs/a/units.csv" ]
result $? "and keeps it in build/runs/a"
call run SCENE=models/pendulum.scene SECONDS=1 STEP=2ms METHOD=heun KEEP=b-2.5_ms
expect $? "make run KEEP=b-2.5_ms, with twice the step"

call compare RUNS='a b-2.5_ms'
expect $? "make compare"
head -n 1 "$out/output" | grep -qx 'a - b-2.5_ms at 251 times, from 0 to 0.5 s'
expect $? "it compares at the times that both have"
# Every second row of a against the same row of b. A number of six digits is wrong by 5e-6 of it at most.
awk -F, -v columns="$(head -n 1 "$runs/a/trace.csv")" '
    FNR == 1 { file++; next }
    file == 1 && FNR % 2 == 0 { for (i = 2; i <= NF; i++) a[FNR / 2 + 1, i] = $i }
    file == 2 && (FNR, 2) in a {
        n++
        for (i = 2; i <= NF; i++) {
            d = a[FNR, i] - $i
            squares[i] += d * d
            if ((d < 0 ? -d : d) > (most[i] < 0 ? -most[i] : most[i])) { most[i] = d; at[i] = $1 }
        }
    }
    END { split(columns, name, ","); for (i = 2; (i in name); i++) print name[i], sqrt(squares[i] / n), most[i] + 0, at[i] + 0 }
' "$runs/a/trace.csv" "$runs/b-2.5_ms/trace.csv" >"$out/wanted"
sed -n '3,/^build/p' "$out/output" | awk '!/^build/ { print $1, $(NF - 2), $(NF - 1), $NF }' | paste -d ' ' - "$out/wanted" |
    awk '{ if ($1 != $5 || ($2 - $6) ^ 2 > (5e-6 * $6) ^ 2 || ($3 - $7) ^ 2 > (5e-6 * $7) ^ 2 || $4 != $8) exit 1 }
        END { exit NR != 6 }'
expect $? "rms, largest and its time of all six outputs are those that awk finds"
grep -c '^plot ' "$out/project/build/compare/a-b-2.5_ms.gnuplot" | grep -qx 6 &&
    [ -s "$out/project/build/compare/a-b-2.5_ms.svg" ] && [ -s "$out/project/build/compare/a-b-2.5_ms.png" ]
expect $? "the picture has a panel for each"

# One number that is changed is the largest difference of its output, and the only one.
cp -r "$runs/a" "$runs/changed"
awk -F, -v OFS=, 'FNR == 102 { $2 += 0.25 } { print }' "$runs/a/trace.csv" >"$runs/changed/trace.csv"
call compare RUNS='changed a' && awk '$1 == "theta" { found = $(NF - 1) == 0.25 && $NF == 0.1 } NR > 2 && !/^build/ && $1 != "theta" &&
    ($(NF - 1) != 0 || $(NF - 2) != 0) { other = 1 } END { exit !(found && !other) }' "$out/output"
expect $? "found: one number that differs"

# told TEXT ARGUMENT...: fails, and says TEXT.
told()
{
    text=$1
    shift
    ! call "$@" && grep -qF -- "$text" "$out/errors"
    expect $? "told, with '$text': make $*"
}
call run SCENE=models/oscillator.c SECONDS=0.1 KEEP=other
sed '1s/.*/t,one,two/; 1!s/,.*/,1,2/' "$runs/a/trace.csv" >"$runs/other/trace.csv"
told "a and other have no output in common" compare RUNS='a other'
cp -r "$runs/a" "$runs/degrees"
sed -i '2s/rad,/deg,/' "$runs/degrees/units.csv"
told "theta is in 'rad' in a, and in 'deg' in degrees" compare RUNS='a degrees'
cp -r "$runs/a" "$runs/odd"
awk -F, -v OFS=, 'FNR > 1 { $1 *= 0.9973 } { print }' "$runs/a/trace.csv" >"$runs/odd/trace.csv"
told "they have no time in common but the start" compare RUNS='a odd'
told "are not two runs" compare RUNS=a
told "are not two runs" compare
told "there is no run absent" compare RUNS='a absent'
told "is no name for a run" run KEEP=../a
told "KEEP has no effect on" plot KEEP=a
finish
