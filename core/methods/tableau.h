/* The coefficients of the methods.
 *
 * Butcher tables of the explicit one-step methods, in whole numbers: row i is a[i][j] / a_over[i], the weights are
 * b[j] / b_over. Whole numbers keep the order conditions exact (a test proves them in integers) and keep the weights
 * from adding up to something other than one in float.
 */
#ifndef ISO_CORE_METHODS_TABLEAU_H
#define ISO_CORE_METHODS_TABLEAU_H

#include "core/numbers/real.h"

enum { ISO_STAGES_MAX = 4 };

typedef struct iso_tableau {
    uint8_t stages;
    uint8_t order;
    int8_t a[ISO_STAGES_MAX][ISO_STAGES_MAX]; /* strictly lower triangular */
    int8_t a_over[ISO_STAGES_MAX];
    int8_t b[ISO_STAGES_MAX];
    int8_t b_over;
} iso_tableau;

/* Euler (1768), Institutionum calculi integralis, vol. 1, sec. 2, ch. 7. */
static const iso_tableau iso_tableau_euler = {
    .stages = 1,
    .order = 1,
    .a_over = {1},
    .b = {1},
    .b_over = 1,
};

/* Heun (1900), Z. Math. Phys. 45, 23-38: the trapezoidal rule with an Euler predictor. */
static const iso_tableau iso_tableau_heun = {
    .stages = 2,
    .order = 2,
    .a = {{0}, {1}},
    .a_over = {1, 1},
    .b = {1, 1},
    .b_over = 2,
};

/* Kutta (1901), Z. Math. Phys. 46, 435-453: the classical fourth-order method. */
static const iso_tableau iso_tableau_rk4 = {
    .stages = 4,
    .order = 4,
    .a = {{0}, {1}, {0, 1}, {0, 0, 1}},
    .a_over = {1, 2, 2, 1},
    .b = {1, 2, 2, 1},
    .b_over = 6,
};

/* Adams methods: x += h / over (b[0] f + b[1] f[-1] + ...), where an explicit one begins with the derivative at the
 * start of the step and an implicit one with that at its end. Bashforth and Adams (1883), An Attempt to Test the
 * Theories of Capillary Action, ch. 3; in this form Hairer, Norsett, Wanner (1993), Solving Ordinary Differential
 * Equations I, tables III.1.1 and III.1.2. */
enum { ISO_ADAMS_DERIVATIVES = 6, ISO_AB4_STEPS = 4 };

typedef struct iso_adams {
    int16_t b[ISO_ADAMS_DERIVATIVES];
    int16_t over;
} iso_adams;

static const iso_adams iso_table_ab4 = {.b = {55, -59, 37, -9}, .over = 24};

/* The implicit ones, by the number of derivatives from before the end of the step; their order is one more. */
static const iso_adams iso_table_am[ISO_ADAMS_DERIVATIVES] = {
    {.b = {1}, .over = 1},
    {.b = {1, 1}, .over = 2},
    {.b = {5, 8, -1}, .over = 12},
    {.b = {9, 19, -5, 1}, .over = 24},
    {.b = {251, 646, -264, 106, -19}, .over = 720},
    {.b = {475, 1427, -798, 482, -173, 27}, .over = 1440},
};

/* Milne (1926), Amer. Math. Monthly 33, 455-460: of the difference corrector - predictor of the pair of order four,
 * this part, negated, is the corrector's local error; from the error constants 251/720 and -19/720. */
static const iso_adams iso_table_milne = {.b = {19}, .over = 270};

/* The fourth-order backward differentiation formula (Curtiss and Hirschfelder 1952; Gear 1971, Numerical Initial Value
 * Problems in Ordinary Differential Equations, table 11.1), 1/25 (48 y - 36 y[-1] + 16 y[-2] - 3 y[-3] + 12 h f),
 * in the increments of the steps before, which are small where the states are not:
 *     dx = 1/over (b[0] d + b[1] d[-1] + b[2] d[-2] + derivative h f). */
enum { ISO_BDF4_STEPS = 4 };

typedef struct iso_bdf {
    int8_t b[ISO_BDF4_STEPS - 1];
    int8_t derivative;
    int8_t over;
    int8_t predictor[ISO_BDF4_STEPS]; /* the increment that continues a polynomial of degree four */
} iso_bdf;

static const iso_bdf iso_table_bdf4 = {.b = {23, -13, 3}, .derivative = 12, .over = 25, .predictor = {4, -6, 4, -1}};

/* A linearly implicit method: (1 - h gamma J) k_i = h gamma (f(x + sum_j a_ij k_j) + sum_j c_ij k_j / h), x += sum_i
 * m_i k_i. Hairer and Wanner (1996), Solving Ordinary Differential Equations II, eq. IV.7.25. */
enum { ISO_ROSENBROCK_STAGES = 3 };

typedef struct iso_rosenbrock {
    real gamma;
    real a21; /* also a31; a32 is zero, so that the second and third stage share an evaluation */
    real c21, c31, c32;
    real m[ISO_ROSENBROCK_STAGES];
} iso_rosenbrock;

/* ROS3, order three, L-stable: Sandu, Verwer, Blom, Spee, Carmichael, Potra (1997), Atmospheric Environment 31(20),
 * 3459-3472. */
static const iso_rosenbrock iso_table_ros3 = {
    .gamma = R(0.43586652150845899942),
    .a21 = R(1.0),
    .c21 = R(-1.0156171083877702092),
    .c31 = R(4.0759956452537699825),
    .c32 = R(9.2076794298330791242),
    .m = {R(1.0), R(6.1697947043828245593), R(-0.42772256543218573326)},
};

#endif
