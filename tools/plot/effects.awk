# The cost and the influence of each effect of a scene, as bars: the table of tools/measure/price.awk. Its lines of kind
# `whole` and `base` are the scene with all effects and without any; the effects stand above a line without a name.
#
#     effects SCENE TARGET effects.tsv
BEGIN {
    scene = word(1)
    target = word(2)
    ROW = 44; ABOVE = 84; BELOW = 28 # pixels
    split("#0067a5 #d1590a", its_colour, " ")
}

NR == 1 { for (i = 1; i <= NF; i++) column[$i] = i; next }
{ if ($2 == "whole" || $2 == "base") step_of[$2] = $column["step"] }
$1 == "" { ended = 1 }
!ended {
    text[++rows] = $1
    for (key in column) value[key, rows] = $column[key]
}

# The bars of a column, each with its number at its end; so many share a row.
function bars_of(key, bar, bars, times, row, x, top, points)
{
    for (row = 1; row <= rows; row++) {
        x = times * value[key, row]
        top = row - 0.35 + bar * 0.7 / bars
        points = points sprintf("%.9g %.4g %.9g %.9g %.4g %.4g %.9g\n", x, top + 0.35 / bars, smaller(0, x), larger(0, x), top,
            top + 0.7 / bars, larger(0, x))
        low = smaller(low, x)
        high = larger(high, x)
    }
    return points
}

# A panel of one column, or of two, each with its name in the legend: "KEY of KEY". The shown number is that of the
# table times `times`, at the end of a bar in this format; the panel reaches from `left` to `right` of the picture.
function put_panel(number, head, keys, times, format, left, right, key, bars, bar, width, row, tics, points)
{
    bars = split(keys, key, " ")
    low = high = 0
    for (bar = 0; bar < bars; bar++) {
        points = bars_of(key[bar + 1], bar, bars, times)
        add_curve(points, "using 1:2:3:4:5:6 with boxxyerror fill solid noborder linecolor rgb '" its_colour[bar + 1] "'",
            (bars > 1 ? "of " (key[bar + 1] ~ /step|tick/ ? "a " : "") key[bar + 1] : ""))
        add_curve(points, "using 7:2:(sprintf(' " format "', $1)) with labels left")
    }
    width = high > low ? high - low : 1
    put_range("x", low, low + 1.2 * width)
    printf "set xrange [%.9g:%.9g]\n", (low < 0 ? low - 0.1 * width : 0), low + 1.25 * width
    put_place(left, right, 1 - ABOVE / height, BELOW / height)
    printf "set label 2 '%s' at screen %.4g, screen %.4g center\n", head, (left + right) / 2, 1 - 46 / height
    printf "set key on at screen %.4g, screen %.4g horizontal center top samplen 1\n", (left + right) / 2, 1 - 58 / height
    for (row = 1; row <= rows; row++) tics = tics (row > 1 ? ", " : "") quoted(number ? "" : text[row]) " " row
    printf "set yrange [%.1f:0.5]\nset ytics (%s) scale 0 noenhanced\n", rows + 0.5, tics
    put_curves()
}

END {
    if (!rows) exit
    height = ROW * rows + ABOVE + BELOW
    print "# size 900 " height
    put_style()
    print "set grid noytics"
    printf "set label 1 %s at screen 0.5, screen %.4g center noenhanced\n",
        quoted(sprintf("%s on the %s: of %.0f instructions of a step, %.0f are without any effect", scene,
            target == "host" ? target : "Cortex-M4F", step_of["whole"], step_of["base"])), 1 - 18 / height
    print "set multiplot"
    put_panel(0, "instructions", "step tick", 1, "%.0f", 0.17, 0.43)
    print "unset label 1"
    put_panel(1, "bytes", "text memory", 1, "%.0f", 0.46, 0.72)
    put_panel(2, "largest change of an output, rms, %", "part", 100, "%.3g", 0.75, 0.98)
    print "unset multiplot"
}
