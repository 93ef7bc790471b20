# The tables of core/link/README.md beside the lists of core/wire/protocol.h, which are read in this order.
# Prints how many frames and commands the header has and the fields of a start, and a line `# ...` for each that the
# text has otherwise; the status is 1 then.

# The words for a field of the header in the text.
function words(type, count)
{
    if (count == 1) return tolower(type)
    return type == "REAL" ? "reals" : type == "U64" ? "64 bits" : "bytes"
}

# The types that a cell names, such as `u8 version, u16 inputs`.
function types(text, found)
{
    for (found = ""; match(text, /u[0-9]+ |reals|64 bits/); text = substr(text, RSTART + RLENGTH))
        found = found (found == "" ? "" : " ") substr(text, RSTART, RLENGTH)
    gsub(/ +/, " ", found)
    sub(/ $/, "", found)
    return found
}

# What a command takes, by a cell: of each field with a type the type alone.
function taken(text, found, type)
{
    sub(/, 0 without an end/, "", text)
    for (found = ""; match(text, /u[0-9]* [^,]*/); text = substr(text, RSTART + RLENGTH)) {
        type = substr(text, RSTART, RLENGTH)
        sub(/ .*/, "", type)
        found = found substr(text, 1, RSTART - 1) type
    }
    found = found text
    sub(/, [0-9]* to [0-9]* bytes/, " bytes", found)
    sub(/, real/, " reals", found)
    return found
}

function compare(what, said, wanted)
{
    if (said == wanted) return
    print "# " what ": '" said "', in the header '" wanted "'"
    differ = 1
}

FNR == 1 { file++ }
file == 1 && /^#define / { list = substr($2, 1, index($2 "(", "(") - 1) }
file == 1 {
    for (line = $0; match(line, /X\([a-z_]*, [A-Z0-9]*, [A-Z0-9]*\)/); line = substr(line, RSTART + RLENGTH)) {
        split(substr(line, RSTART + 2, RLENGTH - 3), part, ", ")
        fields[list] = fields[list] (fields[list] == "" ? "" : " ") words(part[2], part[3])
    }
    if (match($0, /^    X\([A-Z]*, ('[a-zA-Z]'|[0-9]+)\)/)) {
        split(substr($0, 7, RLENGTH - 7), part, ", ")
        if (part[2] ~ /^[0-9]/) {
            command[++commands] = part[1]
            number[commands] = part[2]
        } else {
            frame[++frames] = part[1]
            letter[frames] = substr(part[2], 2, 1)
            sender[frames] = letter[frames] ~ /[hsuec]/ ? "controller" : "plant"
            if (part[1] == "END") {
                frame[++frames] = part[1]
                letter[frames] = letter[frames - 1]
                sender[frames] = "plant"
            }
        }
    }
}
file == 2 {
    split($0, cell, / *[|] */)
    for (i = 1; i <= frames; i++)
        if (index(cell[2], "`" letter[i] "`") == 1 && cell[3] == sender[i]) row[i] = types(cell[4])
    if (cell[3] ~ /^[0-9]+$/) takes[++rows] = cell[3] " " taken(cell[4])
    text = text $0 " "
}
END {
    for (i = 1; i <= frames; i++)
        compare(frame[i], row[i], frame[i] " " sender[i] == "END controller" ? "" : fields["ISO_LINK_" frame[i] "_FIELDS"])
    for (i = 1; i <= commands || i <= rows; i++) {
        list = "ISO_COMMAND_" command[i] "_TAKES"
        if (command[i] == "WRITE") list = "ISO_COMMAND_PIECE_FIELDS"
        if (command[i] == "SET") list = "ISO_COMMAND_VALUE_FIELDS"
        compare("command " command[i], takes[i], number[i] " " fields[list])
    }
    match(text, /any other one with [^.]*/)
    compare("state", types(substr(text, RSTART, RLENGTH)), fields["ISO_COMMAND_STATE_FIELDS"])
    print frames, commands, fields["ISO_LINK_START_FIELDS"]
    exit differ
}
