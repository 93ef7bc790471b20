# A duration such as 1ms, 500us, 0.001 or 2.5e-3 s, in whole nanoseconds; with -v as=seconds, the same as a decimal
# number of seconds. Without a unit it is in seconds.
#
#     awk -v text=1ms -v least=1 -v most=2e9 -f nanoseconds.awk
#
# Prints nothing and exits with status 1 if the text is no duration, no whole number of nanoseconds, or out of bounds.
BEGIN {
    scale["s"] = 1e9
    scale["ms"] = 1e6
    scale["us"] = 1e3
    scale["ns"] = 1
    scale[""] = 1e9

    if (text !~ /^([0-9]+\.?[0-9]*|\.[0-9]+)([eE][-+]?[0-9]+)? *(s|ms|us|ns)?$/)
        exit 1
    unit = text
    sub(/^[0-9.]+([eE][-+]?[0-9]+)? */, "", unit)
    number = substr(text, 1, length(text) - length(unit))
    exact = number * scale[unit]
    whole = int(exact + 0.5)
    error = exact < whole ? whole - exact : exact - whole
    if (error > 1e-9 * exact || whole < least || whole > most)
        exit 1
    if (as != "seconds") {
        printf "%.0f\n", whole
        exit 0
    }
    seconds = sprintf("%.9f", whole / 1e9)
    sub(/0+$/, "", seconds)
    sub(/\.$/, ".0", seconds)
    print seconds
}
