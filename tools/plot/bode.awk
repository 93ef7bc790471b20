# Gain and phase over the frequency: of the model as lines, and as measured on the plant as points. The lines of `linear bode`.
#
#     bode SCENE 'INPUT to OUTPUT' bode.tsv
BEGIN {
    FS = "\t"
    title = ARGV[1] ": " ARGV[2]
    ARGV[1] = ARGV[2] = ""
    WIDTH = 760
    HEIGHT = 520
}

FNR == 1 {
    unit = $3
    sub(/^gain /, "", unit)
    next
}

{
    lines[$1] = lines[$1] $2 " " $3 " " $4 "\n"
    low = low == "" ? $2 + 0 : smaller(low, $2 + 0)
    high = larger(high, $2 + 0)
    if ($3 > 0) {
        least = least == "" ? $3 + 0 : smaller(least, $3 + 0)
        most = larger(most, $3 + 0)
    }
    first = first == "" ? $4 + 0 : smaller(first, $4 + 0)
    last = last == "" ? $4 + 0 : larger(last, $4 + 0)
}

# One panel: its column, its label, and where it stands.
function put_panel(column, label, top, bottom, with_frequency)
{
    put_place(0.11, 0.97, top, bottom)
    put_decades("x", low, high, with_frequency)
    print "set xlabel " (with_frequency ? "'frequency, Hz'" : "''")
    print "set ylabel " quoted(label) " noenhanced"
    printf "plot $model using 1:%d with lines linewidth 1.6 linecolor rgb '#0067a5' title 'linear model'", column
    if ("plant" in lines)
        printf ", $plant using 1:%d with points pointtype 7 pointsize 0.8 linecolor rgb '#d1590a' title 'sines of the plant'", column
    print ""
}

END {
    if (most == "") exit
    printf "# size %d %d\n", WIDTH, HEIGHT
    for (from in lines) put_block(from, lines[from])
    put_style()
    print "set multiplot"
    print "set logscale x"
    print "set logscale y"
    least = larger(least, 1e-12 * most)
    put_decades("y", power_of_ten(decade_below(least)), power_of_ten(decade_above(most)), 1)
    print "set key on top right noenhanced samplen 2"
    print "set title " quoted(title) " noenhanced"
    put_panel(2, "gain, " unit, 0.92, 0.52, 0)
    print "unset title\nset key off\nunset logscale y"
    put_range("y", first, last)
    put_panel(3, "phase, deg", 0.47, 0.11, 1)
    print "unset multiplot"
}
