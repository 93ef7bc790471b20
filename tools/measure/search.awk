# Searches with a program of drive.c, at `time`, for steps with which the error is at most `error`.
#
#     awk -v drive=COMMAND -v time=TIME -v most=ERROR [-v coarsest=STEPS] -f reference.awk -f search.awk REFERENCE
#
# With `coarsest`: the errors with 2 and with 4 times as many steps, the fewest steps from which on the error stays at
# most that, 0 if they are shorter than 1 us, and `-`. Without, of a program that takes a tolerance: `- -`, the steps
# with the largest tolerance from which on it stays at most that, and that tolerance; zeros if there is none.

# Runs the program with the numbers of steps or tolerances in `argument`; fills steps and error, with four digits.
function measure(arguments, command, i, n)
{
    for (i = 1; i <= arguments; i++) command = command " " argument[i]
    command = "exec " drive " " time command
    while ((command | getline) > 0) {
        steps[++n] = $1
        error[n] = sprintf("%.3e", error_from(time, 3)) + 0
    }
    if (close(command) || n != arguments) fail(drive " does not run")
}

function error_with(n)
{
    argument[1] = n
    measure(1)
    return error[1]
}

# The first argument from which on all errors are small enough: one more than there are if there is none.
function first_within(arguments)
{
    for (arguments++; arguments > 1 && error[arguments - 1] <= most; arguments--) continue
    return arguments
}

function larger(a, b) { return a < b ? b : a }

# Doubles the steps until the error is far below, goes back over a grid of sixteen to a doubling to the first that is
# small enough, and halves the interval before it.
function fewest(n, at, points, first, few, enough, middle)
{
    for (n = coarsest; !(error_with(n) <= most / 16) && n < int(time * 1e6); n = 2 * n < int(time * 1e6) ? 2 * n : int(time * 1e6)) continue
    for (at = larger(1, int(n / 256)); at < n; at = larger(at * 2 ^ (1 / 16), at + 1)) argument[++points] = int(at)
    argument[++points] = n
    measure(points)
    first = first_within(points)
    few = first == 1 ? 0 : steps[first - 1]
    enough = first > points ? 0 : steps[first]
    while (enough - few > 1) {
        middle = int((few + enough) / 2)
        if (error_with(middle) <= most) enough = middle
        else few = middle
    }
    return enough
}

# A grid of tolerances, four to a doubling.
function loosest(tolerance, points, first)
{
    for (tolerance = 1e-2; tolerance > 1e-13; tolerance /= 2 ^ (1 / 4)) argument[++points] = sprintf("%.3g", tolerance)
    measure(points)
    first = first_within(points)
    return first > points ? "0 0" : steps[first] " " argument[first]
}

BEGIN {
    read_reference(ARGV[1])
    if (!(time in unsure)) fail(ARGV[1] ": no reference after " time " s")
    if (coarsest == "") print "- - " loosest()
    else printf "%.3e %.3e %d -\n", error_with(2 * coarsest), error_with(4 * coarsest), fewest()
}
