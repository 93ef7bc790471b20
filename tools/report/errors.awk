# The table of a report, as tab-separated values.
#
#     awk -f errors.awk part=reference reference.txt part=points measured.txt
#
# A line of the first is one of tools/report/agree.awk; a line of the second is a kind, a method, the instructions of a
# step, the tolerance of adams, else `-`, and a line of tools/report/drive.c. The error is the 2-norm of the difference to
# the reference of that time; the order is that to which it fell from the line before, in the step or, where steps vary,
# in the tolerance, while both errors are well above what the reference is sure of.
part == "reference" {
    unsure[$1] = $2
    states = NF - 2
    for (i = 1; i <= states; i++)
        exact[$1, i] = $(i + 2)
    next
}

FNR == 1 {
    OFS = "\t"
    print "kind", "method", "step_s", "steps", "error", "order", "instructions_per_step", "instructions_per_second",
        "tolerance"
}

!($6 in unsure) || NF != states + 6 {
    print "errors.awk: no reference for: " $0 > "/dev/stderr"
    bad = 1
    exit
}

{
    square = 0
    finite = 1
    for (i = 1; i <= states; i++) {
        finite = finite && $(i + 6) !~ /n/
        square += ($(i + 6) - exact[$6, i]) ^ 2
    }
    error = finite ? sqrt(square) : "inf"
    step = $6 / $5
    fine = $4 == "-" ? step : $4
    order = "-"
    if ($1 " " $2 == last && finite && before != "inf" && error > 10 * unsure[$6])
        order = sprintf("%.2f", log(before / error) / log(last_fine / fine))
    print $1, $2, sprintf("%.9g", step), $5, finite ? sprintf("%.3e", error) : error, order, $3,
        sprintf("%.6g", $3 / step), $4
    last = $1 " " $2
    last_fine = fine
    before = error
}

END { exit bad }
