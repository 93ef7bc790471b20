# The table of make bench, and the answers. Input: the output of `build/isoc --methods`, and a line for each method,
# with the result of search.awk, the instructions of a step and, where steps vary, its evaluations.
#
#     awk -v time=TIME -v step=STEP -v error=ERROR -f bench.awk METHODS MEASURED
BEGIN {
    printf "| method | order | evaluations | error, %g ms | error, %g ms | step for %s, ms | instructions | per second for %s |\n", \
        2000 * step, 1000 * step, error, error
    print "|---|--:|--:|--:|--:|--:|--:|--:|"
}

/^[|]/ {
    split($0, cell, / *[|] */)
    order[cell[2]] = cell[3]
    evaluations[cell[2]] = cell[4] (cell[5] > 0 ? " and a Jacobian" : "")
    next
}

{
    instructions[$1] = $6
    if ($4 > 0) {
        longest[$1] = time / $4
        cost[$1] = $6 / longest[$1]
        if (best == "" || cost[$1] < cost[best]) best = $1
    }
    printf "| %s | %s | %s | %s | %s | ", $1, order[$1], (NF > 6 ? $7 : evaluations[$1]), told($2), told($3)
    if ($4 > 0) printf "%.3g | %.0f | %.0f |\n", 1000 * longest[$1], $6, cost[$1]
    else printf "below 0.001 | %.0f | - |\n", $6
}

function told(value) { return value == "-" ? value : sprintf("%.2e", value) }

function answer(subject, ratio, question, yes)
{
    printf "- %s %.2f %s: %s.\n", subject, ratio, question, yes ? "yes" : "no"
}

# Two methods at equal error, by the instructions of a second.
function compare(a, b, subject, question)
{
    if (a in cost && b in cost) answer(subject, cost[a] / cost[b], question, cost[a] < cost[b])
}

END {
    if (best == "") exit 1
    print ""
    if ("abm4" in longest && "ab4" in longest)
        answer("abm4 (PECE) has", longest["abm4"] / longest["ab4"], "times the step of ab4 at equal error. More than twice",
            longest["abm4"] > 2 * longest["ab4"])
    compare("abm4", "ab4", "abm4 needs", "times the instructions of ab4 at equal error. Fewer")
    compare("abm4_pec", "abm4", "abm4_pec, without the last evaluation, needs", "times those of abm4. Fewer")
    compare("abm4_pecece", "abm4", "abm4_pecece, with a second correction, needs", "times those of abm4. Fewer")
    compare("ab4", "rk4", "ab4, with one evaluation instead of four, needs", "times the instructions of rk4. Fewer")
    compare("adams", "abm4", "adams, which varies step and order, needs", "times those of abm4. Fewer")
    if ("bdf4" in instructions && "rk4" in instructions)
        answer("A step of bdf4 has", instructions["bdf4"] / instructions["rk4"],
            "times the instructions of a step of rk4. At most three times", instructions["bdf4"] <= 3 * instructions["rk4"])
    print "- The fewest instructions for an error of " error ": " best "."
}
