#include "tools/isoc/mechanism/growth.h"

#include <float.h>
#include <math.h>

#include "core/methods/recipe.h"

enum { DEGREE_MAX = 6, ITERATIONS = 200 };

static double modulus(const double complex z)
{
    return sqrt(creal(z) * creal(z) + cimag(z) * cimag(z));
}

/* The largest modulus of the zeros of sum_k c[k] zeta^k, c[degree] not zero. */
static double largest_root(const double complex *const c, const int degree)
{
    /* All roots at once (Weierstrass 1891, Durand 1960, Kerner 1966). */
    double complex root[DEGREE_MAX] = {1.0};
    double largest = 0.0, change = 1.0;
    for (int i = 1; i < degree; i++) {
        root[i] = root[i - 1] * (0.4 + 0.9 * GROWTH_I);
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
            change = modulus(correction) > DBL_EPSILON * modulus(root[i]) ? 1.0 : change;
        }
    }
    for (int i = 0; i < degree; i++) {
        largest = modulus(root[i]) > largest ? modulus(root[i]) : largest;
    }
    return largest;
}

/* R(z) = 1 + z sum_i b_i k_i, k_i = 1 + z sum_j a_ij k_j. */
static double complex explicit_factor(const iso_tableau *const t, const double complex z)
{
    double complex k[ISO_STAGES_MAX];
    double complex r = 1.0;
    for (int i = 0; i < t->stages; i++) {
        k[i] = 1.0;
        for (int j = 0; j < i; j++) {
            k[i] += z * t->a[i][j] / t->a_over[i] * k[j];
        }
        r += z * t->b[i] / t->b_over * k[i];
    }
    return r;
}

/* The rational function of degree 2 over 3 with the pole 1 / gamma that is exact to order three. */
static double complex rosenbrock_factor(const double complex z)
{
    const double g = (double)iso_table_ros3.gamma;
    const double complex below = 1.0 - g * z;
    return (1.0 + (1.0 - 3.0 * g) * z + (0.5 - 3.0 * g + 3.0 * g * g) * z * z) / (below * below * below);
}

/* zeta^3 (zeta - 1) - z (55 zeta^3 - ...) / 24. */
static double ab4_growth(const double complex z)
{
    double complex c[5] = {0.0, 0.0, 0.0, -1.0, 1.0};
    for (int j = 0; j < ISO_AB4_STEPS; j++) {
        c[3 - j] -= z * iso_table_ab4.b[j] / iso_table_ab4.over;
    }
    return largest_root(c, 4);
}

/* All derivatives are z x: x+ = x + z (b0 p + b1 x + b2 x[-1] + b3 x[-2]), where p is the predictor's x+, or once more
 * the corrector's. Coefficients of zeta^3, zeta^2, ... of the right side. */
static double pece_growth(const double complex z, const int corrections)
{
    const iso_adams *const am = &iso_table_am[3];
    double complex x[4] = {1.0, 0.0, 0.0, 0.0};
    double complex c[5];
    for (int j = 0; j < 4; j++) {
        x[j] += z * iso_table_ab4.b[j] / iso_table_ab4.over;
    }
    for (int i = 0; i < corrections; i++) {
        for (int j = 0; j < 4; j++) {
            x[j] = (j == 0 ? 1.0 : 0.0) + z * (am->b[0] * x[j] + (j < 3 ? am->b[j + 1] : 0)) / am->over;
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
        s[3 - j] -= z * iso_table_ab4.b[j] / iso_table_ab4.over;
    }
    for (int k = 0; k < 5; k++) {
        c[k + 1] += s[k];
        c[k] -= s[k];
    }
    for (int j = 0; j < 4; j++) {
        c[4 - j] -= z * iso_table_am[3].b[j] / iso_table_am[3].over;
    }
    return largest_root(c, 5);
}

/* (25 - 12 z) zeta^4 - 48 zeta^3 + 36 zeta^2 - 16 zeta + 3 (Gear 1971, table 11.1). */
static double bdf4_growth(const double complex z)
{
    const double complex c[5] = {3.0, -16.0, 36.0, -48.0, 25.0 - 12.0 * z};
    return largest_root(c, 4);
}

/* q'' = -w^2 q: zeta^2 - (2 - w^2) zeta + 1. q' = v, v' = lambda v: 1 and 1 + z. */
static double semi_implicit_growth(const double complex z)
{
    const double complex c[3] = {1.0, cimag(z) * cimag(z) - 2.0, 1.0};
    return creal(z) == 0.0 ? largest_root(c, 2) : (modulus(1.0 + z) > 1.0 ? modulus(1.0 + z) : 1.0);
}

double growth_of(const unsigned recipe, const double complex z)
{
    switch (ISO_METHOD_OF(recipe)) {
    case ISO_EULER:
        return modulus(explicit_factor(&iso_tableau_euler, z));
    case ISO_HEUN:
        return modulus(explicit_factor(&iso_tableau_heun, z));
    case ISO_RK4:
        return modulus(explicit_factor(&iso_tableau_rk4, z));
    case ISO_AB4:
        return ab4_growth(z);
    case ISO_SEMI_IMPLICIT:
        return semi_implicit_growth(z);
    case ISO_ABM4:
        return pece_growth(z, 1);
    case ISO_ABM4_PEC:
        return pec_growth(z);
    case ISO_ABM4_PECECE:
        return pece_growth(z, 2);
    case ISO_BDF4:
        return bdf4_growth(z);
    default:
        return modulus(rosenbrock_factor(z));
    }
}
