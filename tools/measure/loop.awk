# The table of make bench of a loop, and the winners. Input: a line for each method, with the results of search.awk for
# held and smooth inputs, `-` for none, and the instructions of a step with either. A tick is a step of the scene.
#
#     awk -v time=TIME -v step=STEP -v error=ERROR -f loop.awk MEASURED
BEGIN {
    printf "| method | held: error, %g ms | steps a tick for %s | instructions | per second | smooth: error, %g ms | step for %s, ms | " \
        "instructions | per second |\n|---|--:|--:|--:|--:|--:|--:|--:|--:|\n", 1000 * step, error, 1000 * step, error
    ticks = int(time / step + 0.5)
}

# A number in a format, unless there is none.
function told(format, value) { return value == "-" ? value : sprintf(format, value) }

# The least value of a reading so far, and its method.
function take(what, value)
{
    if (value == "-" || what in winner && value + 0 >= least[what]) return
    winner[what] = $1
    least[what] = value + 0
}

# The cells of a reading: `first` is the field of the result of search.awk, `counted` that of the instructions. With
# held inputs every tick has as many steps.
function cells(reading, first, counted, steps, cost)
{
    steps = $(first + 2) > 0 ? $(first + 2) : "-"
    if (steps != "-" && reading == "held") steps = ticks * (int(steps / ticks) + (steps % ticks > 0))
    cost = steps == "-" || $counted == "-" ? "-" : $counted * steps / time
    take("error " reading, $(first + 1))
    take("cost " reading, cost)
    return told("%.2e", $(first + 1)) " | " (steps == "-" ? steps : sprintf("%.3g", reading == "held" ? steps * step / time : 1000 * time / steps)) \
        " | " told("%.0f", $counted) " | " told("%.0f", cost)
}

{ print "| " $1 " | " cells("held", 2, 10) " | " cells("smooth", 6, 11) " |" }

function announce(reading)
{
    if ("error " reading in winner) print "- Inputs " reading ": the least error with one step a tick: " winner["error " reading] "."
    if ("cost " reading in winner)
        print "- Inputs " reading ": the fewest instructions for an error of " error ": " winner["cost " reading] "."
}

END {
    print ""
    announce("held")
    announce("smooth")
    exit !("cost held" in winner || "cost smooth" in winner)
}
