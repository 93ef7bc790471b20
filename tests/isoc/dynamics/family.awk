# The members of a family: for each scene of the arguments and the plant that isoc wrote of it, FOLDER/NAME.scene and
# then FOLDER/NAME.c, the source FOLDER/NAME.member.c with its equations in reach; and FOLDER/family.c, the list of all.
FNR == 1 && /^#/ { # the head of the scene: "# A random loop, of seed 3."
    file = FILENAME
    sub(/\.scene$/, "", file)
    name = file
    sub(/.*\//, "", name)
    kind = $4 == "loop," ? "loop" : "tree"
    seed = $7 + 0
    twice = settles = tunes = holds = 0
    pivots = kept = settle_more = ""
}
/iterations 2/ { twice = 1 }
/^static void settle/ {
    settles = 1
    settle_more = (/[^a-z]u[,)]/ ? ", memory.u" : "") (/[^a-z]p[,)]/ ? ", p" : "")
}
/^    real pivots\[[0-9]*\];$/ && pivots == "" { pivots = $2 }
/^    real h\[[0-9]*\];$/ && kept == "" { kept = $2 }
/^static void tune/ { tunes = 1 }
/^static void hold/ { holds = 1 }
FILENAME == file ".c" && /^const iso_model / { write_member() }

# What follows the method in a step.
function settle_text(    call) {
    if (!settles) {
        return ""
    }
    call = "settle(x" settle_more (pivots == "" ? "" : ", pivots") ");"
    return (pivots == "" ? "" : "real " pivots " ") call (twice ? " " call : "")
}

# What the equations read of tunables and inputs: the plant keeps what follows from tunables, a step the rest.
function held_text(    from, array) {
    array = kept
    sub(/^h/, "kept", array)
    from = tunes ? "memory.h" : kept == "" ? "0" : "kept"
    return (!tunes && kept != "" ? "static real " array " " : "") (holds ? "hold(" from ", memory.u); " : "") "return " from ";"
}

function write_member(    to) {
    to = file ".member.c"
    print "#include \"" file ".c\"\n#include \"tests/isoc/dynamics/family.h\"" >to
    print "static " name "_memory memory;" >to
    print "static iso_plant plant_of(void)\n{\n    return " name "_plant(&memory);\n}" >to
    print "static void settle_after(real *const x, const real *const p)\n{\n    (void)x;\n    (void)p;\n    " settle_text() "\n}" >to
    print "static const real *held_of(void)\n{\n    " held_text() "\n}" >to
    print "extern const family_member " name ";\nconst family_member " name " = {\"" kind " " seed "\", " \
        (kind == "loop" ? "true" : "false") ", " seed ", plant_of, &equations, held_of, settle_after};" >to
    close(to)
    folder = file
    sub(/[^\/]*$/, "", folder)
    members = members "extern const family_member " name ";\n"
    list = list "    &" name ",\n"
}
END {
    printf "#include \"tests/isoc/dynamics/family.h\"\n%sconst family_member *const family[] = {\n%s    0};\n", members, list >(folder "family.c")
}
