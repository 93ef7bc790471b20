#!/bin/sh
# make report and make bench: the tables are whole, errors fall with the methods' orders, what runs with any step is
# what make run runs, a reference that two methods do not agree on is refused. Wrong references and tables are seen.
. tests/host/test.sh
. tests/host/project.sh
begin check/report
project
methods="euler heun rk4 rosenbrock"
folder=$out/project/build/report/double_pendulum
tsv=$folder/report.tsv

# whole TSV: a line for each kind, method and step, each with an error above zero, and instructions per second that are
# those of a step over the step; compensated sums take more of them than plain ones.
whole()
{
    awk -F '\t' -v methods="$methods" '
        NR > 1 {
            n[$1, $2]++
            step[$1, $2] = $7
            if (NF != 8 || !($5 > 0) || $8 < 0.999 * $7 / $3 || $8 > 1.001 * $7 / $3) bad = 1
        }
        END {
            count = split(methods, method, " ")
            for (m = 1; m <= count; m++) {
                if (n["float", method[m]] != 6 || n["compensated", method[m]] != 6 || n["double", method[m]] != 6) bad = 1
                if (step["compensated", method[m]] <= step["float", method[m]]) bad = 1
            }
            exit bad || NR != 1 + 18 * count
        }' "$1"
}

# ordered TSV METHODS_TABLE: in double the last two orders observed of every method are those of the table, within 0.1.
# The error is C h^p (1 + D h): an observed order is p + D h / (2 ln 2), with D at most 200 / s (euler, from its orders
# 1.24 at 2 ms to 1.03 at 0.125 ms) at most 0.07 off at 0.25 ms. All lie a hundred times above what the reference is
# sure of, or are not told.
ordered()
{
    awk -F '\t' '
        FNR == NR { split($0, cell, " *[|] *"); order[cell[2]] = cell[3]; next }
        $1 == "double" && $6 != "-" { before[$2] = last[$2]; last[$2] = $6; seen[$2] = 1 }
        END {
            for (method in seen) {
                count++
                for (i = 1; i <= 2; i++) {
                    off = (i == 1 ? before[method] : last[method]) - order[method]
                    if (off > 0.1 || off < -0.1) bad = 1
                }
            }
            exit bad || count != 4
        }' "$2" "$1"
}

call report METHODS="$methods"
expect $? "make report"
for file in report.txt report.tsv work_precision.svg work_precision.png; do
    [ -s "$folder/$file" ] && grep -qx "build/report/double_pendulum/$file" "$out/output"
    result $? "$file is there, and named"
done
whole "$tsv"
result $? "the table has every kind, method and step"
build/isoc --methods >"$out/methods.md"
ordered "$tsv" "$out/methods.md"
result $? "errors fall with the order of the method"
grep -Ev '^  (CC|LINK) ' "$out/output" | head -n "$(grep -c '' "$folder/report.txt")" | cmp -s - "$folder/report.txt"
result $? "report.txt is what is printed"
[ "$(wc -c <"$folder/work_precision.svg")" -lt 100000 ]
result $? "the picture is smaller than 100 kB"
for text in $methods 'double_pendulum: error and its price' 'float, compensated sums' 'step, ms'; do
    grep -qF "$text" "$folder/work_precision.svg"
    result $? "the picture says: $text"
done

# same POINTS UNIT: the state that make run printed is that of the report after 5000 steps. A number is printed as the
# shortest decimal that reads back: within half a unit in the last place.
same()
{
    sed -n 's/^state //p' "$out/output" | tr ' ' '\n' >"$out/state"
    awk '$1 == 5000 { for (i = 3; i <= NF; i++) printf "%.17g\n", $i }' "$folder/$1/points" >"$out/driven"
    awk -v unit="$2" '
        FNR == NR { a[FNR] = $1; next }
        { n++; off = a[FNR] - $1; size = $1 < 0 ? -$1 : $1; if ((off < 0 ? -off : off) > unit / 2 * size) bad = 1 }
        END { exit bad || n != 4 }' "$out/state" "$out/driven"
}

# The program with any step is the one that make run runs.
call run REAL=double SECONDS=5
expect $? "make run in double"
same double-rk4 2.3e-16
result $? "the state is that of make run, in double"
call run SECONDS=5
same float-rk4 1.2e-7
result $? "the state is that of make run, in float"

# A step takes the same instructions whatever it is and however many there are.
for arguments in "STEP=4ms SECONDS=0.1" "STEP=125us SECONDS=0.05"; do
    # shellcheck disable=SC2086
    call run TARGET=cortex-m4f METHOD=heun $arguments
    [ "$(value instructions_per_step)" = "$(cat "$folder/float-heun/instructions")" ]
    expect $? "a step of heun takes as many instructions with $arguments"
done

# wrong NAME TSV [METHODS_TABLE]: the table is found wrong.
wrong()
{
    ! { whole "$2" && ordered "$2" "${3:-$out/methods.md}"; }
    result $? "found: $1"
}

sed '20d' "$tsv" >"$out/wrong.tsv"
wrong "a row left out" "$out/wrong.tsv"
awk -F '\t' '$2 != "heun"' "$tsv" >"$out/wrong.tsv"
wrong "a method left out" "$out/wrong.tsv"
sed 's/^| rk4 | 4/| rk4 | 3/' "$out/methods.md" >"$out/wrong.md"
wrong "a wrong order in the table of methods" "$tsv" "$out/wrong.md"
awk '{ $3 += 1e-8; print }' OFMT=%.17g CONVFMT=%.17g "$folder/reference.txt" >"$out/wrong.txt"
awk -f tools/report/errors.awk part=reference "$out/wrong.txt" part=points "$folder/measured.txt" >"$out/wrong.tsv"
wrong "a reference that is wrong by 1e-8" "$out/wrong.tsv"
awk '{ print "9", $0 }' "$folder/reference.txt" >"$out/wrong.txt"
! awk -f tools/report/errors.awk part=reference "$out/wrong.txt" part=points "$folder/measured.txt" >"$out/wrong.tsv" 2>/dev/null
result $? "found: a point without a reference"

# agreed LINE LINE: whether two states are the same to 1e-12.
agreed()
{
    printf '%s\n' "$@" | awk -v time=5 -v tolerance=1e-12 -f tools/report/agree.awk >"$out/agreed"
}

agreed '9 5 1 2' '9 5 1.000000000001 2' && [ "$(cut -d ' ' -f 1,3- "$out/agreed")" = '5 1 2' ]
result $? "two states that differ by 1e-12 agree"
! agreed '9 5 1 2' '9 5 1.00000000001 2'
result $? "found: two that differ by 1e-11"
! agreed '9 5 1 nan' '9 5 1 nan'
result $? "found: two that are no numbers"
! agreed '9 5 1 2'
result $? "found: one alone"
! call report METHODS=rk4 SECONDS=40 && grep -q 'no reference for double_pendulum after 40 s' "$out/errors"
expect $? "found: a time for which the motion is chaotic"
! call report SCENE=models/absent.scene && grep -q 'there is no scene models/absent.scene' "$out/errors"
expect $? "found: a scene that is not there"
! call report METHODS="rk4 adams" && grep -q 'adams chooses its steps itself' "$out/errors"
expect $? "found: a method whose step is not fixed"

# A plant in C, another step, and inputs.
call report SCENE=models/oscillator.c METHODS="ab4 bdf4" STEP=2ms SECONDS=2
expect $? "make report of a plant in C"
call report SCENE=models/cart_pole.scene METHODS=rk4 SECONDS=1
expect $? "make report of a scene with an input"

# The bench: its largest step is the largest.
call bench METHODS="rk4 ab4 abm4"
expect $? "make bench"
[ "$(grep -c '^| \(rk4\|ab4\|abm4\) | 4 |' "$out/output")" -eq 3 ] && [ "$(grep -c '^- abm4 .*: \(yes\|no\)\.$' "$out/output")" -eq 2 ]
expect $? "make bench: a row for each method, and answers"
folder=$out/project/build/bench/double_pendulum
for method in rk4 ab4 abm4; do
    fewest=$(cut -d ' ' -f 3 "$folder/double-$method/bench")
    "$folder/double-$method/drive" 5 "$fewest" $((fewest - 1)) | sed 's/^\([^ ]*\) [^ ]*/double m 0 \1 5/' |
        awk -f tools/report/errors.awk part=reference "$folder/reference.txt" part=points - |
        awk -F '\t' 'NR == 2 { within = $5 <= 1e-6 } NR == 3 { beyond = $5 >= 0.9999e-6 } END { exit !(within && beyond) }'
    result $? "$method: the error is 1e-6 with $fewest steps, and more with one step less"
done

# Machines on which something is missing.
mkdir -p "$out/bin"
for tool in cc gcc as ld make sh awk sed tr cut printf mkdir cat cmp cksum grep test ls basename dirname nproc; do
    path=$(command -v $tool) && [ -x "$path" ] && ln -sf "$path" "$out/bin/$tool"
done
# names TARGET TOOL PACKAGE: without it, it is named, with how to install it; then it is there.
names()
{
    ! PATH=$PWD/$out/bin call "$1" && grep -q "^$2 is missing.*apt-get install .*$3" "$out/errors"
    expect $? "make $1 without $2: it is named, with how to install it"
    ln -sf "$(command -v "$2")" "$out/bin/$2"
}
names report gnuplot gnuplot-nox
names report valgrind valgrind
names bench arm-none-eabi-gcc gcc-arm-none-eabi
names bench qemu-system-arm qemu-system-arm
finish
