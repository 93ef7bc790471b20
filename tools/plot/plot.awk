# Gnuplot's commands for the trace of a run.
#
#     awk -v kind=trace|path -f plot.awk part=scene SCENE part=run summary.txt part=trace trace.csv
#
# kind=trace: a panel for each output over time; the components of a point share one. kind=path: the way of the first
# point in the plane in which it moves most, and the energy, if there is one. Nothing where there is no point.
# SCENE tells the units; it may be empty. summary.txt is what make run prints.

# --- what is read ---

# Words, whatever the lines.
part == "scene" {
    sub(/#.*/, "")
    gsub(/[={};]/, " & ")
    for (i = 1; i <= NF; i++)
        word[++words] = $i
    next
}

part == "run" {
    said[$1] = $2
    next
}

FNR == 1 {
    columns = split($0, name, ",")
    next
}

{
    line[++rows] = $0
}

# --- the numbers, made fewer ---

# The least and the greatest of each column.
function find_bounds(    row, i, value) {
    for (row = 1; row <= rows; row++) {
        split(line[row], value, ",")
        for (i = 1; i <= columns; i++) {
            if (row == 1 || value[i] + 0 < low[i])
                low[i] = value[i] + 0
            if (row == 1 || value[i] + 0 > high[i])
                high[i] = value[i] + 0
        }
    }
}

# A data block of a column over time, less `zero`: of each stretch of the rows its least and greatest, in their order,
# so that nothing fast is lost.
function put_column(i, zero, stretches,    every, row, value, least, most, least_at, most_at) {
    every = int((rows + stretches - 1) / stretches)
    print "$column" i " << END"
    for (row = 1; row <= rows; row++) {
        split(line[row], value, ",")
        if (row % every == 1 || every == 1 || value[i] + 0 < least) {
            least = value[i] + 0
            least_at = value[1]
        }
        if (row % every == 1 || every == 1 || value[i] + 0 > most) {
            most = value[i] + 0
            most_at = value[1]
        }
        if (row % every == 0 || row == rows) {
            if (least_at + 0 < most_at + 0)
                printf "%s %.9g\n%s %.9g\n", least_at, least - zero, most_at, most - zero
            else
                printf "%s %.9g\n%s %.9g\n", most_at, most - zero, least_at, least - zero
        }
    }
    print "END"
}

# A data block of one column over another: every so many rows.
function put_plane(i, j, points,    every, row, value) {
    every = int((rows + points - 1) / points)
    print "$plane << END"
    for (row = 1; row <= rows; row += every) {
        split(line[row], value, ",")
        print value[i], value[j]
    }
    print "END"
}

# --- units, from the scene ---

# The unit of `output NAME = KIND of OF`: of a joint by its kind, else of a body's point.
function unit_of(what, of,    length_or_angle) {
    if (what == "energy")
        return "J"
    if (what == "turns")
        return "turns"
    length_or_angle = of in joint && joint[of] == "revolute" ? "rad" : "m"
    return length_or_angle (what == "position" ? "" : what == "acceleration" ? "/s^2" : "/s")
}

function find_units(    i) {
    for (i = 1; i <= words; i++)
        if (word[i] == "joint")
            joint[word[i + 1]] = word[i + 2]
    for (i = 1; i <= words; i++)
        if (word[i] == "output" && word[i + 2] == "=") {
            unit[word[i + 1]] = unit_of(word[i + 3], word[i + 5])
            place[word[i + 1]] = word[i + 3] == "position" && !(word[i + 5] in joint)
        }
}

# --- groups: the components of a point, or one output ---

function find_groups(    i, stem) {
    for (i = 2; i <= columns; i++)
        column[name[i]] = i
    for (i = 2; i <= columns; i++) {
        stem = name[i]
        sub(/_[xyz]$/, "", stem)
        if (!((stem "_x") in column && (stem "_y") in column && (stem "_z") in column))
            stem = name[i]
        if (!(stem in members))
            group[++groups] = stem
        member[stem, ++members[stem]] = i
    }
}

# --- what is drawn ---

function quoted(text) {
    gsub(/'/, "''", text)
    return "'" text "'"
}

function title() {
    return sprintf("%s: %s, step %s ms, %s", said["scene"], said["method"], said["step"] * 1000, said["real"])
}

function labelled(text, stem) {
    return (stem in unit) ? text ", " unit[stem] : text
}

# A range with some air, and tics at multiples of 1, 2 or 5 times a power of ten: two to five of them.
function range(axis, least, most,    air, tic) {
    air = 0.06 * (most - least)
    if (air == 0)
        air = least == 0 ? 1 : 0.1 * (least < 0 ? -least : least)
    tic = exp(log(10) * int(log((most - least + 2 * air) / 2) / log(10) + 100) - log(10) * 100)
    tic *= (most - least + 2 * air) / 2 >= 5 * tic ? 5 : (most - least + 2 * air) / 2 >= 2 * tic ? 2 : 1
    printf "set %srange [%.9g:%.9g]\nset %stics %.3g\n", axis, least - air, most + air, axis, tic
}

function common() {
    print "set border 3 linewidth 0.8 linecolor rgb '#555555'"
    print "set tics nomirror out scale 0.6 textcolor rgb '#333333'"
    print "set grid linetype 1 linecolor rgb '#d4d4d4' linewidth 0.7"
    print "set format '%g'"
    print "set key off"
}

function draw_group(g, top, bottom, last,    stem, n, m, i, least, most, text) {
    stem = group[g]
    n = members[stem]
    for (m = 1; m <= n; m++) {
        i = member[stem, m]
        if (m == 1 || low[i] < least)
            least = low[i]
        if (m == 1 || high[i] > most)
            most = high[i]
    }
    range("y", least, most)
    printf "set tmargin at screen %.5f\nset bmargin at screen %.5f\n", top, bottom
    print "set label 1 " quoted(labelled(stem, stem)) " noenhanced at graph 0, 1 offset 0, 0.6 left font ',11'"
    text = last ? "set xlabel 't, s'\nset format x '%g'" : "unset xlabel\nset format x ''"
    print text
    print (n > 1 ? "set key on at graph 1, 1.02 right bottom horizontal samplen 1.5" : "set key off")
    for (m = 1; m <= n; m++)
        printf "%s $column%d with lines linewidth 1.2 linecolor rgb '%s' title '%s'", m == 1 ? "plot" : ",",
            member[stem, m], colour[m], substr("xyz", m, 1)
    print ""
}

function draw_trace(    g, i, height, head, foot, total, top) {
    head = 60
    foot = 36
    height = 118
    for (i = 2; i <= columns; i++)
        put_column(i, 0, 450)
    total = head + groups * height + foot
    print "# size 900 " total
    print "set multiplot"
    print "set label 2 " quoted(title()) " noenhanced at screen 0.09, " 1 - 22 / total " left font ',14'"
    print "set lmargin at screen 0.09\nset rmargin at screen 0.975"
    printf "set xrange [0:%.9g]\n", high[1]
    for (g = 1; g <= groups; g++) {
        top = 1 - (head + (g - 1) * height) / total
        draw_group(g, top, top - (height - 34) / total, g == groups)
        print "unset label 2"
    }
    print "unset multiplot"
}

# Two of the columns of a point, without the one that moves least; in order.
function find_plane(stem,    m, i, least) {
    for (m = 1; m <= 3; m++) {
        i = member[stem, m]
        if (m == 1 || high[i] - low[i] <= high[least] - low[least])
            least = i
    }
    across = member[stem, 1] == least ? member[stem, 2] : member[stem, 1]
    up = member[stem, 3] == least ? member[stem, 2] : member[stem, 3]
}

# Two ranges of one scale for a square.
function square(i, j,    side) {
    side = high[i] - low[i] > high[j] - low[j] ? high[i] - low[i] : high[j] - low[j]
    range("x", (high[i] + low[i] - side) / 2, (high[i] + low[i] + side) / 2)
    range("y", (high[j] + low[j] - side) / 2, (high[j] + low[j] + side) / 2)
}

function draw_path(    g, stem, energy, i, value) {
    for (g = groups; g >= 1; g--) {
        if (members[group[g]] == 3 && (words == 0 || (group[g] in place && place[group[g]])))
            stem = group[g]
        if (group[g] == "energy" || (group[g] in unit && unit[group[g]] == "J"))
            energy = group[g]
    }
    if (stem == "")
        return
    print "# size " (energy == "" ? 400 : 900) " 400"
    find_plane(stem)
    put_plane(across, up, 1600)
    print "set multiplot"
    print "set tmargin at screen 0.875\nset bmargin at screen 0.15"
    print "set lmargin at screen " (energy == "" ? 0.2 : 0.08) "\nset rmargin at screen " (energy == "" ? 0.95 : 0.08 + 1 / 3)
    print "set label 2 " quoted(title()) " noenhanced at graph 0, 1 offset 0, 1 left font ',14'"
    square(across, up)
    print "set xlabel " quoted(labelled(name[across], stem)) " noenhanced"
    print "set ylabel " quoted(labelled(name[up], stem)) " noenhanced"
    print "plot $plane with lines linewidth 0.8 linecolor rgb '" colour[1] "'"
    if (energy != "") {
        i = column[energy]
        split(line[1], value, ",")
        put_column(i, value[i], 400)
        print "unset label 2\nset lmargin at screen 0.54\nset rmargin at screen 0.975"
        printf "set xrange [0:%.9g]\nset xtics autofreq\n", high[1]
        range("y", low[i] - value[i], high[i] - value[i])
        print "set xlabel 't, s'"
        print "set ylabel " quoted(labelled("change of " energy, energy)) " noenhanced"
        print "plot $column" i " with lines linewidth 0.8 linecolor rgb '" colour[2] "'"
    }
    print "unset multiplot"
}

END {
    colour[1] = "#0067a5"
    colour[2] = "#d1590a"
    colour[3] = "#3c8d2f"
    if (words > 0)
        find_units()
    find_bounds()
    find_groups()
    common()
    if (kind == "trace")
        draw_trace()
    else
        draw_path()
}
