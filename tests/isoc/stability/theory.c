#include "tests/isoc/stability/theory.h"

#include <float.h>
#include <math.h>

#include "core/methods/all.h"
#include "core/methods/table.h"

enum { DEGREE_MAX = 6, ITERATIONS = 200 };

/* Bashforth and Adams (1883), Moulton (1926): weights of the derivatives of now and before, over 24. */
static const double predictor[] = {55.0, -59.0, 37.0, -9.0}, corrector[] = {9.0, 19.0, -5.0, 1.0};

/* The largest modulus of the zeros of sum_k c[k] zeta^k, c[degree] not zero. */
static double largest_root(const double complex *const c, const int degree)
{
    /* All roots at once (Weierstrass 1891, Durand 1960, Kerner 1966). */
    double complex root[DEGREE_MAX] = {1.0};
    double largest = 0.0, change = 1.0;
    for (int i = 1; i < degree; i++) {
        root[i] = root[i - 1] * (0.4 + 0.9 * IMAGINARY);
    }
    for (int iteration = 0; iteration < ITERATIONS && change > 0.0; iteration++) {
        change = 0.0;
        for (int i = 0; i < degree; i++) {
            double complex value = c[degree];
            double complex others = c[degree];
            for (int k = degree; k-- > 0;) {
                value = value * root[i] + c[k];
            }
            for (int j = 0; j < degree; j++) {
                others *= j == i ? 1.0 : root[i] - root[j];
            }
            const double complex correction = value / others;
            root[i] -= correction;
            change = cabs(correction) > DBL_EPSILON * cabs(root[i]) ? 1.0 : change;
        }
    }
    for (int i = 0; i < degree; i++) {
        largest = fmax(largest, cabs(root[i]));
    }
    return largest;
}

/* Of an explicit method with as many stages as its order: the exponential series to that order. */
static double explicit_growth(const int order, const double complex z)
{
    double complex r = 1.0, term = 1.0;
    for (int k = 1; k <= order; k++) {
        term *= z / k;
        r += term;
    }
    return cabs(r);
}

/* The rational function of degree 2 over 3 with the pole 1 / gamma, gamma the middle root of 6 g^3 - 18 g^2 + 9 g - 1 =
 * 0, that is exact to order three. */
static double rosenbrock_growth(const double complex z)
{
    const double g = 0.43586652150845899942;
    const double complex below = 1.0 - g * z;
    return cabs((1.0 + (1.0 - 3.0 * g) * z + (0.5 - 3.0 * g + 3.0 * g * g) * z * z) / (below * below * below));
}

/* zeta^3 (zeta - 1) - z (55 zeta^3 - ...) / 24. */
static double ab4_growth(const double complex z)
{
    double complex c[5] = {0.0, 0.0, 0.0, -1.0, 1.0};
    for (int j = 0; j < 4; j++) {
        c[3 - j] -= z * predictor[j] / 24.0;
    }
    return largest_root(c, 4);
}

/* All derivatives are z x: x+ = x + z (b0 p + b1 x + b2 x[-1] + b3 x[-2]), where p is the predictor's x+, or once more
 * the corrector's. Coefficients of zeta^3, zeta^2, ... of the right side. */
static double pece_growth(const double complex z, const int corrections)
{
    double complex x[4] = {1.0, 0.0, 0.0, 0.0};
    double complex c[5];
    for (int j = 0; j < 4; j++) {
        x[j] += z * predictor[j] / 24.0;
    }
    for (int i = 0; i < corrections; i++) {
        for (int j = 0; j < 4; j++) {
            x[j] = (j == 0 ? 1.0 : 0.0) + z * (corrector[0] * x[j] + (j < 3 ? corrector[j + 1] : 0.0)) / 24.0;
        }
    }
    for (int j = 0; j < 4; j++) {
        c[3 - j] = -x[j];
    }
    c[4] = 1.0;
    return largest_root(c, 4);
}

/* Derivatives are z p, of the predictor: p+ = x + z s(p), x+ = x + z t(p+), s and t the two formulas. With p = zeta^n:
 * (zeta - 1) (p+ - z s) = z t. */
static double pec_growth(const double complex z)
{
    double complex s[5] = {0.0, 0.0, 0.0, 0.0, 1.0};
    double complex c[6] = {0.0};
    for (int j = 0; j < 4; j++) {
        s[3 - j] -= z * predictor[j] / 24.0;
    }
    for (int k = 0; k < 5; k++) {
        c[k + 1] += s[k];
        c[k] -= s[k];
    }
    for (int j = 0; j < 4; j++) {
        c[4 - j] -= z * corrector[j] / 24.0;
    }
    return largest_root(c, 5);
}

/* (25 - 12 z) zeta^4 - 48 zeta^3 + 36 zeta^2 - 16 zeta + 3 (Gear 1971, table 11.1). */
static double bdf4_growth(const double complex z)
{
    const double complex c[5] = {3.0, -16.0, 36.0, -48.0, 25.0 - 12.0 * z};
    return largest_root(c, 4);
}

/* zeta^2 - (2 + 2 re z - |z|^2) zeta + 1 + 2 re z. */
static double semi_implicit_growth(const double complex z)
{
    const double re = creal(z), square = creal(z * conj(z));
    const double complex c[3] = {1.0 + 2.0 * re, square - 2.0 * re - 2.0, 1.0};
    return cimag(z) == 0.0 ? fabs(1.0 + re) : largest_root(c, 2);
}

double theory_growth(const unsigned method, const double complex z)
{
    switch (method) {
    case ISO_EULER:
        return explicit_growth(1, z);
    case ISO_HEUN:
        return explicit_growth(2, z);
    case ISO_RK4:
        return explicit_growth(4, z);
    case ISO_AB4:
        return ab4_growth(z);
    case ISO_SEMI_IMPLICIT:
        return semi_implicit_growth(z);
    case ISO_ABM4:
    case ISO_ADAMS:
        return pece_growth(z, 1);
    case ISO_ABM4_PEC:
        return pec_growth(z);
    case ISO_ABM4_PECECE:
        return pece_growth(z, 2);
    case ISO_BDF4:
        return bdf4_growth(z);
    case ISO_ROSENBROCK:
        return rosenbrock_growth(z);
    default:
        return (double)NAN;
    }
}
