# Gnuplot's commands for the picture of make drift: the largest violation over time, a line for each stabilisation; thin,
# what it may be.
#
# Input: the lines of drift.c, each after the name of the stabilisation.
BEGIN {
    colour["none"] = "#8c8c8c"
    colour["baumgarte"] = "#d1590a"
    colour["projection"] = "#0067a5"
    colour["lagrangian"] = "#3c8d2f"
}

!($1 in seen) {
    seen[$1] = 1
    name[++count] = $1
}

$2 == "part" && $4 > 0 {
    points[$1] = points[$1] $3 " " $4 "\n"
    last = $3 > last ? $3 : last
}

$2 == "bound" && $3 != "inf" { bound[$1] = $3 }

END {
    for (i = 1; i <= count; i++)
        printf "$p%d << END\n%sEND\n", i, points[name[i]]
    print "# size 900 420"
    print "set border 3 linewidth 0.8 linecolor rgb '#555555'"
    print "set tics nomirror out scale 0.6 textcolor rgb '#333333'"
    print "set grid linetype 1 linecolor rgb '#d4d4d4' linewidth 0.7"
    print "set logscale y\nset format y '10^{%T}'\nset yrange [1e-8:10]\nset mytics 1"
    print "set xrange [0:" last "]\nset xlabel 't, s'\nset ylabel 'largest violation, m or rad'"
    print "set title '" scene ": how far the loops come apart, in float; thin: the bound' noenhanced"
    print "set key outside right center noenhanced samplen 2"
    for (i = 1; i <= count; i++) {
        printf "%s $p%d with lines linewidth 1.4 linecolor rgb '%s' title '%s'", i == 1 ? "plot" : ",", i,
            colour[name[i]], name[i]
        if (name[i] in bound)
            printf ", %s with lines linewidth 0.7 dashtype 2 linecolor rgb '%s' notitle", bound[name[i]], colour[name[i]]
    }
    print ""
}
