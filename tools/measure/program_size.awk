# The size of a program and of its main parts, from the output of `size` followed by that of `nm -S`, line by line:
# text, data and bss; and stack, buffer, memory and step, the bytes of these in the program of a plant. The stack and
# the trace buffer are counted apart: the first is the platform's, the second the run's.
function hexadecimal(digits, i, n)
{
    for (i = 1; i <= length(digits); i++) n = 16 * n + index("123456789abcdef", substr(digits, i, 1))
    return n + 0
}

function add_size(line, word, words, bytes)
{
    words = split(line, word, " ")
    if (++size_lines == 2) { text = word[1]; data = word[2]; bss = word[3] }
    if (size_lines <= 2) return
    if (word[words] == "STACK_BYTES") stack = hexadecimal(word[1])
    # A line of nm: address, size, type, symbol. The compiler makes copies NAME.SUFFIX of a function, and isoc parts
    # NAME_1.
    if (words != 4) return
    bytes = hexadecimal(word[2])
    if (word[4] == "trace_buffer") buffer = bytes
    if (word[4] == "memory" && word[3] ~ /^[bB]$/) memory = bytes
    if (word[3] ~ /^[tT]$/ && word[4] ~ /^(step|derivative|held_derivative|prepare|complete|prepared_derivative|hold)($|[.]|_[0-9])/)
        step += bytes
}

# What the plant takes of the RAM.
function data_bss() { return data + bss - stack - buffer }

# Ends with an error unless the lines were of a plant's program.
function need_sizes()
{
    if (text > 0 && step > 0 && buffer > 0) return
    print "size: this is not the output of size and nm for a plant's program" > "/dev/stderr"
    exit 1
}
