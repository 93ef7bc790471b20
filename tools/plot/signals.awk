# The outputs of a run: the table that build/trace writes, with their units, in groups that share a panel. Runs have
# numbers: of run r the columns are 0, the time, to columns[r] - 1, and the rows 1 to count[r].
#
#     line[r, row]                the row as it is in the table
#     name[r, c]  unit[r, c]      of a column; the unit is empty if it has none, or none is known
#     least[r, c]  most[r, c]     of its values
#     curve[r, c]                 its points over time
#     said[r, word]               in the summary
#     groups[r]                   how many groups there are: an output, the x, y, z of a vector, the w, x, y, z of a quaternion
#     stem[r, g]                  the name of a group, without _x of a component
#     first[r, g]  members[r, g]  its columns

BEGIN { split("#0067a5 #d1590a #3c8d2f #8c8c8c", colour, " ") }

# Whether the columns from this one on are the components of one vector: their names end with _ and these letters.
function are_components(r, c, letters, i, start)
{
    start = substr(name[r, c], 1, length(name[r, c]) - 2)
    for (i = 0; i < length(letters); i++)
        if (start == "" || name[r, c + i] != start "_" substr(letters, i + 1, 1)) return 0
    return length(letters)
}

function find_groups(r, c, g)
{
    for (c = 1; c < columns[r]; c += members[r, g]) {
        g = ++groups[r]
        members[r, g] = are_components(r, c, "wxyz") + are_components(r, c, "xyz")
        stem[r, g] = members[r, g] ? substr(name[r, c], 1, length(name[r, c]) - 2) : name[r, c]
        if (!members[r, g]) members[r, g] = 1
        first[r, g] = c
    }
}

# Reads one line. A missing file is an error.
function next_line(path, got)
{
    got = getline read_line < path
    if (got < 0) fail("plot: " path " cannot be read")
    return got
}

function read_head(r, directory, cells, i, path)
{
    path = directory "/summary.txt"
    while (next_line(path)) {
        split(read_line, cells, " ")
        if (!((r, cells[1]) in said)) said[r, cells[1]] = cells[2]
    }
    close(path)
    path = directory "/units.csv"
    next_line(path)
    split(next_line(path) ? read_line : "", cells, ",")
    close(path)
    for (i = 1; i in cells; i++) unit[r, i - 1] = cells[i]
    path = directory "/trace.csv"
    next_line(path)
    columns[r] = split(read_line, cells, ",")
    for (i in cells) name[r, i - 1] = cells[i]
    while (next_line(path)) line[r, ++count[r]] = read_line
    close(path)
    if (!count[r]) fail("plot: " path " has no row")
    find_groups(r)
}

# Reads DIRECTORY/trace.csv, units.csv and summary.txt. A curve has of each of so many stretches of the rows the least
# and the greatest value, in their order, so that nothing fast is lost; less those of the first row, if `changes`.
function read_run(r, directory, stretches, changes, row, c, every, v, x, zero, low, high, low_at, high_at)
{
    read_head(r, directory)
    every = ceil(count[r] / stretches)
    for (row = 1; row <= count[r]; row++) {
        split(line[r, row], v, ",")
        for (c = 0; c < columns[r]; c++) {
            x = v[c + 1] + 0
            if (row == 1) {
                least[r, c] = most[r, c] = x
                zero[c] = changes ? x : 0
            }
            if (x < least[r, c]) least[r, c] = x
            if (x > most[r, c]) most[r, c] = x
            if ((row - 1) % every == 0 || x < low[c]) { low[c] = x; low_at[c] = row " " v[1] }
            if ((row - 1) % every == 0 || x > high[c]) { high[c] = x; high_at[c] = row " " v[1] }
            if (row % every && row < count[r]) continue
            if (low_at[c] + 0 < high_at[c] + 0) add_point(r, c, low_at[c], low[c] - zero[c])
            add_point(r, c, high_at[c], high[c] - zero[c])
            if (low_at[c] + 0 > high_at[c] + 0) add_point(r, c, low_at[c], low[c] - zero[c])
        }
    }
}

# A point at a row, whose number stands before its time.
function add_point(r, c, at, value)
{
    curve[r, c] = curve[r, c] sprintf("%s %.9g\n", substr(at, index(at, " ") + 1), value)
}

# Scene, method, step and real, as a title in quotes.
function title(r)
{
    return quoted(sprintf("%s: %s, step %.6g ms, %s", said[r, "scene"], said[r, "method"], 1000 * said[r, "step"], said[r, "real"]))
}

# A name with the unit of the column: "hinge_angle, rad"; a pure number has no unit.
function label(r, c, text)
{
    return text (unit[r, c] == "" || unit[r, c] == "1" ? "" : ", " unit[r, c])
}

# Panels over time, one above the other: begin_panels and put_signal_panel, which draws the curves that were added.

# In pixels: the picture, and above, of and below the panels.
function begin_panels(count)
{
    WIDTH = 900; HEAD = 60; PANEL = 118; GAP = 34; FOOT = 36
    panels = count
    height = HEAD + PANEL * panels + FOOT
    put_style()
    printf "# size %d %d\nset multiplot\n", WIDTH, height
}

# Panel i from above, with this text and values from `low` to `high`.
function put_signal_panel(i, head, low, high, top)
{
    top = HEAD + PANEL * (i - 1)
    put_range("y", low, high)
    put_place(0.09, 0.975, 1 - top / height, 1 - (top + PANEL - GAP) / height)
    put_head(head)
    put_time(i == panels)
    put_curves()
}
