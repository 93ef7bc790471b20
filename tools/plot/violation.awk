# The largest violation over time for every stabilisation, and dashed what it may be: the lines of tools/measure/drift.c, each
# after the name of the stabilisation.
#
#     violation SCENE measured
BEGIN {
    scene = ARGV[1]
    ARGV[1] = ""
    count = split("none baumgarte projection lagrangian", names, " ")
    split("#8c8c8c #d1590a #0067a5 #3c8d2f", its_colour, " ")
}

$2 == "part" && $4 > 0 {
    points[$1] = points[$1] $3 " " $4 "\n"
    last = larger(last, $3 + 0)
    extend($4)
}

$2 == "bound" && $3 > 0 && $3 !~ /inf/ {
    bound[$1] = $3 + 0
    extend($3)
}

function extend(value)
{
    low = low == "" ? value + 0 : smaller(low, value + 0)
    high = larger(high, value + 0)
}

END {
    for (i = 1; i <= count; i++) if (names[i] in points) put_block("points_" names[i], points[names[i]])
    if (!last) exit
    print "# size 900 420"
    put_style()
    print "set logscale y"
    put_decades("y", power_of_ten(decade_below(low)), power_of_ten(decade_above(high)), 1)
    printf "set xrange [0:%.9g]\nset xlabel 't, s'\nset ylabel 'largest violation, m or rad'\n", last
    for (i = 1; i <= count; i++)
        if (names[i] in bound)
            put_block("bound_" names[i], sprintf("0 %.9g\n%.9g %.9g\n", bound[names[i]], last, bound[names[i]]))
    print "set title '" scene ": how far the loops come apart, in float; dashed: the bound' noenhanced"
    print "set key on outside right center noenhanced samplen 2"
    for (i = 1; i <= count; i++) {
        if (!(names[i] in points)) continue
        curves = curves (curves == "" ? "plot" : ",") " $points_" names[i] " with lines linewidth 1.4 linecolor rgb '" \
            its_colour[i] "' title '" names[i] "'"
        if (names[i] in bound)
            curves = curves ", $bound_" names[i] " with lines linewidth 0.7 dashtype 2 linecolor rgb '" its_colour[i] "' notitle"
    }
    print curves
}
