# Regions of stability of all methods, and in them the step times the eigenvalues of the scene: the table regions.tsv of
# a report. The curve of the scene's own method is the widest.
#
#     regions SCENE METHOD regions.tsv
BEGIN {
    scene = word(1)
    own = word(2)
}

FNR == 1 { next }

$1 == "eigenvalue" {
    points = points $2 " " $3 "\n"
    next
}

!($1 in curve) { order[++methods] = $1 }
$1 in curve && $4 != piece[$1] { curve[$1] = curve[$1] "\n" }
{
    curve[$1] = curve[$1] $2 " " $3 "\n"
    piece[$1] = $4
}

END {
    if (points == "") exit
    print "# size 760 560"
    put_style()
    print "set xrange [-4.2:2]\nset yrange [-3.6:3.6]\nset size ratio -1"
    print "set xlabel 'real part of the eigenvalue times the step'\nset ylabel 'imaginary part'"
    put_title(scene ": what each method keeps stable, and the eigenvalues at its step")
    print "set key samplen 3"
    for (i = 1; i <= methods; i++)
        add_curve(curve[order[i]], "with lines linewidth " (order[i] == own ? 3 : 1.4) " dashtype " dashes_of(order[i]) \
            " linecolor rgb '" colour_of(order[i], i) "'", order[i])
    add_curve(points, "with points pointtype 7 pointsize 0.8 linecolor rgb '#000000'", "eigenvalue")
    put_curves()
}
