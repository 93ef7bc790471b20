# The largest tick of a method in float, or the fewest steps in a tick, with which every error stays below its bound.
#
#     awk -v method=M -v compensated=no|yes -v order=P -v least=RATE -v evaluations=N -v each=CYCLES -v ticks=LIST -v period=NS -v rows=ROWS -v every=ROWS \
#         -v longest=K [-v from=PLACE [-v only=coarser]] -f search.awk
#
# Of more steps in a tick the evaluations alone, of `each` cycles, would take more than `least` cycles per second.
#
# Places on the grid: at 0 the tick is the scene's step and one step long; at 1, 2, ... it is so many of the scene's
# steps as `ticks` says; at -1, -2, ... it has as many steps as divide it. Prints `found K N PLACE RATIO BOUND ROW
# ERROR...` and `next K N RATIO ...`, the place that is one coarser; or `none`, why, and the K, N and RATIO ... of the
# least error.
#
# Where the place 0 keeps the bounds, places are tried to coarser ones until AGAIN in turn do not, or the next is
# hopeless; else to finer ones, until one does. It leaps as far as the order of the method says; the places that it
# leapt over are tried backwards.
function at(place) { return place > 0 ? tick[place] : place < 0 ? 1 / parts[-place] : 1 }
function k_of(place) { return place > 0 ? tick[place] : 1 }
function n_of(place) { return place < 0 ? parts[-place] : 1 }

# The largest error in its bound; each place is tried once.
function ratio(place, command, text) {
    if (place in tried) return value(place)
    command = "exec sh tools/measure/choose/try.sh " method " " compensated " " k_of(place) " " n_of(place)
    text = "inf no answer"
    command | getline text
    close(command)
    tried[place] = text
    return value(place)
}

function value(place, word) {
    split(tried[place], word, " ")
    return word[1] == "inf" ? HUGE : word[1] + 0
}

# The place whose step is that much longer, or less, in the direction of `by`; at least the next.
function leap(place, by, r, wanted, to) {
    wanted = r >= HUGE || r <= 0 ? 1 : r ^ (-1 / order)
    if (r <= 0) wanted = 4
    wanted *= at(place) * (by > 0 ? 0.95 : 1.3)
    for (to = place + by; to + by <= coarsest && to + by >= finest && (by > 0 ? at(to + by) <= wanted : at(to) > wanted); to += by) continue
    return to
}

# From a place that is good to coarser ones; returns the coarsest that is good.
function coarser(place, to, i) {
    for (;;) {
        for (to = leap(place, 1, ratio(place)); to > place && to <= coarsest && ratio(to) > 1; to--) continue
        for (i = 2; to <= place && i <= AGAIN && place + i <= coarsest && ratio(place + 1) <= HOPELESS; i++)
            if (ratio(place + i) <= 1) to = place + i
        if (to <= place || to > coarsest) return place
        place = to
    }
}

# From a place that is not good to coarser ones, as long as the error hardly grows: then it is that of rounding, of
# which fewer steps have less. Returns the coarsest that is good, or finest - 1.
function fewer_roundings(place, to, grown) {
    for (to = place + 1; ratio(place) < HUGE && to <= coarsest && grown < 2; to++) {
        if (ratio(to) <= 1) return coarser(to)
        if (ratio(to) > 8 * ratio(place)) break
        grown += ratio(to) > 2 * ratio(place)
    }
    return finest - 1
}

# From a place that is not good to finer ones; returns the coarsest good one that is known, or finest - 1.
function finer(place, to, stuck, between, was) {
    while (place > finest) {
        was = ratio(place)
        to = leap(place, -1, was)
        if (ratio(to) <= 1) {
            for (between = place - 1; between > to && ratio(between) > 1; between--) continue
            return between
        }
        stuck = ratio(to) < HUGE && ratio(to) > 0.7 * was ? stuck + 1 : 0
        if (stuck > 3) {
            why = "rounding"
            break
        }
        place = to
    }
    return finest - 1
}

BEGIN {
    HUGE = 1e300
    AGAIN = 3
    HOPELESS = 50
    most_n = int(least * period * 1e-9 / (evaluations * each))
    n = split(ticks, part, " ")
    for (i = 1; i <= n; i++) {
        if (part[i] <= longest && part[i] * period <= 1e9 && part[i] * every * 8 <= rows) tick[++coarsest] = part[i]
        if (period % part[i] == 0 && period / part[i] >= 1000 && part[i] <= most_n) parts[++deepest] = part[i]
    }
    finest = -deepest
    from = from < finest ? finest : from + 0
    if (from > coarsest) {
        print "none no longer tick"
        exit
    }
    place = ratio(from) <= 1 ? coarser(from) : only == "coarser" ? finest - 1 : fewer_roundings(from)
    if (place < finest && only != "coarser") place = finer(from)
    if (place < finest) {
        best = HUGE
        for (i in tried) if (value(i) < best) { best = value(i); which = i }
        if (best == HUGE) print "none " (from in tried ? substr(tried[from], 5) : "")
        else print "none", (why != "" ? why : "steps"), k_of(which), n_of(which), tried[which]
        exit
    }
    print "found", k_of(place), n_of(place), place, tried[place]
    if (place < coarsest) {
        ratio(place + 1)
        print "next", k_of(place + 1), n_of(place + 1), tried[place + 1]
    }
}
