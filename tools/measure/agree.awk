# Lines of the reference from those of drive.c, of one method at each of `times`, then of another: the time, how far the
# two states are apart (2-norm), and the first of them. They agree if that is at most `tolerance` (1 + the norm of the
# state). Status 1 unless all do; of the others the file `unlike` has the time and how far, where it is given.
#
#     awk -v times='TIME...' -v tolerance=TOLERANCE [-v unlike=FILE] -f agree.awk

# compare LINE LINE: sets state, apart, and agrees.
function compare(line, other, first, second, cells, i, square, off)
{
    cells = split(line, first, " ")
    agrees = split(other, second, " ") == cells && cells > 2
    state = ""
    apart = square = 0
    for (i = 3; i <= cells; i++) {
        state = state " " first[i]
        square += first[i] * first[i]
        off += (first[i] - second[i]) ^ 2
        if (first[i] second[i] ~ /inf|nan/) agrees = 0
    }
    apart = agrees && off < 1e300 ? sqrt(off) : "inf"
    agrees = agrees && apart != "inf" && apart <= tolerance * (1 + sqrt(square))
}

{ line[NR] = $0 }
END {
    count = split(times, time, " ")
    for (i = 1; i <= count; i++) {
        compare(line[i], line[count + i])
        if (apart != "inf") apart = sprintf("%.3g", apart)
        if (agrees) print time[i], apart state
        else {
            unlike_any = 1
            if (unlike != "") print time[i], apart >unlike
        }
    }
    exit unlike_any || NR != 2 * count
}
