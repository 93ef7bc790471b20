#!/bin/sh
# The pictures of make report and make drift show what was measured, read back through their labels; no text in them,
# nor in those of models/, is cut off or lies on another one. A wrong label, a point that was moved or left out and a
# text beyond the edge are found. (make report itself: tests/tools/plot/report.t; make plot: tests/tools/plot/plot.t.)
. tests/host/test.sh
. tests/host/picture.sh
begin check/picture
reads_picture

# draw NAME: $out/NAME.svg from $out/NAME.gnuplot.
draw()
{
    sh tools/plot/draw.sh "$out/$1.gnuplot" >"$out/drawn"
}

# report LEAST METHOD...: a report of these methods, over ranges that begin and end between powers of ten, or span less
# than two of them.
report()
{
    report_least=$1
    shift
    printf 'kind\tmethod\tstep_s\tsteps\terror\torder\tper_step\tper_second\ttolerance\n'
    awk -v least="$report_least" -v names="$*" 'BEGIN {
        kinds = split("float compensated double", kind, " ")
        methods = split(names, method, " ")
        for (k = 1; k <= kinds; k++)
            for (m = 1; m <= methods; m++)
                for (i = 0; i < 5; i++)
                    printf "%s\t%s\t%.9g\t%d\t%.3e\t-\t%d\t%.6g\t-\n", kind[k], method[m], 0.004 / 2 ^ i, 1250 * 2 ^ i,
                        3 / (1 + m * 1.7 ^ i) ^ (k == 3 ? 3 : 1) + k * 1e-6 * i, 100 + 31 * m, least * (1 + m / 3) * 2 ^ i
        printf "float\tdiverged\t0.004\t1250\tinf\t-\t10\t%g\t-\n", least
    }'
}

# draws NAME: whether $out/NAME.svg, drawn from the report $out/NAME.tsv, shows its points and its Pareto fronts.
draws()
{
    report_points "$out/$1.tsv" >"$out/points"
    sh tools/plot/picture.sh work_precision NAME 5 "$out/$1.tsv" >"$out/$1.gnuplot" && draw "$1"
    shows "$out/$1.svg" "$out/points" all
}

# Two methods that look alike would be found as one with the name of the other.
# shellcheck disable=SC2046
report 300 euler heun rk4 ab4 semi_implicit abm4 abm4_pec abm4_pecece bdf4 rosenbrock adams \
    $(seq -f 'unheard_of_%02.0f' 20) >"$out/many.tsv"
draws many
result $? "20 methods that core does not have differ in their looks, from each other and from those of core"
for least in 300 1.9e4 48250; do
    report $least euler rk4 abm4 abm4_pec adams unheard_of >"$out/report.tsv"
    draws report
    result $? "a report's picture shows the points of its table and their Pareto fronts, from $least on"
done
stands_out "$out/report.svg" "$out/points"
result $? "points off the Pareto fronts are pale"
sed 's/^    PALENESS = .*/    PALENESS = 0/' tools/plot/work_precision.awk >"$out/work_precision.awk"
build/isoc --methods | awk -F '\t' -f tools/plot/gnuplot.awk -f tools/plot/looks.awk -f "$out/work_precision.awk" \
    NAME 5 "$out/report.tsv" >"$out/wrong.gnuplot" && draw wrong && ! stands_out "$out/wrong.svg" "$out/points"
result $? "found: points off the front that are as dark"
for text in 'euler, 4 ms' 'Pareto front' 'unheard_of'; do
    grep -qF ">$text<" "$out/report.svg"
    result $? "it says: $text"
done

awk 'BEGIN {
    for (i = 1; i <= 50; i++) {
        print "none part", i * 3, 2.2e-5 * 1.2 ^ i
        print "projection part", i * 3, 3e-8 * (2 + sin(i))
    }
    print "projection bound 1.0151e-06"
}' >"$out/measured"
awk -v OFS='\t' '
    $2 == "part" { print "|t, s", $1, $3, $4 }
    $2 == "bound" { print "|t, s", $1, 0, $3; print "|t, s", $1, 150, $3 }' "$out/measured" >"$out/violations"
sh tools/plot/picture.sh violation NAME "$out/measured" >"$out/violation.gnuplot" && draw violation
shows "$out/violation.svg" "$out/violations" all
result $? "a picture of make drift shows what was measured"

for picture in models/pictures/*.svg; do
    ! grep -q "class=\"graph\"\|class='still'" "$picture" || continue
    shows "$picture"
    result $? "$picture: no text is cut off or lies on another one"
done

# The pictures in models/ and the tables beside them: the errors of make bench, and the bounds of make drift.
report=models/pictures/double_pendulum_work_precision.svg
awk -F ' *[|] *' -v OFS='\t' '
    /^[|] method .* error, 2 ms / { on = !tables++; next } # the first table is that of the double pendulum
    !/^[|]/ { on = 0 }
    on && $5 + 0 > 0 { print "double|step, ms", $2, 2, $5; print "double|step, ms", $2, 1, $6 }' core/methods.md >"$out/errors"
[ "$(grep -c . "$out/errors")" -ge 20 ] && shows $report "$out/errors" covered
result $? "$report has the errors that core/methods.md has"
awk -F ' *[|] *' -v OFS='\t' '/^[|] [a-z]* [|] [0-9]/ && $5 + 0 > 0 { print "|t, s", $2, 0, $5; print "|t, s", $2, 600, $5 }' \
    models/drift.md >"$out/bounds"
[ "$(grep -c . "$out/bounds")" -eq 6 ] && shows models/pictures/four_bar_violation.svg "$out/bounds" covered
result $? "models/pictures/four_bar_violation.svg has the bounds that models/drift.md has"

# found WHAT SVG [POINTS]: this picture is found wrong.
found()
{
    what=$1
    shift
    ! "$out/picture" "$@" >"$out/shown" 2>&1
    result $? "found: $what"
}

# Gnuplot's own tics of a logarithmic axis, labelled as the decade below.
sed "/^set xtics.*10^/s/.*/set xtics 10\nset format x '10^{%T}'/" "$out/report.gnuplot" >"$out/wrong.gnuplot" && draw wrong
found "an axis labelled as the decade below" "$out/wrong.svg" "$out/points" all
awk '/>10<.*>-2</ && !n++ { sub(/>-2</, ">-3<") } { print }' "$out/report.svg" >"$out/wrong.svg"
found "a wrong label" "$out/wrong.svg" "$out/points" all
awk '/^<use.*translate/ && !n++ && match($0, /\([0-9.]+/) {
    $0 = substr($0, 1, RSTART) substr($0, RSTART + 1, RLENGTH - 1) + 0.2 substr($0, RSTART + RLENGTH)
} { print }' "$out/report.svg" >"$out/wrong.svg"
found "a point that was moved by a fifth of a pixel" "$out/wrong.svg" "$out/points" all
awk '/^<use.*gpPt6/ && ++n == 3 { next } { print }' "$out/report.svg" >"$out/wrong.svg"
found "a point that is not drawn" "$out/wrong.svg" "$out/points" all
sed 3d "$out/points" >"$out/wrong.points"
found "a point that is not in the table" "$out/report.svg" "$out/wrong.points" all
sed "s/>rk4</>rk5</" "$out/report.svg" >"$out/wrong.svg"
found "a wrong name in the legend" "$out/wrong.svg" "$out/points" all
awk -F '\t' -v OFS='\t' 'NR == 3 { $4 *= 1.02 } { print }' "$out/errors" >"$out/wrong.points"
found "an error that is not in the picture" $report "$out/wrong.points" covered
sed "s/^set xlabel.*/&\nset label 'so far to the right' at screen 0.95, 0.9/" "$out/violation.gnuplot" >"$out/wrong.gnuplot"
draw wrong
found "a text that is cut off" "$out/wrong.svg"
sed "s/^set xlabel.*/&\nset label 'there' at screen 0.075, 0.9/" "$out/violation.gnuplot" >"$out/wrong.gnuplot" && draw wrong
shows "$out/wrong.svg"
result $? "a text in a free place is let through"
sed "s/^set xlabel.*/&\nset label 'here' at graph 0.5, 1.05/" "$out/violation.gnuplot" >"$out/wrong.gnuplot" && draw wrong
found "a text on another one" "$out/wrong.svg"
finish
