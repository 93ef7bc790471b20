# The deepest stack of a function and of all that it calls, in bytes, from gcc's -fcallgraph-info=su.
#
#     awk -v root=step -f stack.awk plant.ci
#
# Prints the path with the frame of each function. Status 1 if there is no bound: recursion, a call through a pointer,
# a frame that grows at run time, or a function whose frame is not in the file.
function fail(message) {
    print "stack: " message > "/dev/stderr"
    failed = 1
    exit 1
}

function short(name) {
    sub(/.*:/, "", name)
    return name
}

# Fills deepest[name] and, for the way there, next_of[name].
function visit(name,    i, callee) {
    if (active[name])
        fail("recursion through " short(name))
    if (name == "__indirect_call")
        fail("a call through a pointer")
    if (!(name in frame))
        fail("the frame of " short(name) " is not known")
    if (growing[name])
        fail("the frame of " short(name) " grows at run time")
    if (name in deepest)
        return
    active[name] = 1
    deepest[name] = 0
    for (i = 1; i <= calls[name]; i++) {
        callee = call[name, i]
        visit(callee)
        if (deepest[callee] > deepest[name]) {
            deepest[name] = deepest[callee]
            next_of[name] = callee
        }
    }
    deepest[name] += frame[name]
    active[name] = 0
}

BEGIN { FS = "\"" }

/^node:/ {
    if (match($4, /[0-9]+ bytes \([a-z,]+\)/)) {
        usage = substr($4, RSTART, RLENGTH)
        frame[$2] = usage + 0
        growing[$2] = usage ~ /\(dynamic\)/
    }
    if (short($2) == root)
        start = $2
}

/^edge:/ { call[$2, ++calls[$2]] = $4 }

END {
    if (failed)
        exit 1
    if (start == "")
        fail("there is no function " root)
    visit(start)
    for (name = start; name != ""; name = next_of[name])
        printf "%6d %s\n", frame[name], short(name)
    printf "stack_of_step %d\n", deepest[start]
}
