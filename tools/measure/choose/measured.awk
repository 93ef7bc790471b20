# The largest error of a run in its bound, and the error that the decimal numbers of a trace may add, which are just
# long enough to distinguish floats: reads columns (columns.awk), rows of the reference, each `every` rows of the run,
# and trace.csv, whose columns begin with t. Prints nothing where the run has fewer rows than are judged.
#
#     awk -v every=ROWS -v judged=ROWS -f bound.awk -f measured.awk COLUMNS REFERENCE trace.csv
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
    for (b = 1; b <= bounds; b++) sum[b] = 0
    for (i = 1; i <= columns; i++) {
        b = bound_of[i]
        size = (x[i] < 0 ? -x[i] : x[i]) / value[b]
        if (size > largest) largest = size
        sum[b] += turned(y[column[i] + 2] - x[i], b) ^ 2
    }
    for (b = 1; b <= bounds; b++) if (sqrt(sum[b]) / value[b] > most) most = sqrt(sum[b]) / value[b]
}
END { if (rows > judged) printf "%.6g %.3g\n", most, 1e-4 + 1.2e-7 * largest }
