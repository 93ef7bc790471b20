# The edges of the regions of stability, as points of the plane of step times eigenvalue: of one-step methods where the size of
# their stability polynomial P is 1, P(z) = exp(i a) followed over a by Newton's method; of ab4 the locus rho / sigma of its
# polynomials (Hairer and Wanner 1996, Solving Ordinary Differential Equations II, sections IV.2 and V.1).
#
#     awk -f regions.awk
BEGIN {
    OFS = "\t"
    PI = 3.14159265358979
    print "what", "re", "im"
    polynomial("euler", 1)
    polynomial("heun", 2)
    polynomial("rk4", 4)
    for (n = -90; n <= 90; n++) locus(n * PI / 90)
}

# P(z) and its derivative, z = x + i y: 1 + z + ... + z^order / order!.
function evaluate(x, y, order, k, a, b, c)
{
    a = 1; b = 0
    pr = 1; pi = 0; dr = 0; di = 0
    for (k = 1; k <= order; k++) {
        dr += a; di += b
        c = (a * x - b * y) / k
        b = (a * y + b * x) / k
        a = c
        pr += a; pi += b
    }
}

function polynomial(method, order, n, i, x, y, er, ei, size)
{
    x = y = 0
    for (n = 0; n <= 180 * order; n++) {
        for (i = 0; i < 8; i++) {
            evaluate(x, y, order)
            er = pr - cos(n * PI / 90); ei = pi - sin(n * PI / 90)
            size = dr * dr + di * di
            x -= (er * dr + ei * di) / size
            y -= (ei * dr - er * di) / size
        }
        if (n % 3 == 0) printf "%s\t%.6g\t%.6g\n", method, x, y
    }
}

# r = exp(i a): (r^4 - r^3) / ((55 r^3 - 59 r^2 + 37 r - 9) / 24).
function locus(a, nr, ni, sr, si, size)
{
    nr = cos(4 * a) - cos(3 * a); ni = sin(4 * a) - sin(3 * a)
    sr = (55 * cos(3 * a) - 59 * cos(2 * a) + 37 * cos(a) - 9) / 24
    si = (55 * sin(3 * a) - 59 * sin(2 * a) + 37 * sin(a)) / 24
    size = sr * sr + si * si
    printf "ab4\t%.6g\t%.6g\n", (nr * sr + ni * si) / size, (ni * sr - nr * si) / size
}
