# A report's tables as text, from its tab-separated values (tools/report/errors.awk).
BEGIN {
    FS = "\t"
    title["float"] = "float, instructions of the Cortex-M4F"
    title["compensated"] = "float with compensated sums, instructions of the Cortex-M4F"
    title["double"] = "double, instructions of this machine"
}

NR == 1 { next }

$9 != "-" {
    varied = varied sprintf("  %-14s %9s %12s %12d %12.4g %9s %6s\n", $1, $9, sprintf("%.4g ms", $3 * 1000), $7, $8 / 1e6,
        short($5), $6)
    next
}

{
    if (!(($1, $2) in instructions))
        row[++rows] = $1 SUBSEP $2
    if (!($3 in at))
        at[$3] = ++columns
    i = nearest($3)
    instructions[$1, $2] = $7
    error[$1, $2, i] = $5
    order[$1, $2, i] = $6
    second[$1, $2, i] = $8
}

# The column of a step: a float's differs from a double's in its last digits only.
function nearest(step,    i) {
    for (i = 1; i <= shown; i++)
        if (step / width[i] > 0.999 && step / width[i] < 1.001)
            return i
    width[++shown] = step
    return shown
}

function head(text,    i) {
    printf "  %-14s %8s", "", text
    for (i = 1; i <= shown; i++)
        printf " %15s", sprintf("%.4g ms", width[i] * 1000)
    print ""
}

function tables(    r, key, k, n, i) {
    for (r = 1; r <= rows; r++) {
        split(row[r], key, SUBSEP)
        if (key[1] != kind) {
            kind = key[1]
            kinds[++n] = kind
        }
    }
    print "Error over instructions: the instructions of a step, then at each step millions of them in a second of the"
    print "plant's time and the error"
    for (k = 1; k <= n; k++) {
        print "\n" title[kinds[k]]
        head("a step")
        for (r = 1; r <= rows; r++) {
            split(row[r], key, SUBSEP)
            if (key[1] != kinds[k])
                continue
            printf "  %-14s %8d", key[2], instructions[row[r]]
            for (i = 1; i <= shown; i++)
                printf " %15s", sprintf("%.4g %7s", second[row[r], i] / 1e6, short(error[row[r], i]))
            print ""
        }
    }
    print "\nError over the step, with the order observed from the step before"
    for (k = 1; k <= n; k++) {
        print "\n" kinds[k]
        head("")
        for (r = 1; r <= rows; r++) {
            split(row[r], key, SUBSEP)
            if (key[1] != kinds[k])
                continue
            printf "  %-14s %8s", key[2], ""
            for (i = 1; i <= shown; i++)
                printf " %15s", sprintf("%9s %5s", error[row[r], i], order[row[r], i])
            print ""
        }
    }
}

function short(number) {
    return number == "inf" ? number : sprintf("%.1e", number)
}

END {
    if (rows > 0)
        tables()
    if (varied != "") {
        print (rows > 0 ? "\n" : "") "adams, whose steps vary: their mean, the instructions of one, millions of them in a second of"
        print "the plant's time, the error, and its order in the tolerance\n"
        printf "  %-14s %9s %12s %12s %12s %9s %6s\n%s", "", "tolerance", "a step", "instructions", "millions", "error", "order", varied
    }
}
