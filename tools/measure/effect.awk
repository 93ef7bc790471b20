# A scene with one effect more, of a list of lines `NAME | STATEMENT IN A JOINT | STATEMENT`. Status 1 if the list has
# no such effect, or the scene no joint that it could stand in.
#
#     awk -v name=NAME -f effect.awk effects.txt models/pendulum.scene
BEGIN { FS = " *[|] *" }
FILENAME == ARGV[1] {
    sub(/^ +/, "")
    sub(/ +$/, "")
    if (NF == 3 && $1 == name) {
        found = 1
        inside = $2
        statement = $3
    }
    next
}
!found { exit }
{ print }
/^joint / { in_joint = 1 }
in_joint && /^ *axis/ {
    if (inside != "") print "    " inside
    placed = 1
    in_joint = 0
}
END {
    if (!placed) {
        print "effect: there is no place for '" name "'" > "/dev/stderr"
        exit 1
    }
    if (statement != "") print statement
}
