# Not a picture: a table of the differences of two runs at the times that both have, the root of the mean square and the
# largest.
#
#     differences DIRECTORY DIRECTORY
BEGIN {
    read_both()
    for (k = 1; k <= instants; k++) {
        split(line[1, instant[k, 1]], a, ",")
        split(line[2, instant[k, 2]], b, ",")
        for (i = 1; i <= outputs; i++) {
            difference = a[shared[i, 1] + 1] - b[shared[i, 2] + 1]
            squares[i] += difference * difference
            if (size_of(difference) > size_of(largest[i])) {
                largest[i] = difference
                when[i] = a[1]
            }
        }
    }
    printf "%s - %s at %d times, from 0 to %g s\n", run_name[1], run_name[2], instants, a[1]
    printf "%-24s %-8s %14s %14s %10s\n", "output", "unit", "rms", "largest", "at, s"
    for (i = 1; i <= outputs; i++)
        printf "%-24s %-8s %14.6g %14.6g %10g\n", name[1, shared[i, 1]], unit[1, shared[i, 1]], sqrt(squares[i] / instants), largest[i],
            when[i]
}
