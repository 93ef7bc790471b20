# The cost and the influence of each effect of a scene: two tables in Markdown, and one in `table`, separated by tabs.
# From the counts of price.sh: a line for each effect, its name and kind, and the counts of the scene without it; then
# two lines without a name: base, the scene without any effect, and whole, the scene. FOLDER/without-NAME and
# FOLDER/whole have the traces of runs of the same time.
#
#     awk -v folder=FOLDER -v table=effects.tsv -f price.awk FOLDER/counts
BEGIN {
    counts = split("add mul div sincos step tick text memory states memories", key, " ")
    split("add,mul,div,sincos,instructions of a step,of a tick,bytes of text,of memory,states,memories", heading, ",")
}

$1 == "." { for (i = 1; i <= counts; i++) count[$2, i] = $(i + 2); next }
{
    effect[++effects] = $1
    kind[effects] = $2
    for (i = 1; i <= counts; i++) count[effects, i] = $(i + 2)
}

# The cells of the next line, and how many there are: 0 behind the last line.
function read_cells(path, cells)
{
    return split((getline read_line < path) > 0 ? read_line : "", cells, ",")
}

# The changes of all outputs by an effect: of their values with it less those without, over the ticks of both runs: the
# root of the mean square, the largest, and the part that the first is of the output itself, with the effect or without,
# whichever is larger. An output that is not there without the effect has none. A run that the guard stopped has an end,
# in s.
function read_changes(e, without, names, column, a, b, i, rows, last, difference, squares, with_squares, without_squares)
{
    without = folder "/without-" effect[e] "/trace.csv"
    outputs = read_cells(whole, output) - 1
    for (i = read_cells(without, names); i > 1; i--) column[names[i]] = i
    while (read_cells(without, b) && read_cells(whole, a)) {
        rows++
        last = b[1]
        for (i = 2; i <= outputs + 1; i++) {
            if (!(output[i] in column)) continue
            difference = a[i] - b[column[output[i]]]
            squares[i] += difference * difference
            with_squares[i] += a[i] * a[i]
            without_squares[i] += b[column[output[i]]] * b[column[output[i]]]
            if (difference < 0) difference = -difference
            if (difference > largest[e, i]) largest[e, i] = difference
        }
    }
    if (read_cells(whole, a)) end[e] = last
    close(whole)
    close(without)
    for (i = 2; i <= outputs + 1; i++) {
        if (!(output[i] in column) || !rows) continue
        rms[e, i] = sqrt(squares[i] / rows)
        if (squares[i] > 0)
            part = sqrt(squares[i] / (with_squares[i] > without_squares[i] ? with_squares[i] : without_squares[i]))
        if (squares[i] > 0 && part > most_part[e]) {
            most_part[e] = part
            most[e] = i
        }
    }
}

# The counts of base, whole, the sum of all effects or an effect, each with a text before it and one behind it.
function costs(of, format, before, after, i, text)
{
    for (i = 1; i <= counts; i++) text = text before sprintf(format, count[of, i]) after
    return text
}

function print_prices(e, i)
{
    printf "| effect |"
    for (i = 1; i <= counts; i++) printf " %s |", heading[i]
    printf " change, rms | largest | of |\n|---|"
    for (i = 1; i <= counts + 2; i++) printf "--:|"
    print "---|"
    for (e = 1; e <= effects; e++) {
        printf "| %s, %s |%s", effect[e], kind[e], costs(e, "%+.0f", " ", " |")
        i = most[e]
        print (!i ? " 0 | 0 | |" : sprintf(" %.3g | %.3g | %s%s%s |", rms[e, i], largest[e, i], output[i], unit[i] == "" ? "" : ", ", unit[i]))
    }
    print "| base, without any |" costs("base", "%.0f", " ", " |") " | | |"
    print "| sum of the effects |" costs("sum", "%+.0f", " ", " |") " | | |"
    print "| whole |" costs("whole", "%.0f", " ", " |") " | | |"
}

# The change of every output by every effect.
function print_changes(e, i, head, line)
{
    for (e = 1; e <= effects; e++) {
        head = head " " effect[e] " |"
        line = line "--:|"
    }
    print "\n| change, rms; largest | unit |" head "\n|---|---|" line
    for (i = 2; i <= outputs + 1; i++) {
        printf "| %s | %s |", output[i], unit[i]
        for (e = 1; e <= effects; e++) printf " %s |", (e, i) in rms ? sprintf("%.3g; %.3g", rms[e, i], largest[e, i]) : "gone"
        print ""
    }
    for (e = 1; e <= effects; e++)
        if (end[e] > 0) printf "\nWithout %s the guard stops the run at %.9g s; the changes are until then.\n", effect[e], end[e]
}

# A line for each effect, then base, sum and whole; a missing change is empty.
function write_table(e, i, text)
{
    text = "effect\tkind"
    for (i = 1; i <= counts; i++) text = text "\t" key[i]
    text = text "\tpart\tof"
    for (i = 2; i <= outputs + 1; i++) text = text "\t" output[i] "_rms\t" output[i] "_largest"
    print text > table
    for (e = 1; e <= effects; e++) {
        text = effect[e] "\t" kind[e] costs(e, "%.0f", "\t") sprintf("\t%.9g\t%s", most_part[e], most[e] ? output[most[e]] : "")
        for (i = 2; i <= outputs + 1; i++) text = text ((e, i) in rms ? sprintf("\t%.9g\t%.9g", rms[e, i], largest[e, i]) : "\t\t")
        print text > table
    }
    print "\tbase" costs("base", "%.0f", "\t") > table
    print "\tsum" costs("sum", "%.0f", "\t") > table
    print "\twhole" costs("whole", "%.0f", "\t") > table
}

END {
    if (!effects) {
        print "price: there are no counts" > "/dev/stderr"
        exit 1
    }
    whole = folder "/whole/trace.csv"
    units = folder "/whole/units.csv"
    read_cells(units, unit) # the names of the outputs
    read_cells(units, unit)
    for (i in unit) if (unit[i] == "1") unit[i] = ""
    for (e = 1; e <= effects; e++) {
        for (i = 1; i <= counts; i++) {
            count[e, i] = count["whole", i] - count[e, i]
            count["sum", i] += count[e, i]
        }
        read_changes(e)
    }
    write_table()
    print_prices()
    print_changes()
}
