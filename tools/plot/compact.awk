# Copies drawings of gnuplot, NAME.drawn, to NAME.svg without text of no effect: names of curves, blanks, empty groups,
# and a group that begins like the one that has just ended.
# Colours as #rrggbb.
function shorten_colours(text, parts, short)
{
    while (match(text, /rgb\( *[0-9]+ *, *[0-9]+ *, *[0-9]+\)/)) {
        split(substr(text, RSTART + 4), parts, ",")
        short = short substr(text, 1, RSTART - 1) sprintf("#%02x%02x%02x", parts[1], parts[2], parts[3])
        text = substr(text, RSTART + RLENGTH)
    }
    return short text
}

# An element: the begin of a group, its end, or an element between.
function take(text)
{
    gsub(/^[ \t]+|[ \t]+$/, "", text)
    if (text == "") return
    if (text == "</g>") {
        if (!depth) fail("plot: a group of the drawing ends that did not begin")
        depth--
        if (kept[count] == open[depth]) { count--; return }
        closed[++count] = open[depth]
        kept[count] = text
        return
    }
    if (text ~ /^<g[ >]/) {
        open[depth++] = text
        if (count in closed && closed[count] == text) { delete closed[count--]; return }
    }
    kept[++count] = text
    delete closed[count]
}

# Writes the kept part of a drawing.
function write(drawn, i)
{
    if (drawn == "") return
    sub(/drawn$/, "svg", drawn)
    for (i = 1; i <= count; i++) print kept[i] >drawn
    close(drawn)
    if (depth) fail("plot: a group of the drawing does not end")
    count = 0
    split("", closed)
}

FNR == 1 {
    write(drawing)
    drawing = FILENAME
}
{
    gsub(/<title>gnuplot_plot_[^<]*<\/title>|<text><\/text>| stroke-linecap="butt" stroke-linejoin="miter"| class="gridline" /, "")
    gsub(/<tspan font-family="sans-serif" >/, "<tspan>")
    $0 = shorten_colours($0)
    if (!/<text>/) { # texts keep their blanks
        gsub(/  +/, " ")
        gsub(/ '\/>/, "'/>")
    }
    while (match(substr($0, 2), /<g[ >]|<\/g>/)) {
        take(substr($0, 1, RSTART))
        $0 = substr($0, RSTART + 1)
    }
    take($0)
}

END {
    if (failed) exit 1
    write(drawing)
}
