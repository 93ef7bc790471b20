# The way of the first point that is shown, in the plane in which it moves most, and the change of the energy, if there
# is one. Nothing where there is no point.
#
#     path DIRECTORY

# The first group that is a place: in m, or where no unit is known. 0 if there is none.
function point(g, its)
{
    for (g = 1; g <= groups[1]; g++) {
        its = unit[1, first[1, g]]
        if (members[1, g] == 3 && (its == "m" || its == "")) return g
    }
    return 0
}

function energy(g)
{
    for (g = 1; g <= groups[1]; g++)
        if (unit[1, first[1, g]] == "J" || stem[1, g] == "energy") return g
    return 0
}

function extent(c) { return most[1, c] - least[1, c] }

# An axis around the middle of a column.
function put_axis(axis, c, side, middle)
{
    middle = (least[1, c] + most[1, c]) / 2
    put_range(axis, middle - side / 2, middle + side / 2)
    print "set " axis "label " quoted(label(1, c, name[1, c])) " noenhanced"
}

# The panel of the path: the plane of two components without the one that moves least.
function put_path(g, c, still, i, a, b, side, every, row, v, points)
{
    c = still = first[1, g]
    for (i = 1; i < 3; i++) if (extent(c + i) <= extent(still)) still = c + i
    a = still == c ? c + 1 : c
    b = still == c + 2 ? c + 1 : c + 2
    every = ceil(count[1] / 1600)
    for (row = 1; row <= count[1]; row += every) {
        split(line[1, row], v, ",")
        points = points v[a + 1] " " v[b + 1] "\n"
    }
    put_block("plane", points)
    side = larger(extent(a), extent(b))
    put_axis("x", a, side)
    put_axis("y", b, side)
    put_place(LEFT / width, (LEFT + SIDE) / width, 1 - TOP / HEIGHT, 1 - (TOP + SIDE) / HEIGHT)
    print "plot $plane with lines linewidth 0.8 linecolor rgb '" colour[1] "'"
}

function put_energy(g, c, v)
{
    c = first[1, g]
    split(line[1, 1], v, ",")
    put_block("column" c, curve[1, c])
    printf "set xrange [0:%.9g]\nset xtics autofreq\n", most[1, 0]
    put_range("y", least[1, c] - v[c + 1], most[1, c] - v[c + 1])
    print "set xlabel 't, s'\nset ylabel " quoted(label(1, c, "change of " stem[1, g])) " noenhanced"
    put_place(0.55, 0.975, 1 - TOP / HEIGHT, 1 - (TOP + SIDE) / HEIGHT)
    print "plot $column" c " with lines linewidth 0.8 linecolor rgb '" colour[2] "'"
}

BEGIN {
    # In pixels: a square panel with the path, and on its right one with the energy.
    LEFT = 80; SIDE = 300; TOP = 56; HEIGHT = TOP + SIDE + 64
    read_run(1, ARGV[1], 400, 1)
    if (!point()) exit
    width = energy() ? 900 : LEFT + SIDE + 20
    printf "# size %d %d\nset multiplot\n", width, HEIGHT
    put_style()
    printf "set label 1 %s noenhanced at screen %.5f, %.5f left font ',13'\n", title(1), LEFT / width, 1 - 24 / HEIGHT
    put_path(point())
    print "unset label 1"
    if (energy()) put_energy(energy())
    print "unset multiplot"
}
