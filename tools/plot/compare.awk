# The outputs that two runs have in common, a panel for each, one run over the other.
#
#     compare DIRECTORY DIRECTORY
function put_panel(i, top, bottom, a, b, r)
{
    a = shared[i, 1]
    b = shared[i, 2]
    put_range("y", smaller(least[1, a], least[2, b]), larger(most[1, a], most[2, b]))
    put_place(0.09, 0.975, top, bottom)
    print "set label 1 " label(1, a, name[1, a]) " noenhanced at graph 0, 1 offset 0, 0.6 left font ',11'"
    print i == outputs ? "set xlabel 't, s'\nset format x '%g'" : "unset xlabel\nset format x ''"
    for (r = 1; r <= 2; r++)
        printf "%s $run%d_%d with lines linewidth %s linecolor rgb '%s' title %s noenhanced", r == 1 ? "plot" : ",", r - 1, i - 1,
            r == 1 ? "2.2" : "1", colour[r], quoted(run_name[r])
    print ""
}

BEGIN {
    # In pixels: the picture, and above, of and below the panels.
    WIDTH = 900; HEAD = 60; PANEL = 118; GAP = 34; FOOT = 36
    read_both()
    total = HEAD + PANEL * outputs + FOOT
    put_style()
    for (i = 1; i <= outputs; i++)
        for (r = 1; r <= 2; r++) put_block("run" r - 1 "_" i - 1, curve[r, shared[i, r]])
    printf "# size %d %d\nset multiplot\nset key on at screen 0.975, %.5f right top horizontal samplen 1.5\n", WIDTH, total, 1 - 8 / total
    printf "set xrange [0:%.9g]\n", larger(most[1, 0], most[2, 0])
    for (i = 1; i <= outputs; i++) {
        top = HEAD + PANEL * (i - 1)
        put_panel(i, 1 - top / total, 1 - (top + PANEL - GAP) / total)
        print "set key off"
    }
    print "unset multiplot"
}
