# How far two motions are apart: reads columns (columns.awk), then rows of both, side by side, of so many `columns`
# each.
FNR == 1 { file++ }
file == 1 {
    split($0, cell, "|")
    n = split(cell[3], part, ",")
    for (i = 1; i <= n; i++) of[++all] = FNR
    scale[FNR] = cell[5]
    unit[FNR] = cell[4]
    output[FNR] = cell[6]
    angle[FNR] = cell[7] == "rad"
    bounds = FNR
    FS = " "
    next
}
{
    for (b = 1; b <= bounds; b++) sum[b] = 0
    for (i = 1; i <= columns; i++) {
        d = $i - $(i + columns)
        turn = 6.283185307179586
        if (angle[of[i]] && d * d > 36) d -= turn * int(d / turn + (d > 0 ? 0.5 : -0.5))
        sum[of[i]] += d * d
    }
    for (b = 1; b <= bounds; b++) if (sum[b] > most[b]) most[b] = sum[b]
}
END {
    for (b = 1; b <= bounds; b++) printf "%s%s by %.2g %s", (b > 1 ? ", " : ""), output[b], sqrt(most[b]) * scale[b], unit[b]
    print ""
}
