# The deepest stack of a function and of all that it calls, in bytes, from gcc's -fcallgraph-info=su: the path to it
# with the frame of each function. Status 1 if there is no bound: recursion, a call through a pointer, a frame that
# grows at run time, or a function whose frame is not in the file.
#
#     awk -v function_name=NAME -f stack.awk plant.ci
BEGIN { FS = "\"" }

# node: { title: "NAME" label: "... N bytes (static) ..." }, edge: { sourcename: "A" targetname: "B" ... }
/^node:/ {
    if (match($4, /[0-9]+ bytes \(/)) {
        frame[$2] = substr($4, RSTART) + 0
        grows[$2] = substr($4, RSTART + RLENGTH) ~ /^dynamic\)/
    }
    if (short_name($2) == function_name) start = $2
}
/^edge:/ { callee[$2, ++calls[$2]] = $4 }

# A name without the file that gcc writes before it.
function short_name(name)
{
    sub(/.*:/, "", name)
    return name
}

function fail(text)
{
    print "stack: " text > "/dev/stderr"
    exit 1
}

# Sets deepest[name], and below[name], the function in which it goes so deep.
function visit(name, i, called, most)
{
    if (name == "__indirect_call") fail("a call through a pointer")
    if (!(name in frame)) fail("the frame of " short_name(name) " is not known")
    if (active[name]) fail("recursion through " short_name(name))
    if (grows[name]) fail("the frame of " short_name(name) " grows at run time")
    if (name in deepest) return
    active[name] = 1
    for (i = 1; i <= calls[name]; i++) {
        called = callee[name, i]
        visit(called)
        if (deepest[called] > most) {
            most = deepest[called]
            below[name] = called
        }
    }
    deepest[name] = frame[name] + most
    active[name] = 0
}

END {
    if (start == "") fail("there is no function " function_name)
    visit(start)
    for (name = start; name != ""; name = below[name]) printf "%6d %s\n", frame[name], short_name(name)
    print "stack_of_step " deepest[start]
}
