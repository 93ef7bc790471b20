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

function put_panel(i, g, m, c, low, high, letters)
{
    low = least[1, first[1, g]]
    high = most[1, first[1, g]]
    letters = members[1, g] == 4 ? "wxyz" : "xyz"
    print (members[1, g] > 1 ? "set key on at graph 1, 1.02 right bottom horizontal samplen 1.5" : "set key off")
    for (m = 0; m < members[1, g]; m++) {
        c = first[1, g] + m
        low = smaller(low, least[1, c])
        high = larger(high, most[1, c])
        add_curve(curve[1, c], "with lines linewidth 1.2 linecolor rgb '" colour[m + 1] "'", substr(letters, m + 1, 1))
    }
    put_signal_panel(i, label(1, first[1, g], stem[1, g]), low, high)
}

BEGIN {
    read_run(1, ARGV[1], 300)
    begin_panels(ARGC > 2 ? ARGC - 2 : groups[1])
    printf "set label 2 %s noenhanced at screen 0.09, %.5f left font ',14'\n", title(1), 1 - 22 / height
    printf "set xrange [0:%.9g]\n", most[1, 0]
    for (i = 1; i <= panels; i++) {
        put_panel(i, ARGC > 2 ? group_called(ARGV[1 + i]) : i)
        print "unset label 2"
    }
    print "unset multiplot"
}
