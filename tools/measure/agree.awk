# A line of the reference from two of drive.c: `time`, how far the two states are apart (2-norm), and the first of them. Status 1
# unless that is at most `tolerance` (1 + the norm of the state).
#
#     awk -v time=TIME -v tolerance=TOLERANCE -f agree.awk
NR == 1 {
    cells = NF
    for (i = 3; i <= NF; i++) {
        first[i] = $i
        state = state " " $i
        square += $i * $i
        if ($i ~ /inf|nan/) infinite = 1
    }
}
NR == 2 {
    for (i = 3; i <= cells; i++) {
        apart += (first[i] - $i) ^ 2
        if ($i ~ /inf|nan/) infinite = 1
    }
    same = NF == cells
}
END {
    apart = infinite || !(apart < 1e300) ? "inf" : sprintf("%.17g", sqrt(apart))
    printf "%s %s%s\n", time, apart == "inf" ? apart : sprintf("%.3g", apart), state
    exit !(NR == 2 && cells > 2 && same && apart != "inf" && apart + 0 <= tolerance * (1 + sqrt(square)))
}
