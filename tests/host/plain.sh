# shellcheck shell=sh
# PLAIN: plain(line), a function of awk: a line of C without strings, and without what of it is a comment. `inside` is
# whether the line begins in one; a reader of several files sets it to 0 at the begin of each.
# shellcheck disable=SC2034
PLAIN='function plain(line, text, at) {
    gsub(/"([^"\\]|\\.)*"|\x27([^\x27\\]|\\.)*\x27/, "0", line)
    for (text = ""; line != "";) {
        at = index(line, inside ? "*/" : "/*")
        if (!inside) text = text (at ? substr(line, 1, at - 1) : line)
        line = at ? substr(line, at + 2) : ""
        if (at) inside = !inside
    }
    return text
}
'
