# How near a run comes to singular positions of its closed loops, and how far these come apart: the table singular.tsv
# of a report.
#
#     singular SCENE singular.tsv
BEGIN {
    scene = word(1)
    split("least pivot:largest change of a pivot in a step:violation, m or rad", title, ":")
    split("#0067a5 #c2185b #d1590a", its_colour, " ")
}

FNR > 1 {
    last = $1 + 0
    for (i = 1; i <= 3; i++) {
        if (!($(i + 1) + 0 > 0)) continue
        points[i] = points[i] $1 " " $(i + 1) "\n"
        extend(i, $(i + 1))
    }
}

END {
    if (!last) exit
    print "# size 900 560\nset multiplot"
    put_style()
    print "set logscale y\nset mytics 1"
    printf "set xrange [0:%.9g]\n", last
    print "set label 2 " quoted(scene ": nearness to singular positions, and how far loops come apart") " noenhanced at screen 0.11, 0.965 left font ',14'"
    for (i = 1; i <= 3; i++) {
        if (!(i in points)) continue
        put_place(0.11, 0.975, 1.185 - 0.29 * i, 1.185 - 0.29 * i - 0.19)
        most[i] *= 1.0001
        put_whole_decades(i)
        put_head(title[i])
        put_time(i == 3)
        add_curve(points[i], "with lines linewidth 1.3 linecolor rgb '" its_colour[i] "'", title[i])
        put_curves()
        print "unset label 2"
    }
    print "unset multiplot"
}
