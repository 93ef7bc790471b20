# The reference of a report: lines of a time, how much the two methods differ there that it was computed by, and the
# state.
BEGIN { INFINITE = 1e300 } # an error that is infinite, or no number

function fail(text)
{
    print "accuracy: " text > "/dev/stderr"
    failed = 1
    exit 1
}

# Fills unsure[time], states, and reference[time, i].
function read_reference(path, line, cell, cells, i)
{
    while ((getline line < path) > 0) {
        cells = split(line, cell, " ")
        unsure[cell[1]] = cell[2]
        states = cells - 2
        for (i = 1; i <= states; i++) reference[cell[1], i] = cell[i + 2]
    }
}

# The error of the state that begins with this field of the line: the 2-norm of the difference to the reference.
function error_from(time, first, i, off, square)
{
    for (i = 1; i <= states; i++) {
        if ($(first + i - 1) ~ /inf|nan/) return INFINITE
        off = $(first + i - 1) - reference[time, i]
        square += off * off
    }
    return square < INFINITE ? sqrt(square) : INFINITE
}
