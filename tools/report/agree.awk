# A line of the reference: the time, how far the two states of the input are apart (2-norm), and the first of them.
# Status 1 unless that is at most `tolerance` (1 + the norm of the state).
#
#     awk -v time=2 -v tolerance=1e-12 -f agree.awk references
#
# A line of the input is one of tools/report/drive.c: steps, time, state.
{
    for (i = 3; i <= NF; i++) {
        finite = finite && $i !~ /n/
        x[NR, i] = $i
    }
    fields[NR] = NF
}

BEGIN { finite = 1 }

END {
    for (i = 3; i <= fields[1]; i++) {
        square += x[1, i] ^ 2
        apart += (x[1, i] - x[2, i]) ^ 2
    }
    apart = finite ? sqrt(apart) : "inf"
    printf "%s %s", time, finite ? sprintf("%.3g", apart) : "inf"
    for (i = 3; i <= fields[1]; i++)
        printf " %s", x[1, i]
    printf "\n"
    exit !(NR == 2 && fields[1] > 2 && fields[1] == fields[2] && finite && apart <= tolerance * (1 + sqrt(square)))
}
