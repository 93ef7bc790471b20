# The text of `make cycles`: the cost of the dearest of some ticks, as build/cycles counts them, and whether it fits.
# The numbers go to the file `tsv`. Status 1 if something does not fit.
#
#     awk -f program_size.awk -f report.awk scene=... board=... hz=... period=NS flash=... ram=... tsv=FILE sizes=FILE TICK...
#
# The file `sizes` has those of the firmware.
BEGIN { FS = "\t" }
FNR == 1 { of++ }
$1 == "part" || $1 == "kind" { names[of, $1] = names[of, $1] "\t" $2 }
{ for (i = $1 == "part" || $1 == "kind" ? 3 : 2; i <= NF; i++) cell[of, $1, i == 2 ? "" : $2, i] = $i }

function fact(key) { return cell[dearest, key, "", 2] }
function cycles(least, most) { return least < most ? sprintf("%.0f to %.0f", least, most) : sprintf("%.0f", most) }

# The rows of parts of the tick, in microseconds, or of kinds of instructions in the step, as shares of it.
function rows(what, of_step, n, name, i, least, most, last) {
    n = split(substr(names[dearest, what], 2), name, "\t")
    for (i = 1; i <= n; i++) {
        least = cell[dearest, what, name[i], 4] + 0
        most = cell[dearest, what, name[i], 5] + 0
        last = what == "part" ? most / hz * 1e6 : 100 * most / of_step
        if (what == "part" || most > 0)
            printf (what == "part" ? "%-10s%14d%20s%12.2f\n" : "%-10s%14d%20s%10.1f %%\n"), name[i], cell[dearest, what, name[i], 3],
                cycles(least, most), last
        printf "%s\t%s\t%d\t%s\t%s\t%.4g\n", what, name[i], cell[dearest, what, name[i], 3], least, most, last >tsv
    }
}

function fits_in(name, bytes, there) {
    printf "%-14s%d of %d bytes\n", name, bytes, there
    printf "%s\t%d\t%d\n", name, bytes, there >tsv
    return bytes <= there ? "" : ": too much " name
}

END {
    while ((getline line <sizes) > 0) add_size(line)
    need_sizes()
    for (i = 1; i <= of; i++)
        if (!dearest || cell[i, "part", "tick", 5] > cell[dearest, "part", "tick", 5]) dearest = i
    if (!dearest || cell[dearest, "part", "tick", 5] == "" || !(hz > 0 && period > 0)) {
        print "cycles: there is no tick, no clock or no step" >"/dev/stderr"
        exit 1
    }
    printf "%s on the %s, %s at %s MHz\n\n", scene, fact("core"), board, hz / 1e6
    printf "%-10s%14s%20s%12s\n", "part", "instructions", "cycles", "us"
    rows("part")
    printf "\n%-10s%14s%20s%12s\n", "the step", "instructions", "cycles", "share"
    rows("kind", cell[dearest, "part", "step", 5])
    printf "\n%-14snumber %s of %s, the dearest of %s; their mean takes %s cycles\n", "tick", fact("number"), fact("ticks"), fact("of"),
        fact("mean")
    least = cell[dearest, "part", "tick", 4] + cell[dearest, "part", "interrupt", 4]
    most = cell[dearest, "part", "tick", 5] + cell[dearest, "part", "interrupt", 5]
    printf "%-14s%.2f %% of a step of %s ms\n", "load", most / hz / period * 1e11, period / 1e6
    printf "%-14s%.1f Hz, a step of %.2f us\n", "highest rate", hz / most, most / hz * 1e6
    printf "load_percent\t%.4f\t%.4f\n", least / hz / period * 1e11, most / hz / period * 1e11 >tsv
    printf "highest_rate_hz\t%.2f\t%.2f\n", hz / most, hz / least >tsv
    printf "%-14s%d bytes, of which the step takes %d\n", "stack", fact("stack"), fact("stack_of_step")
    printf "stack\t%d\t%d\n", fact("stack"), fact("stack_of_step") >tsv
    why = most / hz <= period / 1e9 ? "" : ": the tick is longer than the step"
    why = why fits_in("RAM", data_bss() + fact("stack"), ram)
    why = why fits_in("flash", text + data, flash)
    printf "%-14s%s\n%-14s%s\n%-14sno wait states, no entry of interrupts\n", "timings", fact("source"), "", fact("note"), ""
    printf "%-14s%s\n", "numbers", tsv
    print (why == "" ? "fits" : "does not fit" why)
    print "verdict\t" (why == "" ? "fits" : "does not fit") >tsv
    exit why != ""
}
