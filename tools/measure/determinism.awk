# The table of `make determinism`, of its tab-separated values: a row for a scene with a method, a column for a target.
# `=` has the bits of the host, `N` too, with N instructions or cycles on every step; `N-M` takes from N to M, which
# only the sub-steps of adams may; `N+` takes N and an interrupt of the timer or more, since it is longer than a tick of
# the board; OTHER has other bits; `too large` does not fit onto the target, `refused` is not offered there. Status 1 if
# one is wrong.
BEGIN {
    FS = "\t"
    PART = 500000 # a timer of 24 bits makes a longer tick of several parts, each with an interrupt
    # Row 0 has the names of the columns.
    rows[0] = ""
    hash[""] = "hash"
}
FNR == 1 { next }
{
    row = $1 " " $2
    if (!(row in hash)) {
        rows[++row_count] = row
        hash[row] = "-"
    }
    if (!($3 in width)) {
        columns[++column_count] = cell["", $3] = $3
        width[$3] = length($3)
    }
    if ($4 > most_ticks) most_ticks = $4
    if ($3 == "host") hash[row] = $5
    ticks[$3] = $4
    cell[row, $3] = text()
    if (length(cell[row, $3]) > width[$3]) width[$3] = length(cell[row, $3])
}

function text()
{
    if ($5 ~ /^[a-z_]+$/ && $5 !~ /^[0-9a-f]+$/) {
        wrong += $5 == "failed"
        sub(/_/, " ", $5)
        return $5
    }
    if ($5 != $6) {
        wrong++
        return "OTHER"
    }
    if ($7 == "-") return "="
    if ($7 == $8) return $7
    if ($10 == "longer" || $8 > PART) return $7 "+"
    wrong += $2 != "adams"
    return $7 "-" $8
}

END {
    for (r = 1; r <= row_count; r++) {
        n = length(rows[r])
        if (n > first) first = n
    }
    for (r = 0; r <= row_count; r++) {
        line = sprintf("%-" first "s  %-16s", rows[r], hash[rows[r]])
        for (c = 1; c <= column_count; c++) line = line sprintf("  %" width[columns[c]] "s", cell[rows[r], columns[c]])
        print line
    }
    line = ""
    for (c = 1; c <= column_count; c++) {
        if (ticks[columns[c]] < most_ticks) line = line ", " ticks[columns[c]] " on " columns[c]
    }
    print most_ticks " ticks" line "; wrong: " wrong + 0
    exit wrong > 0
}
