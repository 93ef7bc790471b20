# The error over the time, of the scene's method at its step, in each kind: the table growth.tsv of a report.
#
#     growth SCENE growth.tsv
BEGIN {
    scene = word(1)
    count = split("float compensated double", names, " ")
    split("#d1590a #3c8d2f #0067a5", its_colour, " ")
}

FNR > 1 && $5 > 0 && $5 !~ /inf|nan/ {
    points[$1] = points[$1] $4 " " $5 "\n"
    method = $2
    step = $3
    extend("time", $4)
    extend("error", $5)
}

END {
    if (!("time" in least)) exit
    print "# size 900 380"
    put_style()
    print "set logscale xy\nset mxtics 1\nset mytics 1"
    for (at = most["time"]; at > least["time"] / 1.1; at /= 2) list = sprintf("'%.6g' %.9g", at, at) (list == "" ? "" : ", ") list
    printf "set xrange [%.4g:%.4g]\nset xtics (%s)\n", least["time"] / 1.2, most["time"] * 1.2, list
    put_whole_decades("error")
    print "set xlabel 't, s'\nset ylabel 'error of the state'"
    put_title(sprintf("%s: how the error grows, %s with a step of %.4g ms", scene, method, 1000 * step))
    for (i = 1; i <= count; i++)
        add_curve(points[names[i]], "with linespoints linewidth 1.4 pointtype 7 pointsize 0.5 linecolor rgb '" its_colour[i] "'", names[i])
    put_curves()
}
