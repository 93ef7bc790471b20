# The size of a program and of what matters in it, from the output of `size` followed by that of `nm -S`.
#
#     { size PROGRAM; nm -S PROGRAM; } | awk -v limits=yes -f size.awk
#
# The stack and the trace buffer are counted apart: the first is the platform's, the second the run's. With
# limits=yes the sizes of the double pendulum's firmware are held to their limits; status 1 if one is exceeded.
function value_of(hexadecimal,    i, value) {
    value = 0
    for (i = 1; i <= length(hexadecimal); i++)
        value = 16 * value + index("0123456789abcdef", substr(tolower(hexadecimal), i, 1)) - 1
    return value
}

function show(name, bytes, limit) {
    printf "%s %d", name, bytes
    if (limits == "yes" && limit > 0) {
        printf " of at most %d", limit
        if (bytes > limit) {
            printf ": TOO LARGE"
            failed = 1
        }
    }
    printf "\n"
}

NR == 2 { text = $1; data = $2; bss = $3 }
$NF == "STACK_BYTES" { stack = value_of($1) }
NF == 4 && $4 ~ /^trace_buffer$/ { buffer = value_of($2) }
NF == 4 && $3 ~ /^[bB]$/ && $4 == "memory" { memory = value_of($2) }
NF == 4 && $3 ~ /^[tT]$/ && $4 ~ /^(step|derivative)(\.|$)/ { step += value_of($2) }

END {
    if (text == 0 || step == 0 || buffer == 0) {
        print "size.awk: this is not the output of size and nm for a plant's program" > "/dev/stderr"
        exit 1
    }
    show("text", text, 8192)
    show("step_text", step, 3072)
    show("plant_memory", memory, 0)
    show("data_bss", data + bss - stack - buffer, 512)
    show("stack", stack, 0)
    show("trace_buffer", buffer, 0)
    exit failed
}
