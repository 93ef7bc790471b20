# The cheapest tick of adams with which every error stays below its bound. Its sub-steps vary with the error; the cost
# of its dearest tick is bounded by their number, at any tolerance.
#
#     awk -v one=CYCLES -v more=CYCLES -v least=RATE -v ticks=LIST -v period=NS -v rows=ROWS -v every=ROWS -v longest=K -f adams.awk
#
# A tick of one sub-step takes `one` cycles at most, each further sub-step `more`; `least` cycles per second and more
# are too dear. For each tick, the longest first, the most sub-steps that are not too dear are tried: if they keep the
# bounds, half as many, until these do not; if not, a tick as long as the error lets expect. Prints `method METHOD`,
# with the tolerance, as adams-1e-06, and `found K N 0 RATIO BOUND ROW ERROR...`; or `none` and why.
function rate(k, n) { return (one + (n - 1) * more) / (period * k) * 1e9 }

# The largest error in its bound with so many sub-steps; of some tolerances, as long as that could help. `text` is the
# result of try.sh for the best of them, `method` its name.
function ratio(k, n, i, command, said, word, best) {
    best = HUGE
    for (i = 1; i <= tolerances && (i == 1 || (best > 1 && best < 4)); i++) {
        command = "sh tools/measure/choose/try.sh adams-" tolerance[i] " no " k " " n
        said = "inf no answer"
        command | getline said
        close(command)
        tries++
        split(said, word, " ")
        if (word[1] != "inf" && word[1] + 0 < best) {
            best = word[1] + 0
            text = said
            method = "adams-" tolerance[i]
        }
    }
    return best
}

# The most sub-steps in a tick that are not too dear; 0 if there are none.
function most(k, n) {
    for (n = k == 1 ? 1024 : 64; n >= 1 && rate(k, n) >= least; n /= 2) continue
    return n < 1 ? 0 : n
}

BEGIN {
    HUGE = 1e300
    tolerances = split("1e-06 1e-04 1e-08", tolerance, " ")
    count = split("1 " ticks, tick, " ")
    wanted = longest
    for (i = count; i >= 1; i--) {
        k = tick[i] + 0
        if (k > wanted || k * period > 1e9 && k > 1 || k * every * 8 > rows && k > 1) continue
        for (n = most(k); n >= 1; n /= 2) {
            r = ratio(k, n)
            if (r > 1) break
            least = rate(k, n)
            found = "method " method "\nfound " k " " n " 0 " text
            wanted = k
        }
        # Where the most do not keep the bounds, the error is of the tick, which is of the first order in it at least.
        if (n == most(k) && n >= 1) wanted = k * 1.3 * (r >= HUGE ? 0.5 : r ^ -0.5)
    }
    if (found != "") print found
    else printf "none no: %d cycles for a tick of one sub-step, %d for each more: %s\n", one, more, \
        tries ? "what is cheaper than the best, and within the load, does not keep the bound" : "dearer at every tick than the best, or than the load"
}
