# Prints the size of a program and of its main parts. With limits=yes the sizes of the double pendulum's firmware are
# held to their limits; status 1 if one is exceeded.
#
#     { size PROGRAM; nm -S PROGRAM; } | awk -v limits=yes|no -f program_size.awk -f size.awk
{ add_size($0) }

function show(name, bytes, limit)
{
    if (limits != "yes") limit = 0
    print name, bytes + 0 (limit ? " of at most " limit (bytes > limit ? ": TOO LARGE" : "") : "")
    if (limit && bytes > limit) exceeded = 1
}

END {
    need_sizes()
    show("text", text, 8192)
    show("step_text", step, 2048)
    show("plant_memory", memory)
    show("data_bss", data_bss(), 512)
    show("stack", stack)
    show("trace_buffer", buffer)
    exit exceeded
}
