# The outputs that two runs have in common, a panel for each, one run over the other.
#
#     compare DIRECTORY DIRECTORY
function put_panel(i, a, b, r)
{
    a = shared[i, 1]
    b = shared[i, 2]
    for (r = 1; r <= 2; r++)
        add_curve(curve[r, shared[i, r]], "with lines linewidth " (r == 1 ? "2.2" : "1") " linecolor rgb '" colour[r] "'", run_name[r])
    put_signal_panel(i, label(1, a, name[1, a]), smaller(least[1, a], least[2, b]), larger(most[1, a], most[2, b]))
}

BEGIN {
    read_both()
    begin_panels(outputs)
    printf "set key on at screen 0.975, %.5f right top horizontal samplen 1.5 noenhanced\n", 1 - 8 / height
    printf "set xrange [0:%.9g]\n", larger(most[1, 0], most[2, 0])
    for (i = 1; i <= outputs; i++) {
        put_panel(i)
        print "set key off"
    }
    print "unset multiplot"
}
