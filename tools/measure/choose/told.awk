# Messages about candidates. Reads columns (columns.awk), then lines of method.sh.
#
#     what=progress   one line, of the cheapest of one method, behind `said`
#     what=table      a table of all, the cheapest first
#     what=take       the cheapest, its error and its cost
#     what=decides    the limit of the cheapest, its cost, and the cheapest of another method
#     what=cheapest   the line of the cheapest within `most_load`, as it came; what=any the cheapest of any load
#
# `period` in ns and `hz` are of the scene and of the chip.
#
#     awk -v what=WHAT -v period=NS -v hz=HZ -f bound.awk -f told.awk COLUMNS LINES
function step_of(ns) {
    return ns >= 1e6 ? sprintf("%.9g ms", ns / 1e6) : ns >= 1e3 ? sprintf("%.9g us", ns / 1e3) : sprintf("%d ns", ns)
}

function tick_of(ns, text) {
    text = step_of(ns)
    sub(/ /, "", text)
    return text
}

function time_of(ns) {
    if (ns >= 1e9) return sprintf("%.3g s", ns / 1e9)
    return ns >= 1e6 ? sprintf("%.3g ms", ns / 1e6) : ns >= 1e3 ? sprintf("%.3g us", ns / 1e3) : sprintf("%d ns", ns)
}

# As `rk4 at 4 ms`, from a line.
function named(line, w) {
    split(line, w, " ")
    if (w[1] ~ /^adams-/)
        return "adams at " step_of(period * w[3]) " in up to " w[4] " sub-step" (w[4] > 1 ? "s" : "") ", tolerance " substr(w[1], 7)
    return w[1] " at " step_of(period * w[3]) (w[4] > 1 ? " in " w[4] " sub-steps" : "") (w[2] == "yes" ? ", compensated" : "")
}

# The errors, the first of which is word `from`; of one bound without its output.
function errors_of(line, from, w, i, text) {
    split(line, w, " ")
    for (i = 1; i <= bounds; i++)
        text = text (i > 1 ? ", " : "") sprintf("%.2g", w[from + i - 1] * scale[i]) (unit[i] != "" ? " " unit[i] : "") \
            (bounds > 1 || what != "take" ? " of " output[i] : "")
    return text
}

function cost_of(line, w) {
    split(line, w, " ")
    return sprintf(w[6] < 10 ? "%s, %.2g %% of the chip" : "%s, %.0f %% of the chip", time_of(w[5] / hz * 1e9), w[6])
}

function share(line, w) {
    split(line, w, " ")
    return w[6] + 0
}

# The reason why there is none.
function why(line, w, text) {
    split(line, w, " ")
    if (w[4] == "unpriced") {
        text = line
        sub(/^.* none unpriced */, "", text)
        return w[2] == "yes" && plain[w[1]] == text ? "" : "no cycles are known: " (plain[w[1]] = text)
    }
    if (w[2] == "yes" && ((w[1] in has) || w[4] == plain[w[1]] || w[7] > 0.9 * least[w[1]])) return ""
    if (w[2] == "no" && w[5] != "") least[w[1]] = w[7]
    if (w[2] == "no" && w[5] == "") plain[w[1]] = w[4]
    if (w[4] == "steps" || w[4] == "rounding")
        return "no: " errors_of(line, 10) " at " step_of(period * w[5]) (w[6] > 1 ? " in " w[6] " sub-steps" : "") \
            (w[4] == "steps" ? "; more steps are dearer" : ", by rounding")
    text = line
    sub(/^[^ ]+ [^ ]+ none */, "", text)
    return text == "" ? "it ends early" : text
}

$3 == "none" { none[++nones] = $0; next }
{
    for (i = ++found; i > 1 && share(row[i - 1]) > share($0); i--) row[i] = row[i - 1]
    row[i] = $0
    has[$1]
}

function table(i, w, reason) {
    if (found) printf "%-44s %9s %9s %9s  %s\n", "method", "cycles", "time", "load", "error"
    for (i = 1; i <= found; i++) {
        split(row[i], w, " ")
        printf "%-44s %9s %9s %9s  %s\n", named(row[i]), w[5], time_of(w[5] / hz * 1e9), sprintf("%.3g %%", w[6]), errors_of(row[i], 11)
    }
    for (i = 1; i <= nones; i++) {
        split(none[i], w, " ")
        reason = why(none[i])
        if (reason != "") printf "%-44s %s\n", w[1] (w[2] == "yes" ? ", compensated" : ""), reason
    }
}

# The numbers that decide: the limit of the cheapest candidate, and the next one.
function decide(i, w, first) {
    split(row[1], first, " ")
    printf "%s: %s, %.0f %% of the bound%s.\n", named(row[1]), errors_of(row[1], 11), 100 * first[8],
        (first[7] == "-" ? "" : "; the next longer step has " (first[7] < 1e4 ? sprintf("%.0f %%", 100 * first[7]) : "none that stays"))
    printf "%s cycles in the dearest tick, %s; %.3g of %g %% of the chip.\n", first[5], time_of(first[5] / hz * 1e9), first[6], most_load
    if (first[3] > 1) printf "Its tick is %d times that of the scene; STEP=%s keeps it as it is.\n", first[3], tick_of(period)
    for (i = 2; i <= found; i++) {
        split(row[i], w, " ")
        if (w[1] != first[1]) {
            printf "Runner-up: %s: %s, %s: %.2f times as dear.\n", named(row[i]), errors_of(row[i], 11), cost_of(row[i]), w[6] / first[6]
            return
        }
    }
}

END {
    if (what == "progress") print said ": " (found ? named(row[1]) ": " errors_of(row[1], 11) ", " cost_of(row[1]) : why(none[1]))
    if (what == "table") table()
    if (what == "take") print named(row[1]) ": " errors_of(row[1], 11) ", " cost_of(row[1])
    if (what == "any" && found) print row[1]
    if (what == "cheapest" && found && share(row[1]) <= most_load) print row[1]
    if (what == "decides") decide()
}
