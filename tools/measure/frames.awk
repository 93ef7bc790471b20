# The frames of an AVR's functions and their calls, from `avr-objdump -d`, in the form that stack.awk reads: for a
# compiler that writes no call graph. A frame is the pushed bytes, the move of the stack pointer before it is set, and
# the return address, of 2 bytes. A called function is found by its address: symbols may share a value.
/^[0-9a-f]+ <[^.].*>:$/ {
    name = substr($2, 2, length($2) - 3)
    at = $1
    sub(/^0+/, "", at)
    is_set = 0
    function_at[at] = name
    bytes[name] = 2
}
/\tpush\t/ { bytes[name]++ }
/\trcall\t\.\+0 / { bytes[name] += 2; next }
/\t(sbiw|subi)\tr28, / && !is_set { bytes[name] += $NF }
/\tsbci\tr29, / && !is_set { bytes[name] += 256 * $NF }
/\tout\t0x3d, / { is_set = 1 }
/\ti(call|jmp)/ { called[name, "__indirect_call"] }
/\t(r?call|r?jmp)\t/ { called[name, "at " substr($(NF - 1), 3)] }

END {
    for (name in bytes) printf "node: { title: \"%s\" label: \"%d bytes (static)\" }\n", name, bytes[name]
    for (pair in called) {
        split(pair, of, SUBSEP)
        to = sub(/^at /, "", of[2]) ? function_at[of[2]] : of[2]
        if (to != "" && to != of[1]) printf "edge: { sourcename: \"%s\" targetname: \"%s\" }\n", of[1], to
    }
}
