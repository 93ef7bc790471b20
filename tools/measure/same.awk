# A scene in which values of effects that follow from step and method are written, so that they are the same for all
# methods: reads their values by isoc, lines `stable EFFECT.VALUE NUMBER UNIT`, then the scene as `-`. An included file
# takes the place of its statement if that has its own line.
FILENAME != "-" {
    if ($1 == "stable" && split($2, name, ".") == 2) written[name[1]] = written[name[1]] " " name[2] " " $3 " " $4 ";"
    next
}
{ put($0, "") }

# A line of a file in this folder, which ends with a slash.
function put(text, folder, word, brace, path, inner, line)
{
    split(text, word, " ")
    if (text ~ /^ *include *"[^"]*" *(#.*)?$/) {
        split(text, word, "\"")
        path = word[2] ~ /^\// ? word[2] : folder word[2]
        inner = path
        sub(/[^\/]*$/, "", inner)
        while ((getline line < path) > 0) put(line, inner)
        close(path)
        return
    }
    if (word[1] == "effect" && (word[2] in written) && (brace = index(text, "{")))
        text = substr(text, 1, brace) written[word[2]] substr(text, brace + 1)
    print text
}
