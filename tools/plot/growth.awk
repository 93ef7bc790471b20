# The error over the time, of the scene's method at its step, in each kind: the table growth.tsv of a report.
#
#     growth SCENE growth.tsv
BEGIN {
    FS = "\t"
    scene = ARGV[1]
    ARGV[1] = ""
    count = split("float compensated double", names, " ")
    split("#d1590a #3c8d2f #0067a5", its_colour, " ")
}

FNR > 1 && $5 > 0 && $5 !~ /inf|nan/ {
    points[$1] = points[$1] $4 " " $5 "\n"
    method = $2
    step = $3
    extend("time", $4 + 0)
    extend("error", $5 + 0)
}

function extend(what, value)
{
    if (!(what in least) || value < least[what]) least[what] = value
    most[what] = larger(most[what], value)
}

END {
    if (!("time" in least)) exit
    for (i = 1; i <= count; i++) if (names[i] in points) put_block("points_" names[i], points[names[i]])
    print "# size 900 380"
    put_style()
    print "set logscale xy\nset mxtics 1\nset mytics 1"
    for (at = most["time"]; at > least["time"] / 1.1; at /= 2) list = sprintf("'%.6g' %.9g", at, at) (list == "" ? "" : ", ") list
    printf "set xrange [%.4g:%.4g]\nset xtics (%s)\n", least["time"] / 1.2, most["time"] * 1.2, list
    put_decades("y", power_of_ten(decade_below(least["error"])), power_of_ten(decade_above(most["error"])), 1)
    print "set xlabel 't, s'\nset ylabel 'error of the state'"
    printf "set title '%s: how the error grows, %s with a step of %.4g ms' noenhanced\n", scene, method, 1000 * step
    print "set key on outside right center noenhanced samplen 2"
    for (i = 1; i <= count; i++)
        if (names[i] in points)
            curves = curves (curves == "" ? "plot" : ",") " $points_" names[i] \
                " with linespoints linewidth 1.4 pointtype 7 pointsize 0.5 linecolor rgb '" its_colour[i] "' title '" names[i] "'"
    print curves
}
