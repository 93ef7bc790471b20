# Not a picture: a table of the outputs of a run whose names begin with report_, without that: their values at the start
# and at the end, and between which they stay.
#
#     account DIRECTORY
BEGIN {
    OFS = "\t"
    read_run(1, ARGV[1], 1)
    split(line[1, 1], start, ",")
    split(line[1, count[1]], end, ",")
    print "quantity", "unit", "first", "last", "least", "most"
    for (c = 1; c < columns[1]; c++)
        if (sub(/^report_/, "", name[1, c]))
            print name[1, c], unit[1, c], start[c + 1], end[c + 1], sprintf("%.9g", least[1, c]), sprintf("%.9g", most[1, c])
}
