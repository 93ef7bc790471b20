# Gain and phase over the frequency: of the model as lines, and as measured on the plant as points. The lines of `linear
# bode`.
#
#     bode SCENE 'INPUT to OUTPUT' bode.tsv
BEGIN {
    title = word(1) ": " word(2)
}

FNR == 1 {
    unit = $3
    sub(/^gain /, "", unit)
    next
}

{
    lines[$1] = lines[$1] $2 " " $3 " " $4 "\n"
    extend("frequency", $2)
    if ($3 > 0) extend("gain", $3)
    extend("phase", $4)
}

# One panel: its column, its label, and where it stands.
function put_panel(column, label, top, bottom, with_frequency)
{
    put_place(0.11, 0.97, top, bottom)
    put_decades("x", least["frequency"], most["frequency"], with_frequency)
    print "set xlabel " (with_frequency ? "'frequency, Hz'" : "''")
    print "set ylabel " quoted(label) " noenhanced"
    add_curve(lines["model"], "using 1:" column " with lines linewidth 1.6 linecolor rgb '#0067a5'", "linear model")
    add_curve(lines["plant"], "using 1:" column " with points pointtype 7 pointsize 0.8 linecolor rgb '#d1590a'", "sines of the plant")
    put_curves()
}

END {
    if (!("gain" in most)) exit
    print "# size 760 520"
    put_style()
    print "set multiplot"
    print "set logscale x"
    print "set logscale y"
    least["gain"] = larger(least["gain"], 1e-12 * most["gain"])
    put_whole_decades("gain")
    print "set key on top right noenhanced samplen 2"
    print "set title " quoted(title) " noenhanced"
    put_panel(2, "gain, " unit, 0.92, 0.52, 0)
    print "unset title\nset key off\nunset logscale y"
    put_range("y", least["phase"], most["phase"])
    put_panel(3, "phase, deg", 0.47, 0.11, 1)
    print "unset multiplot"
}
