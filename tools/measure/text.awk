# The table of errors.awk as text.
BEGIN { FS = "\t" }
NR == 1 { next }
{
    rows++
    for (i = 1; i <= NF; i++) row[rows, i] = $i
    fixed[rows] = $9 == "-"
    millions[rows] = sprintf("%.4g", $8 / 1e6)
    short[rows] = $5 == "inf" ? $5 : sprintf("%.1e", $5)
    if (!fixed[rows]) next
    # The steps of all methods; a float's differs from a double's in its last digits only.
    for (i = 1; i <= steps && !is_step(rows, i); i++) continue
    if (i > steps) step[++steps] = $3
    at[$1, $2, i] = rows
    if (!(($1, $2) in begun)) begins[rows] = begun[$1, $2] = 1
}

function is_step(r, i, ratio)
{
    ratio = row[r, 3] / step[i]
    return ratio > 0.999 && ratio < 1.001
}

function title_of(kind)
{
    return (kind == "held" || kind == "smooth" ? kind " inputs, double" : kind == "compensated" ? "float with compensated sums" : kind) \
        ", instructions of " (kind == "float" || kind == "compensated" ? "the Cortex-M4F" : "this machine")
}

# The methods of a kind, each in a row: at each step the error, over the cost or over the step.
function put_tables(over_cost, r, i, there, last)
{
    for (r = 1; r <= rows; r++) {
        if (!begins[r]) continue
        if (row[r, 1] != last) {
            last = row[r, 1]
            printf "\n%s\n  %-14s %8s", over_cost ? title_of(last) : last, "", over_cost ? "a step" : ""
            for (i = 1; i <= steps; i++) printf " %15s", sprintf("%.4g ms", step[i] * 1000)
            print ""
        }
        printf "  %-14s %8s", row[r, 2], over_cost ? row[r, 7] : ""
        for (i = 1; i <= steps; i++) {
            there = at[row[r, 1], row[r, 2], i]
            printf " %15s", !there ? "-" : over_cost ? sprintf("%s %7s", millions[there], short[there]) : \
                sprintf("%9s %5s", row[there, 5], row[there, 6])
        }
        print ""
    }
}

END {
    if (steps) {
        print "Error over instructions: the instructions of a step, then at each step millions of them in a second of the\n" \
            "plant's time and the error"
        put_tables(1)
        print "\nError over the step, with the order observed from the step before"
        put_tables(0)
    }
    for (r = 1; r <= rows; r++) {
        if (fixed[r]) continue
        if (!varied++) {
            if (steps) print ""
            print "adams, whose steps vary: their mean, the instructions of one, millions of them in a second of\n" \
                "the plant's time, the error, and its order in the tolerance\n"
            printf "  %-14s %9s %12s %12s %12s %9s %6s\n", "", "tolerance", "a step", "instructions", "millions", "error", "order"
        }
        printf "  %-14s %9s %12s %12s %12s %9s %6s\n", row[r, 1], row[r, 9], sprintf("%.4g ms", row[r, 3] * 1000), row[r, 7],
            millions[r], short[r], row[r, 6]
    }
}
