# A scene with other statements at its top: each that is given, `word=value ...`, stands in the place of the one that
# the scene has, or at the end. `word=-` takes it away. Status 1, and nothing printed, where the word `must` has no
# place of its own in this file.
#
#     awk -f edit.awk -v statements='method rk4; substeps 2; compensated -' [-v must=step] SCENE
function told(word, blanks) {
    seen[word] = 1
    return value[word] == "-" ? "" : blanks word " " value[word]
}

# A statement, or the text between two: unchanged, or with another value.
function statement(text, word, blanks, behind) {
    word = text
    sub(/^[ \t]+/, "", word)
    blanks = substr(text, 1, length(text) - length(word))
    behind = match(word, /[ \t]+$/) ? substr(word, RSTART) : ""
    sub(/[ \t].*/, "", word)
    return word in value ? told(word, blanks) behind : text
}

# A line: text in braces, in quotes or behind # stays.
function line(text, i, c, piece, out, quoted, was, nested) {
    was = text
    nested = depth > 0
    for (i = 1; i <= length(text); i++) {
        c = substr(text, i, 1)
        if (quoted || c == "\"") {
            quoted = c == "\"" ? !quoted : quoted
            piece = piece c
        } else if (c == "#") {
            break
        } else if (c == ";" && depth == 0) {
            out = out (nested ? piece : statement(piece)) c
            piece = ""
            nested = 0
        } else {
            depth += (c == "{") - (c == "}")
            nested = nested || c == "{" || c == "}"
            piece = piece c
        }
    }
    out = out (nested ? piece : statement(piece)) substr(text, i)
    sub(/^[ \t]*;[ \t]*/, "", out)
    if (out !~ /^[ \t]*$/ || was ~ /^[ \t]*$/) result = result out "\n"
}

BEGIN {
    n = split(statements, part, / *; */)
    for (i = 1; i <= n; i++) {
        word = part[i]
        sub(/ .*/, "", word)
        order[i] = word
        value[word] = substr(part[i], length(word) + 2)
    }
}
{ line($0) }
END {
    if (must != "" && !(must in seen)) exit 1
    for (i = 1; i <= n; i++)
        if (!(order[i] in seen) && value[order[i]] != "-") result = result order[i] " " value[order[i]] "\n"
    printf "%s", result
}
