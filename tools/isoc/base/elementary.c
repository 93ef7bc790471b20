#include "tools/isoc/base/numbers.h"

#include <math.h>

/* high + low, where high is their sum rounded: a number of about 106 bits. */
typedef struct wide {
    double high, low;
} wide;

static const wide ln_2 = {0x1.62e42fefa39efp-1, 0x1.abc9e3b39803fp-56};
static const wide pi_wide = {0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53};

/* --- sums and products of pairs --- */

/* a + b exactly (Knuth 1969, The Art of Computer Programming 2, sec. 4.2.2, theorem B). */
static wide sum_of(double a, double b)
{
    const double sum = a + b, part = sum - a;
    return (wide){sum, (a - (sum - part)) + (b - part)};
}

/* The upper 26 bits (Dekker 1971, A floating-point technique for extending the available precision, sec. 4). */
static double upper(double a)
{
    const double scaled = 134217729.0 * a;
    return scaled - (scaled - a);
}

/* a b exactly (Dekker 1971, likewise), for products that neither overflow nor underflow. */
static wide product_of(double a, double b)
{
    const double product = a * b, a1 = upper(a), b1 = upper(b), a2 = a - a1, b2 = b - b1;
    return (wide){product, ((a1 * b1 - product) + a1 * b2 + a2 * b1) + a2 * b2};
}

static wide whole(double a)
{
    return (wide){a, 0.0};
}

static wide add(wide a, wide b)
{
    const wide high = sum_of(a.high, b.high), low = sum_of(a.low, b.low);
    const wide middle = sum_of(high.high, high.low + low.high);
    return sum_of(middle.high, middle.low + low.low);
}

static wide minus(wide a)
{
    return (wide){-a.high, -a.low};
}

static wide times(wide a, wide b)
{
    const wide high = product_of(a.high, b.high);
    return sum_of(high.high, high.low + (a.high * b.low + a.low * b.high));
}

static wide over(wide a, wide b)
{
    const double first = a.high / b.high;
    const wide rest = add(a, minus(times(whole(first), b)));
    const double second = rest.high / b.high;
    const wide left = add(rest, minus(times(whole(second), b)));
    return add(sum_of(first, second), whole(left.high / b.high));
}

static wide root(wide a)
{
    const double first = sqrt(a.high);
    return first == 0.0 ? a
                        : add(whole(first), over(add(a, minus(times(whole(first), whole(first)))), whole(2 * first)));
}

/* --- functions --- */

/* x = k ln 2 + r: e^x = 2^k (e^(r / 256))^256, by 11 terms of the series of an argument below 0.0014. */
static double exponential(wide x)
{
    enum { SQUARES = 8, TERMS = 11 };
    const double k = floor(x.high / ln_2.high + 0.5);
    wide r = add(x, minus(times(whole(k), ln_2)));
    r = (wide){ldexp(r.high, -SQUARES), ldexp(r.low, -SQUARES)};
    wide sum = whole(1.0);
    for (int n = TERMS; n >= 1; n--) {
        sum = add(whole(1.0), over(times(r, sum), whole(n)));
    }
    for (int n = 0; n < SQUARES; n++) {
        sum = times(sum, sum);
    }
    return ldexp(sum.high, (int)k);
}

/* x = 2^k m with m within sqrt(2) of 1: ln x = k ln 2 + 2 artanh s of s = (m - 1) / (m + 1), |s| < 0.172. */
static wide logarithm(double x)
{
    enum { TERMS = 21 };
    int k;
    double m = frexp(x, &k);
    if (m < 0x1.6a09e667f3bcdp-1) {
        m *= 2;
        k--;
    }
    const wide s = over(sum_of(m, -1.0), sum_of(m, 1.0)), square = times(s, s);
    wide sum = whole(0.0);
    for (int n = TERMS; n >= 0; n--) {
        sum = add(times(sum, square), over(whole(2.0), whole(2 * n + 1)));
    }
    return add(times(whole(k), ln_2), times(s, sum));
}

double elementary_exp(double x)
{
    return exponential(whole(x));
}

double elementary_log(double x)
{
    return logarithm(x).high;
}

double elementary_power(double x, double y)
{
    return exponential(times(whole(y), logarithm(x)));
}

/* Of 0 <= t <= 1 (Euler 1755): t / (1 + t^2) times the sum over n of the product of 2 k u / (2 k + 1) up to k = n, with
 * u = t^2 / (1 + t^2) <= 1/2. */
static wide arc(wide t)
{
    enum { TERMS = 110 };
    const wide square = times(t, t), below = add(whole(1.0), square), u = over(square, below);
    wide sum = whole(1.0);
    for (int k = TERMS; k >= 1; k--) {
        sum = add(whole(1.0), times(times(u, over(whole(2 * k), whole(2 * k + 1))), sum));
    }
    return times(over(t, below), sum);
}

/* The angle of a point, from that of its mirror image below the diagonal of the first quarter. */
static double angle(wide y, wide x)
{
    const wide up = y.high < 0.0 ? minus(y) : y, right = x.high < 0.0 ? minus(x) : x;
    const wide quarter = {pi_wide.high / 2, pi_wide.low / 2};
    wide result = up.high > right.high ? add(quarter, minus(arc(over(right, up)))) : arc(over(up, right));
    result = x.high < 0.0 ? add(pi_wide, minus(result)) : result;
    return y.high < 0.0 ? -result.high : result.high;
}

/* Both scaled by one power of two, so that no product leaves the range of a double. */
double elementary_atan2(double y, double x)
{
    int scale;
    frexp(fmax(fabs(y), fabs(x)), &scale);
    return angle(whole(ldexp(y, -scale)), whole(ldexp(x, -scale)));
}

/* The other side of a right triangle with a hypotenuse of 1. */
static wide other_side(double x)
{
    return root(times(sum_of(1.0, -x), sum_of(1.0, x)));
}

double elementary_asin(double x)
{
    return angle(whole(x), other_side(x));
}

double elementary_acos(double x)
{
    return angle(other_side(x), whole(x));
}
