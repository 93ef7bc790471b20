# A scene in which values of effects that follow from step and method are written, so that they are the same for all
# methods: reads what isoc says of them, lines `stable EFFECT.VALUE NUMBER UNIT`, then the scene as `-`.
FILENAME != "-" {
    if ($1 == "stable" && split($2, name, ".") == 2) written[name[1]] = written[name[1]] " " name[2] " " $3 " " $4 ";"
    next
}
$1 == "effect" && ($2 in written) && (brace = index($0, "{")) {
    $0 = substr($0, 1, brace) written[$2] substr($0, brace + 1)
}
{ print }
