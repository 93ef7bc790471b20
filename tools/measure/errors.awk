# The table of a report, tab-separated, from the measurements: lines of a kind, a method, the instructions of a step,
# the tolerance of adams, else `-`, and a line of drive.c: steps, time, state.
#
#     awk -f reference.awk -f errors.awk REFERENCE POINTS
BEGIN {
    OFS = "\t"
    read_reference(ARGV[1])
    ARGV[1] = ""
    print "kind", "method", "step_s", "steps", "error", "order", "instructions_per_step", "instructions_per_second", "tolerance"
}

!($6 in unsure) || NF != 6 + states {
    fail(FILENAME ":" FNR ": no reference for " $1 " " $2 " after " $6 " s")
}

{
    step = $6 / $5
    fine = $4 == "-" ? step : $4
    error = error_from($6, 7)
    if ($1 != kind || $2 != method) last_error = INFINITE
    # The order to which the error fell from the line before, in the step or, where steps vary, in the tolerance; `-`
    # where the line before has the same, and unless both errors are well above the uncertainty of the reference.
    order = "-"
    if (error < INFINITE && last_error < INFINITE && error > 10 * unsure[$6] && fine != last_fine)
        order = sprintf("%.2f", log(last_error / error) / log(last_fine / fine))
    print $1, $2, sprintf("%.9g", step), $5, (error < INFINITE ? sprintf("%.3e", error) : "inf"), order, $3, sprintf("%.6g", $3 / step), $4
    kind = $1
    method = $2
    last_error = error
    last_fine = fine
}
