# The largest violation over time for every stabilisation, and its bound as a dashed line: the lines of
# tools/measure/drift.c, each after the name of the stabilisation.
#
#     violation SCENE measured
BEGIN {
    FS = " "
    scene = word(1)
    count = split("none baumgarte projection lagrangian", names, " ")
    split("#8c8c8c #d1590a #0067a5 #3c8d2f", its_colour, " ")
}

$2 == "part" && $4 > 0 {
    points[$1] = points[$1] $3 " " $4 "\n"
    extend("time", $3)
    extend("violation", $4)
}

$2 == "bound" && $3 > 0 && $3 !~ /inf/ {
    bound[$1] = $3
    extend("violation", $3)
}

END {
    if (!("time" in most)) exit
    print "# size 900 420"
    put_style()
    print "set logscale y"
    put_whole_decades("violation")
    printf "set xrange [0:%.9g]\nset xlabel 't, s'\nset ylabel 'largest violation, m or rad'\n", most["time"]
    put_title(scene ": how far the loops come apart, in float; dashed: the bound")
    for (i = 1; i <= count; i++) {
        if (!(names[i] in points)) continue
        add_curve(points[names[i]], "with lines linewidth 1.4 linecolor rgb '" its_colour[i] "'", names[i])
        if (names[i] in bound)
            add_curve(sprintf("0 %.9g\n%.9g %.9g\n", bound[names[i]], most["time"], bound[names[i]]),
                "with lines linewidth 0.7 dashtype 2 linecolor rgb '" its_colour[i] "'")
    }
    put_curves()
}
