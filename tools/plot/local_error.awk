# The error of a step over the time, and what the method tells of it: the table local_error.tsv of a report.
#
#     local_error SCENE local_error.tsv
BEGIN {
    FS = "\t"
    scene = ARGV[1]
    ARGV[1] = ""
    names[2] = "told"
    names[3] = "true"
    its_colour[2] = "#d1590a"
    its_colour[3] = "#0067a5"
}

FNR > 1 {
    for (c = 2; c <= 3; c++) {
        if ($c + 0 <= 0 || $c ~ /inf|nan/) continue
        points[c] = points[c] $1 " " $c "\n"
        low = low == "" ? $c + 0 : smaller(low, $c + 0)
        high = larger(high, $c + 0)
    }
    last = larger(last, $1 + 0)
    step = $5
    method = $6
}

END {
    if (low == "") exit
    for (c = 2; c <= 3; c++) if (c in points) put_block("points_" names[c], points[c])
    print "# size 900 320"
    put_style()
    print "set logscale y\nset mytics 1"
    put_decades("y", power_of_ten(decade_below(low)), power_of_ten(decade_above(high)), 1)
    printf "set xrange [0:%.9g]\nset xlabel 't, s'\nset ylabel 'error of a step'\n", last
    printf "set title '%s: the error of a step, %s with a step of %.4g ms' noenhanced\n", scene, method, 1000 * step
    print "set key on outside right center noenhanced samplen 2"
    for (c = 2; c <= 3; c++)
        if (c in points)
            curves = curves (curves == "" ? "plot" : ",") " $points_" names[c] " with linespoints linewidth 1.2 pointtype " (c == 2 ? 6 : 7) \
                " pointsize 0.5 linecolor rgb '" its_colour[c] "' title '" names[c] "'"
    print curves
}
