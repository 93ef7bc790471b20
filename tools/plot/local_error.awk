# The error of a step over the time, and the method's estimate of it: the table local_error.tsv of a report.
#
#     local_error SCENE local_error.tsv
BEGIN {
    scene = word(1)
}

FNR > 1 {
    for (c = 2; c <= 3; c++) {
        if ($c + 0 <= 0 || $c ~ /inf|nan/) continue
        points[c] = points[c] $1 " " $c "\n"
        extend("error", $c)
    }
    extend("time", $1)
    step = $5
    method = $6
}

END {
    if (!("error" in least)) exit
    print "# size 900 320"
    put_style()
    print "set logscale y\nset mytics 1"
    put_whole_decades("error")
    printf "set xrange [0:%.9g]\nset xlabel 't, s'\nset ylabel 'error of a step'\n", most["time"]
    put_title(sprintf("%s: the error of a step, %s with a step of %.4g ms", scene, method, 1000 * step))
    style = "with linespoints linewidth 1.2 pointsize 0.5 pointtype "
    add_curve(points[2], style "6 linecolor rgb '#d1590a'", "told")
    add_curve(points[3], style "7 linecolor rgb '#0067a5'", "true")
    put_curves()
}
