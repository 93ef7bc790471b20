# The histogram of execution times of steps, from 0 to the period, in the bins of the summary: lines `histogram 0 to
# 31250 ns: 9999`, and of the last bin `histogram from 968750 ns: 1`. Nothing where the scene asks for no histogram.
#
#     histogram DIRECTORY
BEGIN {
    BINS = 32
    below_one = 0.5 # where the bars begin: a bin of one tick has a height too
    path = ARGV[1] "/summary.txt"
    while (next_line(path)) {
        cells = split(read_line, cell, " ")
        said[1, cell[1]] = cell[2]
        if (cell[1] != "histogram") continue
        is_last = cell[2] == "from"
        width = is_last ? cell[3] / (BINS - 1) : cell[4] - cell[2]
        bin = int((is_last ? cell[3] : cell[2]) / width + 0.5)
        ticks[bin] = cell[cells]
        highest = larger(highest, cell[cells] + 0)
        measure = substr(cell[cells - 1], 1, length(cell[cells - 1]) - 1)
    }
    if (!highest) exit
    if (measure == "ns") { width *= 1e-3; measure = "us" }
    for (bin = 0; bin < BINS; bin++) {
        if (ticks[bin] + 0 == 0) continue
        from = bin * width
        to = from + width
        bars = bars sprintf("%.9g %.9g %.9g %.9g %.9g %.9g\n", (from + to) / 2, ticks[bin], from, to, below_one, ticks[bin])
        tops = tops sprintf("%.9g %.9g\n%.9g %.9g\n\n", from, ticks[bin], to, ticks[bin])
    }
    print "# size 720 360"
    put_style()
    put_block("bars", bars)
    put_block("tops", tops)
    print "set logscale y"
    put_decades("y", below_one, 2 * highest, 1)
    put_range("x", 0, BINS * width)
    printf "set xrange [0:%.9g]\n", BINS * width
    print "set xlabel 'execution of a step, " measure ", to the end of the period; the last bin is open'"
    print "set ylabel 'ticks'"
    print "set title " title(1) " noenhanced"
    printf "plot $bars using 1:2:3:4:5:6 with boxxyerror fill solid 0.5 noborder linecolor rgb '%s', " \
        "$tops with lines linewidth 1.6 linecolor rgb '%s'\n", colour[1], colour[1]
}
