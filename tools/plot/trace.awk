# All outputs of a run over time, or those of these names, a panel for each group.
#
#     trace DIRECTORY [OUTPUT...]

# The number of the group of this name.
function group_called(text, g)
{
    for (g = 1; g <= groups[1]; g++)
        if (stem[1, g] == text) return g
    fail("plot: no output is called '" text "'")
}

function put_panel(g, top, bottom, last, c, i, low, high, letters)
{
    c = first[1, g]
    low = least[1, c]
    high = most[1, c]
    for (i = 1; i < members[1, g]; i++) {
        low = smaller(low, least[1, c + i])
        high = larger(high, most[1, c + i])
    }
    put_range("y", low, high)
    put_place(0.09, 0.975, top, bottom)
    print "set label 1 " label(1, c, stem[1, g]) " noenhanced at graph 0, 1 offset 0, 0.6 left font ',11'"
    print last ? "set xlabel 't, s'\nset format x '%g'" : "unset xlabel\nset format x ''"
    print (members[1, g] > 1 ? "set key on at graph 1, 1.02 right bottom horizontal samplen 1.5" : "set key off")
    letters = members[1, g] == 4 ? "wxyz" : "xyz"
    for (i = 0; i < members[1, g]; i++)
        printf "%s $column%d with lines linewidth 1.2 linecolor rgb '%s' title '%s'", i ? "," : "plot", c + i, colour[i + 1],
            substr(letters, i + 1, 1)
    print ""
}

BEGIN {
    # In pixels: the picture, and above, of and below the panels.
    WIDTH = 900; HEAD = 60; PANEL = 118; GAP = 34; FOOT = 36
    read_run(1, ARGV[1], 300)
    panels = ARGC > 2 ? ARGC - 2 : groups[1]
    for (i = 1; i <= panels; i++) chosen[i] = ARGC > 2 ? group_called(ARGV[1 + i]) : i
    total = HEAD + PANEL * panels + FOOT
    put_style()
    for (i = 1; i <= panels; i++)
        for (m = 0; m < members[1, chosen[i]]; m++) {
            c = first[1, chosen[i]] + m
            put_block("column" c, curve[1, c])
        }
    printf "# size %d %d\nset multiplot\n", WIDTH, total
    printf "set label 2 %s noenhanced at screen 0.09, %.5f left font ',14'\n", title(1), 1 - 22 / total
    printf "set xrange [0:%.9g]\n", most[1, 0]
    for (i = 1; i <= panels; i++) {
        top = HEAD + PANEL * (i - 1)
        put_panel(chosen[i], 1 - top / total, 1 - (top + PANEL - GAP) / total, i == panels)
        print "unset label 2"
    }
    print "unset multiplot"
}
