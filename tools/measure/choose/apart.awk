# How far two motions are apart: reads columns (columns.awk), then rows of both, side by side.
#
#     awk -f bound.awk -f apart.awk COLUMNS ROWS
{
    for (b = 1; b <= bounds; b++) sum[b] = 0
    for (i = 1; i <= columns; i++) sum[bound_of[i]] += turned($i - $(i + columns), bound_of[i]) ^ 2
    for (b = 1; b <= bounds; b++) if (sum[b] > most[b]) most[b] = sum[b]
}
END {
    for (b = 1; b <= bounds; b++) printf "%s%s by %.2g %s", (b > 1 ? ", " : ""), output[b], sqrt(most[b]) * scale[b], unit[b]
    print ""
}
