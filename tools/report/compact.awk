# A drawing of gnuplot's without what changes nothing: empty groups, what SVG has by itself, indentation, empty lines.
{
    sub(/^[ \t]+/, "")
    sub(/ stroke-linecap="butt" stroke-linejoin="miter"/, "")
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
