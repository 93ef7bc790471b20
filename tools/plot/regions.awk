# Regions of stability, and in them the step times the eigenvalues of the scene: the table regions.tsv of a report.
#
#     regions SCENE regions.tsv
BEGIN {
    FS = "\t"
    scene = ARGV[1]
    ARGV[1] = ""
    split("#8c8c8c #b8860b #0067a5 #d1590a", palette, " ")
}

FNR == 1 { next }

$1 == "eigenvalue" {
    points = points $2 " " $3 "\n"
    next
}

!($1 in curve) { order[++methods] = $1 }
{ curve[$1] = curve[$1] $2 " " $3 "\n" }

END {
    if (points == "") exit
    print "# size 900 520"
    put_style()
    for (i = 1; i <= methods; i++) put_block("edge_" order[i], curve[order[i]])
    put_block("eigenvalues", points)
    print "set xrange [-4.2:1.4]\nset yrange [-3.2:3.2]\nset size ratio -1"
    print "set xlabel 'real part of the eigenvalue times the step'\nset ylabel 'imaginary part'"
    print "set title '" scene ": what each method keeps stable, and the eigenvalues at its step' noenhanced"
    print "set key on outside right center noenhanced samplen 2"
    for (i = 1; i <= methods; i++)
        curves = curves (i == 1 ? "plot" : ",") " $edge_" order[i] " with lines linewidth 1.5 linecolor rgb '" palette[i] "' title '" order[i] "'"
    print curves ", $eigenvalues with points pointtype 7 pointsize 0.8 linecolor rgb '#c2185b' title 'eigenvalue'"
}
