# Commands of gnuplot for all pictures, and functions that awk lacks.

# Ends with a message; other code in END has to test `failed`.
function fail(text)
{
    print text > "/dev/stderr"
    failed = 1
    exit 1
}

function smaller(a, b) { return a < b ? a : b }
function larger(a, b) { return a < b ? b : a }
function floor(x) { return int(x) - (int(x) > x) }
function ceil(x) { return int(x) + (int(x) < x) }
function size_of(x) { return x < 0 ? -x : x }
function power_of_ten(n) { return ("1e" n) + 0 }

# An argument that is not the name of a file.
function word(i, text)
{
    text = ARGV[i]
    ARGV[i] = ""
    return text
}

# The least and the most of the values of a name.
function extend(name, value)
{
    if (!(name in least) || value + 0 < least[name]) least[name] = value + 0
    if (!(name in most) || value + 0 > most[name]) most[name] = value + 0
}

# The power of ten at or below a number, and at or above it. A logarithm can be off by one there.
function decade_below(x, text)
{
    text = sprintf("%.17e", x)
    return substr(text, index(text, "e") + 1) + 0
}
function decade_above(x, n)
{
    n = decade_below(x)
    return n + (power_of_ten(n) < x)
}

# Axes, tics and grid.
function put_style()
{
    print "set border 3 linewidth 0.8 linecolor rgb '#555555'"
    print "set tics nomirror out scale 0.6 textcolor rgb '#333333'"
    print "set grid linetype 1 linecolor rgb '#d4d4d4' linewidth 0.7"
    print "set format '%g'"
    print "set key off"
}

# A text in quotes.
function quoted(text)
{
    gsub(/'/, "''", text)
    return "'" text "'"
}

# A block of data for `plot $NAME`; each line of it ends with a line break.
function put_block(name, lines)
{
    printf "$%s << END\n%sEND\n", name, lines
}

# Adds a curve through points, each of which ends with a line break, to the panel that put_curves draws; `title` stands
# in the legend. Nothing where there is no point.
function add_curve(points, style, title)
{
    if (points == "") return
    put_block("curve_" ++all_curves, points)
    curves = curves (curves == "" ? "plot" : ",") " $curve_" all_curves " " style " " (title == "" ? "notitle" : "title " quoted(title))
}
function put_curves()
{
    print curves
    curves = ""
}

# A title above the picture, and on its right a legend.
function put_title(text)
{
    print "set title " quoted(text) " noenhanced\nset key on outside right center noenhanced samplen 2"
}

# A text above a panel.
function put_head(text)
{
    print "set label 1 " quoted(text) " noenhanced at graph 0, 1 offset 0, 0.6 left font ',11'"
}

# The labels of an axis of time that several panels share: they stand below the last one.
function put_time(is_last)
{
    print is_last ? "set xlabel 't, s'\nset format x '%g'" : "unset xlabel\nset format x ''"
}

# The place of a panel, as fractions of the picture from its left and lower edges.
function put_place(left, right, top, bottom)
{
    printf "set lmargin at screen %.5f\nset rmargin at screen %.5f\n", left, right
    printf "set tmargin at screen %.5f\nset bmargin at screen %.5f\n", top, bottom
}

# A linear axis, `x` or `y`, over the values from `least` to `most` with some air, and two to five tics at multiples of
# 1, 2 or 5 times a power of ten, labelled with as many digits as they need.
function put_range(axis, least, most, air, half, tic, i, first, last, digits, list)
{
    air = 0.06 * (most - least)
    if (air == 0) air = least == 0 ? 1 : 0.1 * size_of(least)
    half = (most - least + 2 * air) / 2
    tic = power_of_ten(decade_below(half))
    tic *= half >= 5 * tic ? 5 : half >= 2 * tic ? 2 : 1
    first = ceil((least - air) / tic)
    last = floor((most + air) / tic)
    digits = larger(6, 1 + decade_below(tic * larger(1, larger(size_of(first), size_of(last)))) - decade_below(tic))
    for (i = first; i <= last; i++)
        list = list sprintf("%s'%." digits "g' %.12g", i == first ? "" : ", ", i * tic, i * tic)
    printf "set %srange [%.9g:%.9g]\nset %stics (%s)\n", axis, least - air, most + air, axis, list
}

# A logarithmic axis y over whole decades, for the values of a name.
function put_whole_decades(name)
{
    put_decades("y", power_of_ten(decade_below(least[name])), power_of_ten(decade_above(most[name])), 1)
}

# A logarithmic axis from `least` to `most`. Labels stand at powers of ten, so many decades apart that there are at most
# six; over less than two decades at 2 and 5 times such a power as well. Gnuplot, with tics of a logarithmic axis given
# by a factor alone, begins with the end of the axis and labels it as the decade below.
function put_decades(axis, least, most, labels, first, last, apart, steps, i, power, times, text, list)
{
    first = decade_above(least)
    last = decade_below(most)
    apart = 1 + int((last - first) / 6)
    steps = last - first < 2 ? 3 : 1
    for (i = 0; i < steps * (last - first + 2); i++) {
        power = first - 1 + int(i / steps)
        times = substr("125", i % steps + 1, 1)
        text = times "e" power
        if (text + 0 >= least && text + 0 <= most && power % apart == 0)
            list = list (list == "" ? "" : ", ") "'" (!labels ? "" : times == 1 ? "10^{" power "}" : text) "' " text
    }
    printf "set %srange [%.4g:%.4g]\nset %stics (%s)\n", axis, least, most, axis, list
}
