# The largest error of a run in its bound, and how far off the decimal numbers of a trace may put it, which are as short
# as they tell one float from another: reads columns (columns.awk), rows of the reference, each `every` rows of the run,
# and trace.csv, whose columns begin with t. Prints nothing where the run has fewer rows than are judged.
#
#     awk -v every=ROWS -v judged=ROWS -f measured.awk COLUMNS REFERENCE trace.csv
FNR == 1 { file++ }
file == 1 {
    split($0, cell, "|")
    value[++bounds] = cell[2] + 0
    parts[bounds] = split(cell[3], part, ",")
    for (i = 1; i <= parts[bounds]; i++) column[bounds, i] = part[i] + 2
    angle[bounds] = cell[7] == "rad"
    next
}
file == 2 { there[FNR - 1] = $0; next }
FNR == 1 {
    FS = ","
    next
}
(FNR - 2) % every == 0 {
    split($0, y, ",")
    row = (FNR - 2) / every
    if (row > judged || !(row in there)) next
    rows++
    split(there[row], x, " ")
    at = 0
    for (b = 1; b <= bounds; b++) {
        sum = 0
        for (i = 1; i <= parts[b]; i++) {
            d = y[column[b, i]] - x[++at]
            size = x[at] < 0 ? -x[at] : x[at]
            if (size / value[b] > largest) largest = size / value[b]
            # Angles may be turns apart.
            if (angle[b] && d * d > 36) { turn = 6.283185307179586; d -= turn * int(d / turn + (d > 0 ? 0.5 : -0.5)) }
            sum += d * d
        }
        if (sqrt(sum) / value[b] > most) most = sqrt(sum) / value[b]
    }
}
END { if (rows > judged) printf "%.6g %.3g\n", most, 1e-4 + 1.2e-7 * largest }
