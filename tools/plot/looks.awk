# How methods look in all pictures. Colours and marks that are chosen; variants of a method share a colour. The others
# have one of the palette: for every colour each of the marks.
BEGIN {
    chosen["euler"] = "#8c8c8c 7"; chosen["semi_implicit"] = "#8c8c8c 6"; chosen["heun"] = "#b8860b 7"; chosen["rk4"] = "#0067a5 7"
    chosen["ab4"] = "#d1590a 7"; chosen["abm4"] = "#3c8d2f 7"; chosen["abm4_pec"] = "#3c8d2f 6"; chosen["abm4_pecece"] = "#3c8d2f 9"
    chosen["bdf4"] = "#8e3a8e 7"; chosen["rosenbrock"] = "#c2185b 5"; chosen["adams"] = "#008b8b 5"
    variant["semi_implicit"] = "#4d4d4d"; variant["abm4_pec"] = "#7cb342"; variant["abm4_pecece"] = "#1b5e20"
    colours = split("#000000 #8b4513 #1a237e #7cb342 #e57373 #5c9bd5 #9575cd #a1887f", palette, " ")
    marks = split("7 5 9 13 11 15", mark, " ")
}

# Of lines without marks variants have colours of their own.
function colour_of(method, place, cell)
{
    if (method in variant) return variant[method]
    split(method in chosen ? chosen[method] : palette[place % colours + 1], cell, " ")
    return cell[1]
}

# And dashes.
function dashes_of(method)
{
    return method == "abm4_pecece" ? 4 : method ~ /^(semi_implicit|abm4_pec|adams)$/ ? 2 : 1
}
