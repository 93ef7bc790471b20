# A drawing of gnuplot's without what changes nothing: empty groups and texts, a group that goes on where the last one
# ended, names that nobody sees, what SVG has by itself or from the group around, spaces, empty lines.
{
    gsub(/<title>gnuplot_plot_[^<]*<\/title>|<text><\/text>/, "")
    gsub(/ stroke-linecap="butt" stroke-linejoin="miter"| class="gridline" /, "")
    gsub(/<tspan font-family="sans-serif" >/, "<tspan>")
    gsub(/rgb\( */, "rgb(")
    if (/stroke='rgb|color='rgb/)
        gsub(/, +/, ",")
    gsub(/<\/?g[ >]/, "\n&")
    parts = split($0, part, "\n")
    for (i = 1; i <= parts; i++) {
        gsub(/^[ \t]+|[ \t]+$/, "", part[i])
        if (part[i] == "</g>")
            end_group()
        else if (part[i] != "")
            add(part[i])
    }
}

function add(text) {
    if (text ~ /^<g /)
        open[++depth] = text
    if (text ~ /^<g / && line[lines] == "</g>" && closed[lines] == text)
        lines--
    else
        line[++lines] = text
}

function end_group() {
    if (line[lines] == open[depth])
        lines--
    else {
        line[++lines] = "</g>"
        closed[lines] = open[depth]
    }
    depth--
}

END {
    for (i = 1; i <= lines; i++)
        print line[i]
    exit depth != 0
}
