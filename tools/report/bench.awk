# The table of make bench, and what it answers.
#
#     awk -v scene=NAME -v time=5 -v step=0.001 -v error=1e-6 -f bench.awk methods.md measured
#
# The first is what `build/isoc --methods` prints. A line of the second is a method, its error with steps of twice
# `step` and of `step`, the fewest steps of the time with at most `error` (0 if there are none), the tolerance that they
# have if they vary, and the instructions of a step; where steps vary, there are the evaluations of one as well.

# The table's lines: | method | order | evaluations | Jacobians | ...
FILENAME != "-" {
    if (split($0, cell, " *[|] *") > 5) {
        order[cell[2]] = cell[3]
        evaluations[cell[2]] = cell[4] (cell[5] + 0 > 0 ? " and a Jacobian" : "")
    }
    next
}

FNR == 1 {
    printf "| method | order | evaluations | error, %g ms | error, %g ms | step for %s, ms | instructions | per second for %s |\n",
        2000 * step, 1000 * step, error, error
    print "|---|--:|--:|--:|--:|--:|--:|--:|"
}

{
    method[$1] = 1
    instructions[$1] = $6
    if ($4 > 0) {
        longest[$1] = time / $4
        price[$1] = $6 / longest[$1]
        if (best == "" || price[$1] < price[best])
            best = $1
    }
    printf "| %s | %s | %s | %s | %s | %s | %d | %s |\n", $1, order[$1], (NF > 6 ? $7 : evaluations[$1]), short($2), short($3),
        $4 ? sprintf("%.3g", 1000 * longest[$1]) : "below 0.001", $6, $4 ? sprintf("%.0f", price[$1]) : "-"
}

function short(error) {
    return error == "-" ? error : sprintf("%.2e", error)
}

# known A B: whether both were measured at equal error.
function known(a, b) {
    return a in longest && b in longest
}

function answer(condition, text) {
    print "- " text (condition ? ": yes." : ": no.")
}

END {
    if (NR == 0 || best == "")
        exit 1
    print ""
    if (known("abm4", "ab4")) {
        ratio = longest["abm4"] / longest["ab4"]
        answer(ratio > 2, sprintf("abm4 (PECE) takes %.2f times the step of ab4 at equal error. More than twice", ratio))
        ratio = price["abm4"] / price["ab4"]
        answer(ratio < 1, sprintf("abm4 takes %.2f times the instructions of ab4 at equal error. Fewer", ratio))
    }
    if (known("abm4_pec", "abm4")) {
        ratio = price["abm4_pec"] / price["abm4"]
        answer(ratio < 1, sprintf("abm4_pec, without the last evaluation, takes %.2f times those of abm4. Fewer", ratio))
    }
    if (known("abm4_pecece", "abm4")) {
        ratio = price["abm4_pecece"] / price["abm4"]
        answer(ratio < 1, sprintf("abm4_pecece, with a second correction, takes %.2f times those of abm4. Fewer", ratio))
    }
    if (known("ab4", "rk4")) {
        ratio = price["ab4"] / price["rk4"]
        answer(ratio < 1, sprintf("ab4, with one evaluation for four, takes %.2f times the instructions of rk4. Fewer", ratio))
    }
    if (known("adams", "abm4")) {
        ratio = price["adams"] / price["abm4"]
        answer(ratio < 1, sprintf("adams, which varies step and order, takes %.2f times those of abm4. Fewer", ratio))
    }
    if ("bdf4" in method && "rk4" in method) {
        ratio = instructions["bdf4"] / instructions["rk4"]
        answer(ratio <= 3, sprintf("A step of bdf4 takes %.2f times the instructions of one of rk4. At most three times", ratio))
    }
    print "- The fewest instructions for an error of " error ": " best "."
}
