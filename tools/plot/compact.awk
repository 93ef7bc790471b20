# A drawing of gnuplot's without what changes nothing: empty groups, names that nobody sees, what SVG has by itself or
# from the group around, spaces, empty lines.
{
    sub(/^[ \t]+/, "")
    sub(/ stroke-linecap="butt" stroke-linejoin="miter"/, "")
    sub(/<title>gnuplot_plot_[^<]*<\/title>/, "")
    gsub(/rgb\( */, "rgb(")
    if (/stroke='rgb|color='rgb/)
        gsub(/, +/, ",")
}

$0 == "" { next }

/^<g fill="none".*>$/ {
    group = $0
    next
}

group != "" && $0 == "</g>" {
    group = ""
    next
}

group != "" {
    print group
    group = ""
}

{ print }
