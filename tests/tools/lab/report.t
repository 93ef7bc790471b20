#!/bin/sh
# isochron report and isochron bench: the tables are whole, errors fall with the methods' orders, what runs with any
# step or tolerance is what make run runs, a reference that two methods do not agree on is refused. Wrong references and
# tables are seen.
. tests/host/test.sh
. tests/host/project.sh
. tests/host/picture.sh
begin check/report
project
unoptimised
reads_picture

# By turns, both with the argument `all`: the report of a scene with inputs, and make bench.
turn=$(turn_of 2 "${1-}" core tools models)
echo "# turn $turn of a report with a loop, and isochron bench"
methods="euler heun rk4 rosenbrock adams"
folder=$out/project/build/report/double_pendulum
tsv=$folder/report.tsv

# errors REFERENCE POINTS: the table of a report.
errors()
{
    awk -f tools/measure/reference.awk -f tools/measure/errors.awk "$@"
}

# whole TSV: a line for each kind, method and step, each with an error above zero, and instructions per second that are
# those of a step over the step; compensated sums take more of them than plain ones.
whole()
{
    awk -F '\t' -v methods="$methods" '
        NR > 1 {
            n[$1, $2]++
            step[$1, $2] = $7
            if (NF != 9 || !($5 > 0) || $8 < 0.999 * $7 / $3 || $8 > 1.001 * $7 / $3) bad = 1
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
        $1 == "double" && $6 != "-" && $9 == "-" { before[$2] = last[$2]; last[$2] = $6; seen[$2] = 1 }
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

# adapted TSV: with every smaller tolerance adams makes more steps, and in double its error falls with tolerance^(4/5),
# but for the scatter that tests/core/methods/adaptive/adams.c derives: steps are powers of two, an error of order four
# is within 2^5.
adapted()
{
    awk -F '\t' '
        $2 != "adams" { next }
        $1 == kind && ($4 <= steps || $9 >= tolerance) { bad = 1 }
        $1 == "double" && ++count == 1 { loose = $9; large = $5 }
        { kind = $1; steps = $4; tolerance = $9; error = $5 }
        END {
            off = log(large / error) / log(loose / tolerance) - 4 / 5
            scatter = 5 * log(2) / log(loose / tolerance)
            exit bad || count != 6 || kind != "double" || off > scatter || off < -scatter
        }' "$1"
}

# One target is as good as several.
export TICK_TARGETS=cortex-m4f
isochron report models/double_pendulum.scene --methods "$methods"
expect $? "isochron report"
awk '/^isochron report: [0-9]+ of 15: [a-z0-9]* in [a-z]*$/ { n++; told[$3] }
    END { for (i = 1; i <= 15; i++) if (!(i in told)) exit 1; exit n != 15 }' "$out/errors"
expect $? "it shows its progress"

# A warning of many kinds and methods is told once, with the place in the scene.
printf 'DIR/%s/a.scene:3:1: warning: %s\n    text\n    ^\n' one first one second >"$out/warned"
(
    SCENE=models/a.scene dir=$out/told && mkdir -p "$dir/told" && . tools/measure/methods.sh
    for kind in one two; do
        sed "s|DIR/one|$dir/$kind|" "$out/warned" >"$out/warned.$kind"
        tell "$out/warned.$kind" "$dir/$kind/a.scene"
    done
) 2>"$out/told.text"
printf 'models/a.scene:3:1: warning: %s\n    text\n    ^\n' first second | diff - "$out/told.text" >"$out/diff"
result $? "two warnings of two kinds are told once each"
named=' '
while IFS= read -r line; do
    case $line in
    build/report/double_pendulum/*) named="$named$line " ;;
    esac
done <"$out/output"
for file in report.html report.txt report.tsv work_precision.svg work_precision.png; do
    case $named in
    *" build/report/double_pendulum/$file "*) [ -s "$folder/$file" ] ;;
    *) false ;;
    esac
    result $? "$file is there, and named"
done
whole "$tsv"
result $? "the table has every kind, method and step"

# The page: its tables are the files, and each number in its text is that of a cell.
python3 tests/check/cells.py "$folder/report.html" "$folder" >"$out/cells"
status=$?
while IFS= read -r line; do
    echo "# $line"
done <"$out/cells"
result $status "every number of the page is a cell of a table that it shows: $line"
parts=$(grep -o "<table data-file='[a-z_]*[.]tsv'>\|data-cell='[a-z_]*[.]tsv:" "$folder/report.html" | sort -u)
for part in report cycles growth local_error account tick regions; do
    case $parts in
    *"<table data-file='$part.tsv'>"*"data-cell='$part.tsv:"* | *"data-cell='$part.tsv:"*"<table data-file='$part.tsv'>"*) ;;
    *) false ;;
    esac
    result $? "the page has $part.tsv, and numbers of it"
done
awk '/srcdoc="<!doctype html>/ { motion++ } /img alt=.* src="data:image.svg[+]xml;base64/ { pictures++ }
    /no error is below .*[0-9]<.data> instructions per second/ { exact++ }
    /the cheapest is .*[0-9]<.data> cycles per second/ { cheap++ }
    END { print motion + 0, pictures + 0, exact + 0, cheap + 0 }' "$folder/report.html" >"$out/has"
read -r motion pictures exact cheap <"$out/has"
[ "$motion $pictures" = '1 6' ]
result $? "it has the mechanism and six pictures in it"
[ "$exact $cheap" = '3 2' ]
result $? "it says of each kind what is most exact and what is cheapest, over instructions and over cycles"
awk '{ n++ } END { exit n < 2 }' "$out/project/build/report/references/"*
result $? "references are kept"
mkdir -p "$out/wrong" && cp "$folder"/*.tsv "$out/wrong"
awk -F '\t' -v OFS='\t' 'NR == 5 { $5 = "1.234e-05" } { print }' "$folder/growth.tsv" >"$out/wrong/growth.tsv"
! python3 tests/check/cells.py "$folder/report.html" "$out/wrong" >/dev/null
result $? "found: a table that is not that of the page"
sed "0,/\(data-cell='tick[^>]*>\)[0-9.]*/s//\11234/" "$folder/report.html" >"$out/wrong.html"
! cmp -s "$folder/report.html" "$out/wrong.html" && ! python3 tests/check/cells.py "$out/wrong.html" "$folder" >/dev/null
result $? "found: a number that is not that of its cell"
sed 's/<h2>The dearest tick/<p>It takes 12 us.<\/p>&/' "$folder/report.html" >"$out/wrong.html"
! python3 tests/check/cells.py "$out/wrong.html" "$folder" >/dev/null
result $? "found: a number of no cell"
# The pictures of the page, read back.
awk -F '\t' -v OFS='\t' 'FNR > 1 && $5 > 0 { print "|t, s", $1, $4, $5 }' "$folder/growth.tsv" >"$out/points"
shows "$folder/growth.svg" "$out/points" all
result $? "the picture of the growth has the points of its table"
awk -F '\t' -v OFS='\t' 'FNR > 1 { print "|real part of the eigenvalue times the step", $1, $2, $3 }' "$folder/regions.tsv" >"$out/points"
shows "$folder/regions.svg" "$out/points" drawn
result $? "the picture of the regions shows what its table has"
# estimated TSV: the error of a step of rk4 is told within the factor of tests/core/methods/estimate/local_error.c.
estimated()
{
    awk -F '\t' 'FNR > 1 { n++; if (!($3 > 0 && $2 >= 0.2 * $3 && $2 <= 5 * $3)) exit n = 0 } END { exit n < 60 }' "$1"
}
awk -F '\t' -v OFS='\t' 'FNR > 1 { print "|t, s", "told", $1, $2; print "|t, s", "true", $1, $3 }' "$folder/local_error.tsv" >"$out/points"
estimated "$folder/local_error.tsv" && shows "$folder/local_error.svg" "$out/points" all
result $? "the error of a step is what the method tells of it within a factor of five; its picture has the points"
awk -F '\t' -v OFS='\t' 'FNR == 30 { $2 *= 30 } { print }' "$folder/local_error.tsv" >"$out/wrong.tsv"
! estimated "$out/wrong.tsv"
result $? "found: an error that is told wrong"

# near TEXT...: the page has these texts of the ticks near singular positions that a summary of 5000 ticks tells, or of
# none.
near()
{
    (
        SCENE=models/four_bar.scene NAME=four_bar WHAT=near dir=$out/near REPORT_PARTS=nearness
        . tools/measure/common.sh
        . tools/measure/page.sh
    ) 2>/dev/null
    for text in "$@"; do
        grep -q "$text" "$out/near/report.html" || return 1
    done
    python3 tests/check/cells.py "$out/near/report.html" "$out/near" >/dev/null
}
mkdir -p "$out/near/account" && echo iso_watch_pivots >"$out/near/account/plant.c"
echo 'ticks 5000' >"$out/near/account/summary.txt"
near "Of <data value='5000'" "<data value='0'"
result $? "no tick near a singular position"
echo 'near_singular 12 from 0.5 s in follower_pin' >>"$out/near/account/summary.txt"
near "<data value='12' .*<data value='5000' .*<data value='0.5' .*<b>follower_pin</b>"
result $? "ticks near a singular position, the first and its closure"
echo >"$out/near/account/plant.c"
! near 'singular position'
result $? "where nothing is watched the page says nothing of them"

# Where loops come near singular positions: a parallelogram that is stretched, and folded, within a second.
(
    SCENE=models/parallelogram.scene NAME=parallelogram WHAT=near dir=$out/stretched REPORT_PARTS="account nearness" STEP='' NANOSECONDS=1000000000
    COMPILE="$CC $FLAGS -O1" && mkdir -p "$dir"
    . tools/measure/common.sh
    . tools/measure/page.sh
) 2>"$out/errors"
awk -F '\t' '
    FNR == 1 { file++ }
    file == 1 && $1 == "violation" { most = $6 }
    file == 2 && FNR > 1 {
        if ($2 < least || least == "") { least = $2; at = $1 }
        change = $3 > change ? $3 : change
        apart = $4 > apart ? $4 : apart
    }
    END { exit !(FNR > 300 && least < 1e-4 && at > 0.55 && at < 0.65 && change > 10 && apart == most && most > 0) }' \
    "$out/stretched/account.tsv" "$out/stretched/singular.tsv"
expect $? "a parallelogram that is stretched: the least pivot there, and the violation that its account has"
awk -F '\t' -v OFS='\t' 'FNR > 1 { print "|t, s", "violation, m or rad", $1, $4 }' "$out/stretched/singular.tsv" >"$out/points"
shows "$out/stretched/singular.svg" && python3 tests/check/cells.py "$out/stretched/report.html" "$out/stretched" >/dev/null
result $? "it has a picture, and each number of it is a cell"

# What growth.tsv says of the end is what report.tsv says of the scene's step.
awk -F '\t' '
    FNR == NR { if ($2 == "rk4" && $3 > 0.00099 && $3 < 0.00101) error[$1] = $5; next }
    FNR > 1 { last[$1] = $5 }
    END { for (kind in last) { n++; if (last[kind] != error[kind]) exit 1 } exit n != 3 }' "$tsv" "$folder/growth.tsv"
result $? "the error at the end of the growth is that of the table"
# The edge of rk4 on the real axis, and that of ab4.
awk -F '\t' '
    $1 == "rk4" && ($3 < 0 ? -$3 : $3) < 1e-3 && $2 < rk4 { rk4 = $2 }
    $1 == "ab4" && ($3 < 0 ? -$3 : $3) < 1e-3 && $2 < ab4 { ab4 = $2 }
    END { exit !(rk4 < -2.784 && rk4 > -2.786 && ab4 < -0.2999 && ab4 > -0.3001) }' "$folder/regions.tsv"
result $? "the regions of rk4 and ab4 end at -2.785 and -0.3"
build/isoc --methods >"$out/methods.md"
awk -F '\t' '
    FNR == NR { if (FNR > 2) { split($0, cell, " *[|] *"); wanted[cell[2]] } next }
    $1 == "eigenvalue" || $1 == "what" { next }
    { had[$1] }
    END {
        for (method in wanted) { n++; if (!(method in had)) exit 1 }
        for (method in had) if (!(method in wanted)) exit 1
        exit n == 0
    }' "$out/methods.md" "$folder/regions.tsv"
expect $? "every method has one"
ordered "$tsv" "$out/methods.md"
result $? "errors fall with the order of the method"
adapted "$tsv"
result $? "those of adams fall with its tolerance"
awk 'FNR == NR { line[++lines] = $0; next } /^  (CC|LINK) / { next } n < lines && $0 != line[++n] { exit unlike = 1 }
    END { exit unlike || n != lines || lines == 0 }' "$folder/report.txt" "$out/output"
result $? "report.txt is what is printed"
picture=$(cat "$folder/work_precision.svg")
[ ${#picture} -lt 100000 ]
result $? "the picture is smaller than 100 kB"
report_points "$tsv" >"$out/points"
shows "$folder/work_precision.svg" "$out/points" all
result $? "the picture, read back through its labels, has the points of the table, and those of the Pareto fronts"
# Cycles of each step and kind, once to four times its instructions.
awk -F '\t' '
    FNR == NR { if ($2 != "adams") instructions["cycles_" $1, $2, $3] = $7; next }
    FNR > 1 { n++; took = instructions[$1, $2, $3]; if (!(took > 0 && $7 >= took && $7 < 4 * took)) exit n = 0 }
    END { exit n != 48 }' "$tsv" "$folder/cycles.tsv"
result $? "each step has its cycles"
report_points "$folder/cycles.tsv" >"$out/points"
shows "$folder/cycles.svg" "$out/points" all
result $? "the picture over the cycles has the points of its table"
for text in $methods 'double_pendulum: error over cost' 'float, compensated sums' 'step, ms'; do
    case $picture in
    *"$text"*) ;;
    *) false ;;
    esac
    result $? "the picture says: $text"
done

# same POINTS UNIT STEPS: the state that make run printed is that of the report after so many steps. A number is printed
# as the shortest decimal that reads back: within half a unit in the last place.
same()
{
    awk -v unit="$2" -v steps="$3" '
        FNR == NR { if ($1 == "state") for (i = 2; i <= NF; i++) a[++count] = $i; next }
        $1 != steps { next }
        {
            for (i = 3; i <= NF; i++) {
                n++
                off = a[n] - $i
                if ((off < 0 ? -off : off) > unit / 2 * ($i < 0 ? -$i : $i)) bad = 1
            }
        }
        END { exit bad || n != 4 || count != 4 }' "$out/output" "$folder/$1/points"
}

# The program with any step is the one that make run runs.
isochron run models/double_pendulum.scene --real double --seconds 5
expect $? "make run in double"
same double-rk4 2.3e-16 5000
result $? "the state is that of make run, in double"
isochron run models/double_pendulum.scene --seconds 5
same float-rk4 1.2e-7 5000
result $? "the state is that of make run, in float"

# row TOLERANCE: what the report has of adams in float.
row()
{
    awk -F '\t' -v tolerance="$1" '$1 == "float" && $2 == "adams" && $9 == tolerance' "$tsv"
}

# So is the one with any tolerance; its instructions are all those of the run.
isochron run models/double_pendulum.scene --target cortex-m4f --method adams --step 40ms --tolerance 1e-6 --seconds 5
expect $? "make run of adams on the board"
read_value substeps
same float-adams 1.2e-7 "$value"
result $? "the sub-steps and the state are those of make run, in float, of adams"
row 1e-6 | awk -F '\t' -v run="$(value execution)" -v ticks="$(value ticks)" '
    { split(run, execution, " "); off = $8 * 5 / (execution[2] * ticks) - 1; n++ }
    END { exit n != 1 || off > 0.001 || off < -0.001 }'
result $? "its instructions per second are those of the run"

# The instructions of a step do not depend on its length, nor on the number of steps.
for arguments in "--step 4ms --seconds 0.1" "--step 125us --seconds 0.05"; do
    # shellcheck disable=SC2086
    isochron run models/double_pendulum.scene --target cortex-m4f --method heun $arguments
    read_value instructions_per_step
    awk -v n="$value" '$1 != n { unlike = 1 } END { exit unlike || NR == 0 }' "$folder/float-heun/costs"
    expect $? "a step of heun has as many instructions with $arguments"
done

# wrong NAME TSV [METHODS_TABLE]: the table is found wrong.
wrong()
{
    ! { whole "$2" && ordered "$2" "${3:-$out/methods.md}" && adapted "$2"; }
    result $? "found: $1"
}

sed '20d' "$tsv" >"$out/wrong.tsv"
wrong "a row left out" "$out/wrong.tsv"
awk -F '\t' '$2 != "heun"' "$tsv" >"$out/wrong.tsv"
wrong "a method left out" "$out/wrong.tsv"
awk -F '\t' -v OFS='\t' '$1 == "double" && $9 == "1e-13" { $5 = 1e-7 } { print }' "$tsv" >"$out/wrong.tsv"
wrong "an error of adams that does not fall" "$out/wrong.tsv"
awk -F '\t' -v OFS='\t' '$1 == "float" && $9 == "1e-5" { $9 = "1e-3" } { print }' "$tsv" >"$out/wrong.tsv"
wrong "a tolerance in a wrong place" "$out/wrong.tsv"
sed 's/^| rk4 | 4/| rk4 | 3/' "$out/methods.md" >"$out/wrong.md"
wrong "a wrong order in the table of methods" "$tsv" "$out/wrong.md"
awk '{ $3 += 1e-8; print }' OFMT=%.17g CONVFMT=%.17g "$folder/reference.txt" >"$out/wrong.txt"
errors "$out/wrong.txt" "$folder/measured.txt" >"$out/wrong.tsv"
wrong "a reference that is wrong by 1e-8" "$out/wrong.tsv"
awk '{ print "9", $0 }' "$folder/reference.txt" >"$out/wrong.txt"
! errors "$out/wrong.txt" "$folder/measured.txt" >"$out/wrong.tsv" 2>/dev/null
result $? "found: a point without a reference"

# At rest every method is right.
awk -F '\t' -v OFS='\t' 'NR > 1 { $5 = "0.000e+00" } { print }' "$tsv" >"$out/rest.tsv"
[ -z "$(sh tools/plot/picture.sh work_precision rest 5 "$out/rest.tsv")" ] && [ -n "$(sh tools/plot/picture.sh work_precision rest 5 "$tsv")" ]
result $? "nothing is drawn where no method errs"

# agreed LINE LINE: whether two states are the same to 1e-12.
agreed()
{
    printf '%s\n' "$@" | awk -v times=5 -v tolerance=1e-12 -f tools/measure/agree.awk >"$out/agreed"
}

agreed '9 5 1 2' '9 5 1.000000000001 2' && read -r at _ state <"$out/agreed" && [ "$at $state" = '5 1 2' ]
result $? "two states that differ by 1e-12 agree"
! agreed '9 5 1 2' '9 5 1.00000000001 2'
result $? "found: two that differ by 1e-11"
! agreed '9 5 1 nan' '9 5 1 nan'
result $? "found: two that are no numbers"
! agreed '9 5 1 2'
result $? "found: one alone"
! isochron report models/double_pendulum.scene --methods rk4 --seconds 40 --step 8ms && grep -q 'no reference for double_pendulum after 40 s' "$out/errors"
expect $? "found: a time for which the motion is chaotic"
! isochron report models/absent.scene && grep -q 'there is no scene models/absent.scene' "$out/errors"
expect $? "found: a scene that is not there"
! isochron report models/oscillator.c --methods adams && grep -q 'adams cannot be built' "$out/errors"
expect $? "found: adams of a plant in C"

# A plant in C, another step, and inputs; the tables alone.
export REPORT_PARTS=
isochron report models/oscillator.c --methods bdf4 --step 2ms --seconds 2
expect $? "isochron report of a plant in C"

if [ "$turn" != 1 ]; then
    # At rest while its input is 0, and with dry friction, whose creep would be another for each method.
    sed '/^method/d; s/^step .*/step 1 ms; method heun/' <<'END' >"$out/project/resting.scene"
step 1 ms
input push = table(0 s: 0 N, 0.1 s: 3 N, 1 s: 2 N)
body cart { mass 1 kg; com (0, 0, 0) m }
joint rail prismatic { parent ground; child cart; axis x; drive push; spring 40 N/m }
include "rub.scene"
output place = position of rail
END
    echo 'effect rub friction { along rail; sliding 0.5 N; static 1 N }' >"$out/project/rub.scene"
    isochron report resting.scene --methods rk4 --seconds 0.2
    rested=$out/project/build/report/+resting.scene
    # shellcheck disable=SC2086
    grep -q 'each keeps the largest value of its function' $rested/report.txt && grep -q 'largest value of its function' $rested/report.html &&
        awk -F '\t' 'FNR > 1 { n++; if (!($5 > 0)) bad = 1 } END { exit bad || n != 18 }' $rested/report.tsv &&
        [ "$(sed -n 's/.*stable rub.creep//p' $rested/own/plant.txt | wc -l)" -eq 1 ] && ! grep -q stable $rested/double-rk4/plant.txt
    expect $? "a scene that rests with the inputs of its start: with others every step has an error, of the same equations"

    isochron report models/cart_pole.scene --methods "rk4 ab4" --seconds 1
    expect $? "isochron report of a scene with an input"

    # In a loop: the last order observed of each method and reading, to the nearest number; a history makes it one where
    # inputs are held.
    of_loop=$out/project/build/report/cart_pole
    awk -F '\t' 'NR > 1 && $6 != "-" { order[$1 " " $2] = $6 } END { for (key in order) printf "%s %.0f\n", key, order[key] }' \
        "$of_loop/loop.tsv" | sort >"$out/loop"
    printf '%s\n' 'held ab4 1' 'held rk4 4' 'smooth ab4 4' 'smooth rk4 4' | cmp -s - "$out/loop" && [ -s "$of_loop/loop.svg" ]
    expect $? "isochron report of a scene with an input: orders in a loop, and a picture"
    # Recorded inputs: those at the start are those of no loop; what is no record is refused.
    printf '0\n0,\n' >"$out/zeros"
    RECORDED=$out/zeros "$of_loop/double-rk4/drive" held 1 1000 >"$out/recorded" && "$of_loop/double-rk4/drive" 1 1000 | cmp -s - "$out/recorded"
    result $? "recorded inputs that do not change are frozen ones"
    printf '0.5\n-0.5\n' >"$out/zeros"
    RECORDED=$out/zeros "$of_loop/double-rk4/drive" held 1 1000 >"$out/changed" && ! cmp -s "$out/changed" "$out/recorded"
    result $? "control: others are not"
    echo 'force 1' >"$out/zeros"
    ! RECORDED=$out/zeros "$of_loop/double-rk4/drive" held 1 1000 >"$out/changed" 2>"$out/errors" && grep -q '0 numbers are no lines of 1 inputs' "$out/errors"
    result $? "found: a file without numbers"
fi

# limit METHOD WITHIN BEYOND: whether the error is 1e-6 at most with the first number of steps, or tolerance, and more
# with the other.
limit()
{
    "$folder/double-$1/drive" 5 "$2" "$3" | sed 's/^\([^ ]*\) [^ ]*/double m 0 - \1 5/' |
        errors "$folder/reference.txt" - |
        awk -F '\t' 'NR == 2 { within = $5 <= 1e-6 } NR == 3 { beyond = $5 >= 0.9999e-6 } END { exit !(within && beyond) }'
}

# The bench: its largest step is the largest.
if [ "$turn" != 0 ]; then
    cost=$(row 1e-8 | cut -f 7)
    isochron bench models/double_pendulum.scene --methods "rk4 ab4 abm4 adams"
    expect $? "isochron bench"
    [ "$(grep -c '^| \(rk4\|ab4\|abm4\) | 4 |' "$out/output")" -eq 3 ] && [ "$(grep -c '^- \(abm4\|adams\)[ ,].*: \(yes\|no\)\.$' "$out/output")" -eq 3 ]
    expect $? "isochron bench: a row for each method, and answers"
    folder=$out/project/build/bench/double_pendulum
    for method in rk4 ab4 abm4; do
        fewest=$(cut -d ' ' -f 3 "$folder/double-$method/bench")
        limit $method "$fewest" $((fewest - 1))
        result $? "$method: the error is 1e-6 with $fewest steps, and more with one step less"
    done
    found=$(cut -d ' ' -f 4 "$folder/double-adams/bench")
    looser=$(awk -v found="$found" 'BEGIN {
        for (t = 1e-2; t > 1e-13; t /= 2 ^ (1 / 4)) {
            said = sprintf("%.3g", t)
            if (said == found "")
                print before
            before = said
        }
    }')
    limit adams "$found" "$looser"
    result $? "adams: the error is 1e-6 with a tolerance of $found, and more with $looser"
    # The tolerance found is less than what float can tell: then it is that of the report's last row.
    grep -qx "| adams | 1 to 4 | 2\.[0-9]* | - | - | [0-9.]* | $cost | [0-9]* |" "$out/output"
    expect $? "adams: a sub-step has $cost instructions"
fi

# Machines on which something is missing.
mkdir -p "$out/bin"
tools_in "$out/bin" cc gcc as ld make sh awk sed tr cut printf mkdir cat cmp cksum grep test ls basename dirname nproc flock realpath
# names TARGET TOOL PACKAGE: without it, it is named, with how to install it; then it is there.
names()
{
    ! PATH=$PWD/$out/bin isochron "$1" models/double_pendulum.scene && grep -q "^$2 is missing.*apt-get install .*$3" "$out/errors"
    expect $? "$1 without $2: it is named, with how to install it"
    tools_in "$out/bin" "$2"
}
names report gnuplot gnuplot-nox
names report valgrind valgrind
names bench arm-none-eabi-gcc gcc-arm-none-eabi
names bench qemu-system-arm qemu-system-arm
finish
