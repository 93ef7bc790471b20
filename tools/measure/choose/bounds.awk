# The bounds of ERROR: of the environment. Prints a line for each, NUMBER|VALUE|OUTPUT, or one that begins with `error`.
BEGIN {
    text = ENVIRON["ERROR"]
    n = split(text, part, ";")
    for (i = 1; i <= n; i++) {
        bound = part[i]
        gsub(/^[ \t]+|[ \t]+$/, "", bound)
        if (bound == "" && i == n && told > 0) break
        if (bound !~ /^[-+]?([0-9]+[.]?[0-9]*|[.][0-9]+)([eE][-+]?[0-9]+)?[ \t]*[^ \t]*.* of [A-Za-z_][A-Za-z0-9_]*$/) {
            print "error '" bound "' is no bound; it could be '1 mm of tip', or several: '1 mm of tip; 0.1 deg of theta'"
            exit
        }
        if (bound + 0 <= 0) {
            print "error '" bound "' is no bound: it must be greater than 0"
            exit
        }
        value = output = bound
        sub(/ of [^ ]*$/, "", value)
        sub(/.* of /, "", output)
        told++
        lines = lines told "|" value "|" output "\n"
    }
    printf "%s", lines
}
