# The columns of bounds in a plant that has their values as outputs choose_bound_1, choose_bound_2, ...; reads plant.c,
# then the output of bounds.awk. A line for each bound, NUMBER|VALUE|COLUMNS|UNIT|SCALE|OUTPUT|SI: the value in SI
# units, the unit that it was given in, how many of that an SI unit has; or a line that begins with `error`.
BEGIN { FS = "|" }

function strings(text) {
    gsub(/^ *"|",?$|,"?$/, "", text)
    return text
}

FNR == 1 { file++ }
file == 1 && /^    [.]/ { list = /[.]output_names =/ ? "names" : /[.]output_units =/ ? "units" : "" }
file == 1 && /^        "/ && list == "names" { name[columns++] = strings($0) }
file == 1 && /^        "/ && list == "units" { unit[had++] = strings($0) }
file == 1 && /y\[PLANT_Y_CHOOSE_BOUND_[0-9]+\] = R\(/ {
    number = given = $0
    sub(/.*CHOOSE_BOUND_/, "", number)
    sub(/.*R\(/, "", given)
    value[number + 0] = given + 0
}
file == 1 { next }

# The common form of two spellings of one unit.
function plain(text) {
    if (text == "J") return "N*m"
    if (text == "W" || text == "N*m/s") return "V*A"
    return text
}

# The columns of an output: its own, or those of a vector.
function columns_of(output, c, i, end, found) {
    for (c = 0; c < columns; c++) if (name[c] == output) return c
    split("_w _x _y _z", end, " ")
    for (i = 1; i <= 4; i++) for (c = 0; c < columns; c++) if (name[c] == output end[i]) found = found (found == "" ? "" : ",") c
    return found
}

# The outputs of the scene, vectors once.
function outputs(c, text, base, told) {
    for (c = 0; c < columns; c++) {
        if (name[c] ~ /^choose_bound_/) continue
        base = name[c]
        sub(/_[wxyz]$/, "", base)
        if (!(base "_x" in is && base "_y" in is)) base = name[c]
        if (!told[base]++) text = text " " base
    }
    return text
}

{
    for (c = 0; c < columns; c++) is[name[c]] = c
    of = columns_of($3)
    if (of == "") {
        print "error '" $2 " of " $3 "': there is no output " $3 "; the scene has:" outputs()
        exit
    }
    first = of
    sub(/,.*/, "", first)
    asked = unit[is["choose_bound_" $1]]
    if (plain(asked) != plain(unit[first]) && (asked != "rad" || unit[first] != "1")) {
        print "error '" $2 " of " $3 "': " (asked == "1" ? "a number without unit" : asked) " is no unit of " $3 ", which is in " unit[first]
        exit
    }
    shown = $2
    sub(/^[-+]?([0-9]+[.]?[0-9]*|[.][0-9]+)([eE][-+]?[0-9]+)? */, "", shown)
    printf "%d|%.9g|%s|%s|%.9g|%s|%s\n", $1, value[$1], of, shown, ($2 + 0) / value[$1], $3, unit[first]
}
