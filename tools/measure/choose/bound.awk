# The bounds of make choose, of lines of columns.awk, which are the first file. Of all their columns in turn `column`
# has the number in a plant, and `bound_of` which bound it is of.
FNR == 1 { file++ }
file == 1 {
    bounds = FNR
    split($0, cell, "|")
    value[bounds] = cell[2] + 0
    unit[bounds] = cell[4]
    scale[bounds] = cell[5]
    output[bounds] = cell[6]
    angle[bounds] = cell[7] == "rad"
    n = split(cell[3], part, ",")
    for (i = 1; i <= n; i++) {
        column[++columns] = part[i]
        bound_of[columns] = bounds
    }
    next
}

# A difference of a bound; angles may be turns apart.
function turned(d, bound, turn)
{
    turn = 6.283185307179586
    return angle[bound] && d * d > 36 ? d - turn * int(d / turn + (d > 0 ? 0.5 : -0.5)) : d
}
