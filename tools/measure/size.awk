# The size of a program and of its main parts, from the output of `size` followed by that of `nm -S`. The stack and the
# trace buffer are counted apart: the first is the platform's, the second the run's. With limits=yes the sizes of the
# double pendulum's firmware are held to their limits; status 1 if one is exceeded.
#
#     { size PROGRAM; nm -S PROGRAM; } | awk -v limits=yes|no -f size.awk
function hexadecimal(digits, i, n)
{
    for (i = 1; i <= length(digits); i++) n = 16 * n + index("123456789abcdef", substr(digits, i, 1))
    return n + 0
}

NR == 2 { text = $1; data = $2; bss = $3 }
NR > 2 && $NF == "STACK_BYTES" { stack = hexadecimal($1) }
# A line of nm: address, size, type, symbol. The compiler makes copies NAME.SUFFIX of a function, and isoc parts NAME_1.
NR > 2 && NF == 4 {
    bytes = hexadecimal($2)
    if ($4 == "trace_buffer") buffer = bytes
    if ($4 == "memory" && $3 ~ /^[bB]$/) memory = bytes
    if ($3 ~ /^[tT]$/ && $4 ~ /^(step|derivative|held_derivative|prepare|complete|prepared_derivative|hold)($|[.]|_[0-9])/) step += bytes
}

function show(name, bytes, limit)
{
    if (limits != "yes") limit = 0
    print name, bytes + 0 (limit ? " of at most " limit (bytes > limit ? ": TOO LARGE" : "") : "")
    if (limit && bytes > limit) exceeded = 1
}

END {
    if (!(text > 0 && step > 0 && buffer > 0)) {
        print "size: this is not the output of size and nm for a plant's program" > "/dev/stderr"
        exit 1
    }
    show("text", text, 8192)
    show("step_text", step, 2048)
    show("plant_memory", memory)
    show("data_bss", data + bss - stack - buffer, 512)
    show("stack", stack)
    show("trace_buffer", buffer)
    exit exceeded
}
