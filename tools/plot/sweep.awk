# The results of a sweep over the values that it varies, a panel for each result:
#
#     sweep SCENE random|listed columns.tsv sweep.tsv
#
# Of random values the histogram of each result. Else a map in colours, where two numbers alone vary with at least five
# values each; else a curve over the number with most values, for each combination of the others, the first eight of
# them. Runs that failed are left out. Nothing, where no number varies or no result is a number.
BEGIN {
    PANEL = 260
    BINS = 30
    CURVES = 8
    ENOUGH = 5
    scene = word(1)
    is_random = word(2) == "random"
    count = split("#0067a5 #d1590a #3c8d2f #8b3a9e #b8860b #1a9e9e #a03050 #555555", its_colour, " ")
}

FNR == 1 { files++ }
files == 1 && FNR > 1 { unit[$1] = $2; sort[$1] = $3 }
files == 2 && FNR == 1 { cells = split($0, column) ; next }
files == 2 && $cells == "ok" {
    runs++
    for (i = 1; i < cells; i++) {
        at[runs, i] = $i
        if (!((i, $i) in seen)) {
            seen[i, $i] = ++values[i]
            listed[i, values[i]] = $i
        }
        if ($i !~ /^[-+]?[0-9.]+(e[-+]?[0-9]+)?$/) is_word[i] = 1
        extend(i, $i)
    }
}

function label(i) { return column[i] (unit[column[i]] == "1" ? "" : ", " unit[column[i]]) }

# The columns that vary, the one with most numbers first; and the results.
function sort_columns(i)
{
    for (i = 1; i < cells; i++) {
        if (sort[column[i]] == "result" && !is_word[i] && column[i] != "hash" && values[i] > 1) result[++results] = i
        if (sort[column[i]] != "set" || values[i] < 2) continue
        varied[++varieties] = i
        if (!is_word[i] && values[i] > values[across]) across = i
    }
    for (i = 1; i <= varieties; i++) if (varied[i] != across && !is_word[varied[i]]) along = varied[i]
    is_map = varieties == 2 && along && values[across] >= ENOUGH && values[along] >= ENOUGH && runs == values[across] * values[along]
}

# The values of all other columns that vary in a run, as they stand in the legend.
function others(run, i, text)
{
    for (i = 1; i <= varieties; i++)
        if (varied[i] != across) text = text (text == "" ? "" : ", ") column[varied[i]] " " at[run, varied[i]]
    return text
}

function put_lines(i, k, run, points, name)
{
    for (run = 1; run <= runs; run++) {
        name = others(run)
        if (!(name in place) && places < CURVES) title_of[place[name] = ++places] = name
        if (name in place) points[place[name]] = points[place[name]] at[run, across] " " at[run, i] "\n"
    }
    for (k = 1; k <= places; k++)
        add_curve(points[k], "with linespoints linewidth 1.4 pointtype 7 pointsize 0.35 linecolor rgb '" its_colour[k] "'", title_of[k])
    put_range("x", least[across], most[across])
    put_range("y", least[i], most[i])
    print "set xlabel " quoted(label(across)) " noenhanced"
    put_head(label(i))
    print "set key " (varieties > 1 ? "on outside right center noenhanced samplen 1.5" : "off")
    put_curves()
}

function put_histogram(i, run, width, bin, in_bin, highest, bars)
{
    width = (most[i] - least[i]) / BINS
    for (run = 1; run <= runs; run++) {
        bin = smaller(BINS - 1, int((at[run, i] - least[i]) / width))
        highest = larger(highest, ++in_bin[bin])
    }
    for (bin = 0; bin < BINS; bin++)
        bars = bars sprintf("%.9g %d %.9g\n", least[i] + (bin + 0.5) * width, in_bin[bin], width)
    put_block("bars_" i, bars)
    put_range("x", least[i], most[i])
    put_range("y", 0, highest)
    print "set yrange [0:*]\nset boxwidth\nset xlabel " quoted(label(i)) " noenhanced\nset ylabel 'runs'"
    print "plot $bars_" i " using 1:2:3 with boxes fill solid 0.5 linecolor rgb '" its_colour[1] "'"
}

function put_map(i, run, points)
{
    for (run = 1; run <= runs; run++) points = points at[run, across] " " at[run, along] " " at[run, i] "\n"
    put_block("map_" i, points)
    put_range("x", least[across], most[across])
    put_range("y", least[along], most[along])
    print "set palette defined (0 '#0b2a5b', 1 '#2f7fb8', 2 '#b9dbe8', 3 '#f6d58a', 4 '#b3430a')\nset colorbox"
    print "set xlabel " quoted(label(across)) " noenhanced\nset ylabel " quoted(label(along)) " noenhanced"
    print "set cblabel " quoted(label(i)) " noenhanced"
    print "plot $map_" i " using 1:2:3 with image pixels"
}

END {
    if (runs < 2) exit
    sort_columns()
    if (!results || !(is_random || across)) exit
    printf "# size 900 %d\n", 40 + PANEL * results
    put_style()
    printf "set multiplot layout %d,1 title %s noenhanced\n", results, quoted(scene ": " runs " runs")
    for (k = 1; k <= results; k++) {
        if (is_random) put_histogram(result[k])
        else if (is_map) put_map(result[k])
        else put_lines(result[k])
    }
    print "unset multiplot"
}
