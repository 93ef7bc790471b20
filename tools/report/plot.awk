# Gnuplot's commands for the picture of a report, from its tab-separated values (tools/report/errors.awk): above error
# over instructions per second of the plant's time, below error over the step; a column for each kind, a line for each
# method. Nothing where no method errs, as at rest.
BEGIN {
    FS = "\t"
    title["float"] = "float"
    title["compensated"] = "float, compensated sums"
    title["double"] = "double"
    machine["float"] = machine["compensated"] = "Cortex-M4F"
    machine["double"] = "host"
    # One colour for a family of methods, one mark for each of a family.
    look("euler", "#8c8c8c", 7)
    look("semi_implicit", "#8c8c8c", 6)
    look("heun", "#b8860b", 7)
    look("rk4", "#0067a5", 7)
    look("ab4", "#d1590a", 7)
    look("abm4", "#3c8d2f", 7)
    look("abm4_pec", "#3c8d2f", 6)
    look("abm4_pecece", "#3c8d2f", 9)
    look("bdf4", "#8e3a8e", 7)
    look("rosenbrock", "#c2185b", 5)
    look("adams", "#008b8b", 5)
}

function look(method, its_colour, its_mark) {
    colour[method] = its_colour
    mark[method] = its_mark
}

NR == 1 { next }

{
    if (!($1 in kind_seen)) {
        kind_seen[$1] = 1
        kind[++kinds] = $1
    }
    if (!($2 in method_seen)) {
        method_seen[$2] = 1
        method[++methods] = $2
    }
}

# An error that is not finite, or beyond what means something, has no place.
$5 == "inf" || $5 + 0 <= 0 || $5 + 0 > 100 { next }

{
    points[$1, $2] = points[$1, $2] $8 " " $5 " " $3 * 1000 "\n"
    low = low == "" || $5 + 0 < low ? $5 + 0 : low
    high = $5 + 0 > high ? $5 + 0 : high
    fewest = fewest == "" || $8 + 0 < fewest ? $8 + 0 : fewest
    most = $8 + 0 > most ? $8 + 0 : most
    if ($9 == "-" || !coarsest)
        coarsest = $3 > coarsest ? $3 + 0 : coarsest
    shortest = shortest == "" || $3 + 0 < shortest ? $3 + 0 : shortest
    longest = $3 + 0 > longest ? $3 + 0 : longest
}

# A panel: place from 0 to 1, and which column of the data its error is over.
function panel(k, left, right, top, bottom, x,    m, n) {
    printf "set lmargin at screen %.4f\nset rmargin at screen %.4f\n", left, right
    printf "set tmargin at screen %.4f\nset bmargin at screen %.4f\n", top, bottom
    print "set ylabel " (k == 1 ? "'error after " time " s' offset 1, 0" : "''")
    print "set format y " (k == 1 ? "'10^{%T}'" : "''")
    n = 0
    for (m = 1; m <= methods; m++)
        if ((kind[k], method[m]) in points)
            printf "%s $p%d_%d using %d:2 %s notitle", n++ ? "," : "plot", k, m, x, line(method[m])
    print ""
}

function line(method) {
    return "with linespoints linewidth 1.1 pointsize 0.55 pointtype " mark[method] " linecolor rgb '" colour[method] "'"
}

# The steps of fixed methods in ms, and by twos whatever lies beyond them; every other one is told.
function halves(    step, text, i) {
    for (step = coarsest; 2 * step <= 1.25 * longest; step *= 2)
        ;
    for (; step >= 0.8 * shortest; step /= 2)
        text = text sprintf("%s%s %.4g", text == "" ? "" : ", ", i++ % 2 ? "''" : "'%g'", 1000 * step)
    return text
}

# The names of the methods below the panels, in a panel of its own with nothing in it.
function legend(    m) {
    print "unset border\nunset tics\nunset grid\nunset xlabel\nunset ylabel\nunset logscale\nset xrange [0:1]\nset yrange [0:1]"
    print "set lmargin at screen 0.06\nset rmargin at screen 0.985\nset tmargin at screen 0.105\nset bmargin at screen 0.01"
    print "set key on center center horizontal maxcols 6 samplen 2 noenhanced"
    for (m = 1; m <= methods; m++)
        printf "%s -1 %s title '%s'", m == 1 ? "plot" : ",", line(method[m]), method[m]
    print ""
}

END {
    if (!coarsest)
        exit
    for (k = 1; k <= kinds; k++)
        for (m = 1; m <= methods; m++)
            if ((kind[k], method[m]) in points)
                printf "$p%d_%d << END\n%sEND\n", k, m, points[kind[k], method[m]]
    print "# size 900 640"
    print "set multiplot"
    print "set border 3 linewidth 0.8 linecolor rgb '#555555'"
    print "set tics nomirror out scale 0.6 textcolor rgb '#333333'"
    print "set grid linetype 1 linecolor rgb '#d4d4d4' linewidth 0.7"
    print "set logscale xy"
    print "set ytics 1000\nset mxtics 1\nset mytics 1"
    print "set key off"
    print "set label 1 '" scene ": error and its price' noenhanced at screen 0.075, 0.962 left font ',14'"
    printf "set yrange [%.3g:%.3g]\n", low / 3, high * 3
    width = (0.985 - 0.075) / kinds
    for (k = 1; k <= kinds; k++) {
        left = 0.075 + (k - 1) * width
        print "set label 2 '" title[kind[k]] "' at graph 0, 1 offset 0, 0.8 left font ',12'"
        printf "set xrange [%.3g:%.3g]\nset xtics 10\nset format x '10^{%%T}'\n", fewest / 1.5, most * 1.5
        print "set xlabel 'instructions per second, " machine[kind[k]] "'"
        panel(k, left, left + width - 0.025, 0.89, 0.60, 1)
        print "unset label 1\nunset label 2"
        printf "set xrange [%.4g:%.4g]\nset format x '%%g'\nset xtics (%s)\n", shortest * 800, longest * 1250, halves()
        print "set xlabel 'step, ms'"
        panel(k, left, left + width - 0.025, 0.485, 0.195, 3)
    }
    legend()
    print "unset multiplot"
}
