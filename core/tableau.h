/* Butcher tables of the explicit one-step methods, in whole numbers: row i is a[i][j] / a_over[i], the weights are
 * b[j] / b_over. Whole numbers keep the order conditions exact (a test proves them in integers) and keep the weights
 * from adding up to something other than one in float.
 */
#ifndef ISO_CORE_TABLEAU_H
#define ISO_CORE_TABLEAU_H

#include <stdint.h>

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

/* Adams-Bashforth of step number k: x += h / over (b[0] f[0] + b[1] f[-1] + ...). */
enum { ISO_AB4_STEPS = 4 };

typedef struct iso_adams_bashforth {
    int8_t b[ISO_AB4_STEPS];
    int8_t over;
} iso_adams_bashforth;

/* Bashforth and Adams (1883), An Attempt to Test the Theories of Capillary Action, ch. 3; in this form Hairer,
 * Norsett, Wanner (1993), Solving Ordinary Differential Equations I, eq. III.1.5. */
static const iso_adams_bashforth iso_table_ab4 = {
    .b = {55, -59, 37, -9},
    .over = 24,
};

#endif
