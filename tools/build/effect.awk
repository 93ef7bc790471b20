# A scene with one effect more, from the list of effects and the scene.
#
#     awk -v effect=damping -f effect.awk effects.txt models/pendulum.scene
#
# Status 1 if the list has no such effect or the scene no joint that it could stand in.
BEGIN { FS = " *[|] *" }

FNR == NR {
    if ($1 == effect && NF == 3) {
        in_joint = $2
        statement = $3
        known = 1
    }
    next
}

{ print }

/^joint / { joint = 1 }

joint && /^ *axis / {
    if (in_joint != "")
        print "    " in_joint
    placed = 1
    joint = 0
}

END {
    if (!known || !placed) {
        print "effect.awk: there is no place for '" effect "'" > "/dev/stderr"
        exit 1
    }
    if (statement != "")
        print statement
}
