# Error over cost and over the step for every method, from a report's table (tools/measure/report.sh), with the methods
# of isoc (build/isoc --methods) before it: a pair of panels for each kind, and a legend. An error above 100 means
# nothing, and is not drawn. Over the cost the points off the Pareto front are pale.
#
#     work_precision SCENE TIME report.tsv
BEGIN {
    scene = word(1)
    time = word(2)
    ARGV[2] = "-"
    # In pixels. The legend has room for so many rows of methods; a picture with more of them is as much higher.
    WIDTH = 960; HEIGHT = 760; LEGEND = 100; LEGEND_ROWS = 4; LEGEND_COLUMNS = 5; ROW = 16; COLUMN = 150
    FRONT = "with lines linewidth 6 linecolor rgb '#f0d060'"
    PALENESS = 0.65 # the part of the way to white
    families = split("one step:multistep:stiff:varying step:others", family_name, ":")
    kinds = split("float compensated double cycles_float cycles_compensated held smooth", kind_name, " ")
    split("float:float, compensated sums:double:float:float, compensated sums:held inputs, double:smooth inputs, double", kind_title, ":")
}

# --- The tables ---

# A row of the methods: name, order, evaluations, Jacobians, solutions, vectors kept.
FILENAME == "-" || FILENAME == "" {
    split($0, cell, / *[|] */)
    if (cell[2] !~ /^(method|-*)$/) {
        known[cell[2]] = known_methods++
        family_of[cell[2]] = cell[4] ~ /sub-step/ ? 4 : cell[5] > 0 ? 3 : cell[7] > 0 ? 2 : 1
    }
    next
}

FNR == 1 { next }

!($2 in number) {
    number[$2] = ++methods
    method[methods] = $2
    family[methods] = $2 in known ? family_of[$2] : families
    in_family[family[methods]]++
    place = $2 in known ? known[$2] : known_methods + methods - 1
    if (place >= colours * marks) fail("plot: two methods would look alike")
    split($2 in chosen ? chosen[$2] : palette[place % colours + 1] " " mark[int(place / colours) % marks + 1], cell, " ")
    mark_of[methods] = "pointtype " cell[2] " linecolor rgb '" cell[1] "'"
    look[methods] = "with linespoints linewidth 1.1 pointsize 0.55 " mark_of[methods]
    pale[methods] = "with linespoints linewidth 1.1 pointsize 0.55 pointtype " cell[2] " linecolor rgb '" pale_of(cell[1]) "'"
    best[methods] = "with points pointsize 0.7 " mark_of[methods]
}

$5 > 0 && $5 <= 100 && $5 !~ /inf|nan/ {
    rows++
    row_kind[rows] = $1
    row_method[rows] = $2
    step[rows] = 1000 * $3
    error[rows] = $5
    cost[rows] = $8
    points[$1, $2] = points[$1, $2] sprintf("%s %s %.9g\n", $8, $5, 1000 * $3)
    has[$1] = 1
    extend("step", step[rows])
    extend("error", $5)
    extend("cost", $8)
    if ($9 == "-") longest = larger(longest, step[rows])
}

# A colour #rrggbb nearer to white.
function pale_of(colour, i, value, made)
{
    for (i = 2; i <= 6; i += 2) {
        value = 16 * digit(substr(colour, i, 1)) + digit(substr(colour, i + 1, 1))
        made = made sprintf("%02x", value + PALENESS * (255 - value))
    }
    return "#" made
}

function digit(letter) { return index("0123456789abcdef", letter) - 1 }

# --- The Pareto front: the points that no other point of the kind betters in error and in cost ---

# The point behind `last`, or the first if that is 0: the cheapest with a smaller error, and of those that cost the same
# that with the least; 0 if there is none.
function next_on_front(kind, last, row, found)
{
    for (row = 1; row <= rows; row++) {
        if (row_kind[row] != kind || (last && error[row] >= error[last])) continue
        if (!found || cost[row] < cost[found] || (cost[row] == cost[found] && error[row] < error[found])) found = row
    }
    return found
}

# Names an end of the front: the cheapest at the upper edge of the panel, the most exact below its point.
function put_end(row, label, where, left)
{
    left = log(cost[row] / least["cost"]) < log(most["cost"] / least["cost"]) / 2
    printf "set label %d '%s, %.3g ms' noenhanced at first %.9g, %s %s font ',10' front\n", label, row_method[row], step[row], cost[row],
        where, left ? "left" : "right"
}

# --- Panels ---

# The panel of a kind over the cost: the front, every point in pale, and those on the front; and labels 2 and 3 at its
# ends.
function put_costs(kind, row, last, line, front, its, i)
{
    for (row = next_on_front(kind, 0); row; row = next_on_front(kind, row)) {
        if (front == "") put_end(row, 2, "graph 0.955")
        line = cost[row] " " error[row] "\n"
        front = front line
        its[row_method[row]] = its[row_method[row]] line
        last = row
    }
    put_end(last, 3, "first " error[last] " offset 0, -0.9")
    add_curve(front, FRONT)
    for (i = 1; i <= methods; i++) add_curve(points[kind, method[i]], "using 1:2 " pale[i])
    for (i = 1; i <= methods; i++) add_curve(its[method[i]], best[i])
    put_curves()
}

# The panel over the step.
function put_steps(kind, i)
{
    for (i = 1; i <= methods; i++) add_curve(points[kind, method[i]], "using 3:2 " look[i])
    put_curves()
}

# Labels at the steps of fixed methods, and beyond these by factors of two; every other one has a text.
function put_step_axis(at, i, list)
{
    for (at = longest ? longest : most["step"]; 2 * at <= 1.25 * most["step"]; at *= 2) continue
    for (; at >= 0.8 * least["step"]; at /= 2)
        list = list (i ? ", " : "") sprintf("'%s' %.4g", i++ % 2 ? "" : sprintf("%.4g", at), at)
    printf "set xrange [%.4g:%.4g]\nset xtics (%s)\nset xlabel 'step, ms'\n", least["step"] * 0.8, most["step"] * 1.25, list
}

# The two panels of a kind, one above the other.
function put_kind(k, place, places, width, left, right, kind)
{
    kind = kind_name[k]
    width = 0.91 / places
    left = 0.075 + place * width
    right = left + width - 0.025
    print "set label 1 '" kind_title[k] "' at graph 0, 1 offset 0, 0.8 left font ',12'"
    print "set xlabel '" (kind ~ /^cycles/ ? "cycles" : "instructions") " per second, " (kind_title[k] ~ /double/ ? "host" : "Cortex-M4F") "'"
    print "set ylabel '" (place ? "" : "error after " time " s") "' offset 1, 0"
    put_decades("y", least["error"] / 30, most["error"] * 30, !place)
    put_decades("x", least["cost"] / 1.5, most["cost"] * 1.5, 1)
    put_place(left, right, 1 - 80 / height, 1 - 310 / height)
    put_costs(kind)
    print "unset label 2\nunset label 3\nunset label 4"
    put_step_axis()
    put_place(left, right, 1 - 395 / height, 1 - 600 / height)
    put_steps(kind)
}

# The names of the methods in a panel of its own below the others: each family begins a row.
function put_legend(rows_more, f, i, n, x, y, row, label, its)
{
    print "unset border\nunset tics\nunset grid\nunset xlabel\nunset ylabel\nunset logscale\nunset label"
    printf "set xrange [0:%d]\nset yrange [%d:0]\n", WIDTH, LEGEND + rows_more
    put_place(0, 1, (LEGEND + rows_more) / height, 0)
    print "set label 10 'Pareto front' at 122, 12 left"
    print "set label 11 'no other point has a smaller error and a smaller cost; what is off it is pale' at 232, 12 left"
    label = 12
    for (f = 1; f <= families; f++) {
        n = 0
        for (i = 1; i <= methods; i++) {
            if (family[i] != f) continue
            x = 220 + COLUMN * (n % LEGEND_COLUMNS)
            y = 30 + ROW * (row + int(n / LEGEND_COLUMNS))
            if (n++ == 0) print "set label " label++ " '" family_name[f] ":' at 85, " y " left"
            print "set label " label++ " '" method[i] "' noenhanced at " x + 12 ", " y " left"
            its[i, "pale"] = x - 20 " " y "\n" x - 7 " " y "\n"
            its[i, "look"] = x - 7 " " y "\n" x + 6 " " y "\n"
        }
        row += legend_rows(f)
    }
    add_curve("85 12\n115 12\n", FRONT)
    for (i = 1; i <= methods; i++) {
        add_curve(its[i, "pale"], pale[i])
        add_curve(its[i, "look"], look[i])
    }
    put_curves()
}

function legend_rows(f) { return int((in_family[f] + LEGEND_COLUMNS - 1) / LEGEND_COLUMNS) }

END {
    if (failed || !rows) exit failed
    for (f = 1; f <= families; f++) more += legend_rows(f)
    more = more > LEGEND_ROWS ? ROW * (more - LEGEND_ROWS) : 0
    height = HEIGHT + more
    printf "# size %d %d\nset multiplot\n", WIDTH, height
    put_style()
    print "set logscale xy\nset mxtics 1\nset mytics 1"
    printf "set label 4 '%s: error over cost' noenhanced at screen 0.075, %.5f left font ',14'\n", scene, 1 - 30 / height
    for (k = 1; k <= kinds; k++) places += has[kind_name[k]]
    for (k = 1; k <= kinds; k++) if (has[kind_name[k]]) put_kind(k, drawn_kinds++, places)
    put_legend(more)
    print "unset multiplot"
}
