# A part of the page of a report, as HTML: what its table says in words, if the part is more than a table; the picture,
# if one is named; and the table. Each number in a text is made of a cell of a table, and names it: data-cell has the
# file, the line and the column; tests/tools/lab/report.t looks them up.
#
#     awk -v part=table|errors|growth|local_error|account|nearness|singular|tick|regions -v file=NAME.tsv \
#         [-v picture=FILE.svg -v title=TEXT] -f page.awk FILE
BEGIN { FS = "\t" }

function escaped(text)
{
    gsub(/&/, "\\&amp;", text)
    gsub(/</, "\\&lt;", text)
    return text
}

# Cell c of line r in short.
function number(r, c, size)
{
    size = cell[r, c] < 0 ? -cell[r, c] : cell[r, c]
    return sprintf("<data value='%s' data-cell='%s:%d:%d'>" (size >= 100 && size < 1e7 ? "%.0f" : "%.3g") "</data>", cell[r, c], file, r, c,
        cell[r, c])
}

{
    for (c = 1; c <= NF; c++) cell[NR, c] = $c
    columns[NR] = NF
}

function put_picture(command, text)
{
    command = "exec base64 -w 0 '" picture "'"
    command | getline text
    close(command)
    print "<figure><img alt=\"" title "\" src=\"data:image/svg+xml;base64," text "\"></figure>"
}

# All of the table.
function put_table(r, c, tag)
{
    printf "<details><summary>%s, %d lines</summary>\n<table data-file='%s'>\n", file, NR, file
    for (r = 1; r <= NR; r++) {
        tag = r == 1 ? "th" : "td"
        printf "<tr>"
        for (c = 1; c <= columns[r]; c++) printf "<%s>%s</%s>", tag, escaped(cell[r, c]), tag
        print "</tr>"
    }
    print "</table></details>"
}

# Of each kind the least error and its place, and the cheapest that has at most a thousand times it.
function put_errors(unit, r, kinds, k, kind, best, cheap)
{
    for (r = 2; r <= NR; r++) {
        if (cell[r, 5] == "inf" || cell[r, 5] + 0 <= 0) continue
        if (!(cell[r, 1] in best)) kind[++kinds] = cell[r, 1]
        k = cell[r, 1]
        if (!(k in best) || cell[r, 5] + 0 < cell[best[k], 5] + 0) best[k] = r
    }
    for (r = 2; r <= NR; r++) {
        k = cell[r, 1]
        if (cell[r, 5] == "inf" || !(k in best) || cell[r, 5] + 0 > 1000 * cell[best[k], 5]) continue
        if (!(k in cheap) || cell[r, 8] + 0 < cell[cheap[k], 8] + 0) cheap[k] = r
    }
    print "<ul>"
    for (k = 1; k <= kinds; k++) {
        r = best[kind[k]]
        printf "<li><b>%s</b>: no error is below %s: %s, steps of %s s, %s %s per second. ", kind[k], number(r, 5),
            cell[r, 2], number(r, 3), number(r, 8), unit
        r = cheap[kind[k]]
        printf "Of those within a factor of a thousand the cheapest is %s with steps of %s s: error %s, %s %s per second.</li>\n",
            cell[r, 2], number(r, 3), number(r, 5), number(r, 8), unit
    }
    print "</ul>"
}

# The last line of each kind.
function put_growth(r, said)
{
    for (r = 2; r <= NR; r++)
        if (r == NR || cell[r + 1, 1] != cell[r, 1])
            said = said (said == "" ? "" : ", ") sprintf("%s in %s", cell[r, 5] == "inf" ? "lost" : number(r, 5), cell[r, 1])
    printf "<p>%s with a step of %s s; the error after %s s is %s.</p>\n", cell[2, 2], number(2, 3), number(NR, 4), said
}

# The line where a column has its least value, with sign -1, or its largest, with 1; of those that begin with `of`.
function extreme(c, sign, of, r, found)
{
    for (r = 2; r <= NR; r++)
        if ((of == "" || cell[r, 1] == of) && (!found || sign * cell[r, c] > sign * cell[found, c])) found = r
    return found
}

# The line with the largest error, and that with the middle one of the ratios.
function put_local_error(r, other, most, below, ratios, middle)
{
    most = extreme(3, 1)
    for (r = 2; r <= NR; r++) if (cell[r, 4] != "-") ratios++
    for (r = 2; r <= NR && !middle; r++) {
        if (cell[r, 4] == "-") continue
        below = 0
        for (other = 2; other <= NR; other++)
            if (cell[other, 4] != "-" && (cell[other, 4] + 0 < cell[r, 4] + 0 || (cell[other, 4] == cell[r, 4] && other < r))) below++
        if (below == int(ratios / 2)) middle = r
    }
    printf "<p>%s with a step of %s s: the largest error of a step is %s, after %s s, and the method tells %s there.", cell[2, 6],
        number(2, 5), number(most, 3), number(most, 1), number(most, 2)
    if (middle) printf " In half of the steps it tells less than %s times the error.", number(middle, 4)
    print "</p>"
}

function put_nearness()
{
    if (cell[2, 2] + 0 > 0)
        printf "<p>%s of %s ticks are near a singular position of the closures, from %s s in <b>%s</b>: there the step is too long for the " \
            "motion, and energy can be lost or gained.</p>\n", number(2, 2), number(2, 1), number(2, 3), escaped(cell[2, 4])
    else
        printf "<p>Of %s ticks %s are near a singular position of the closures.</p>\n", number(2, 1), number(2, 2)
}

# Where the least pivot is, and the largest change and violation.
function put_singular(least, change, apart)
{
    least = extreme(2, -1)
    change = extreme(3, 1)
    apart = extreme(4, 1)
    printf "<p>The least pivot is %s of its largest, at %s s; the largest change in a step is by a factor of %s, at %s s; the largest " \
        "violation is %s, at %s s.</p>\n", number(least, 2), number(least, 1), number(change, 3), number(change, 1), number(apart, 4), number(apart, 1)
}

function put_account(r)
{
    print "<ul>"
    for (r = 2; r <= NR; r++)
        printf "<li><b>%s</b>%s: %s at the start, %s at the end, between %s and %s.</li>\n", cell[r, 1],
            (cell[r, 2] == "" ? "" : ", " cell[r, 2]), number(r, 3), number(r, 4), number(r, 5), number(r, 6)
    print "</ul>"
}

# The eigenvalues that are farthest to the left, to the right and up.
function put_regions(left, right, up)
{
    left = extreme(2, -1, "eigenvalue")
    right = extreme(2, 1, "eigenvalue")
    up = extreme(3, 1, "eigenvalue")
    printf "<p>The fastest decay times the step is %s, the fastest growth %s, the fastest oscillation %s.</p>\n", number(left, 2),
        number(right, 2), number(up, 3)
}

# A bar for each target: the parts of a tick by their share of its cycles.
function put_tick(r, share, total, last)
{
    for (r = 2; r <= NR; r++) if (cell[r, 2] == "tick") total[cell[r, 1]] = r
    for (r = 2; r <= NR; r++) {
        if (cell[r, 1] != last) {
            last = cell[r, 1]
            if (r > 2) print "</div>"
            printf "<p><b>%s</b>: a tick takes at most %s cycles, %s us.</p>\n<div class='bar'>", last, number(total[last], 5), number(total[last], 6)
        }
        if (cell[r, 2] == "tick" || cell[r, 2] == "interrupt" || cell[r, 5] + 0 == 0) continue
        share = 100 * cell[r, 5] / cell[total[last], 5]
        printf "<span class='%s' style='flex-grow:%.4g' title='%s: %s cycles'>%s</span>", cell[r, 2], share, cell[r, 2], cell[r, 5],
            (share > 9 ? cell[r, 2] : "")
    }
    print "</div>"
    print "<p class='key'><i class='loop'></i>loop <i class='inputs'></i>inputs <i class='checks'></i>checks <i class='step'></i>step " \
        "<i class='finish'></i>finish <i class='outputs'></i>outputs <i class='tell'></i>tell <i class='port'></i>port</p>"
}

END {
    if (part == "errors") put_errors(file ~ /cycles/ ? "cycles" : "instructions")
    if (part == "growth") put_growth()
    if (part == "local_error") put_local_error()
    if (part == "nearness") put_nearness()
    if (part == "singular") put_singular()
    if (part == "account") put_account()
    if (part == "tick") put_tick()
    if (part == "regions") put_regions()
    if (picture != "") put_picture()
    put_table()
}
