/* The observed order of every method on a plant: halving h divides the error at 1 s by 2^order. In double.
 *
 * The error is e(h) = C h^p (1 + D h + ...) + rounding, so log2(e(h) / e(h / 2)) = p + D h / (2 ln 2) + ...: the
 * coarsest step must make the second term small, and the finest must keep e(h) far above rounding, about 2^-53
 * sqrt(1 / h) times the growth of an error in this second, 5: at most 1.5e-13. The first differences measured, |D| is
 * 28 / s (euler) and below 5 / s (the others) on the double pendulum, 8 / s and below 5 / s on the oscillator. With the
 * ranges below the second term is under 0.03 and e(h) over 3e-11. Steps are powers of two, which meet 1 s exactly.
 */
#include <math.h>
#include <string.h>

#include "core/multistep.h"
#include "tests/host/report.h"
#include "tests/order/order.h"

enum { HALVINGS = 4 };

/* The accepted distance of an observed order from the method's. */
#define ORDER_TOLERANCE 0.1

/* No table: Adams-Bashforth. */
typedef struct method {
    const char *name;
    const iso_tableau *table;
    bool primed; /* the history of a multistep method; else it starts with zeros */
    int order;
    int coarsest; /* h = 2^-coarsest s */
} method;

static const iso_tableau wrong_euler = {.stages = 1, .a_over = {1}, .b = {2}, .b_over = 3};
static const iso_tableau wrong_heun = {.stages = 2, .a = {{0}, {1}}, .a_over = {1, 1}, .b = {1, 2}, .b_over = 3};
static const iso_tableau wrong_rk4 = {
    .stages = 4,
    .a = {{0}, {1}, {0, 1}, {0, 0, 1}},
    .a_over = {1, 2, 2, 1},
    .b = {1, 3, 1, 1},
    .b_over = 6,
};

static const method methods[] = {
    {"euler", &iso_tableau_euler, false, 1, 12},
    {"heun", &iso_tableau_heun, false, 2, 8},
    {"rk4", &iso_tableau_rk4, false, 4, 7},
    {"ab4", NULL, true, 4, 8},
};

/* Positive controls: one wrong weight, or a history that is not there. */
static const method controls[] = {
    {"euler with a wrong weight", &wrong_euler, false, 1, 12},
    {"heun with a wrong weight", &wrong_heun, false, 2, 8},
    {"rk4 with a wrong weight", &wrong_rk4, false, 4, 7},
    {"ab4 without its history", NULL, false, 4, 8},
};

/* The error at 1 s with steps of 2^-k s: 2-norm over the states. */
static double error_of(const method *const m, const int k)
{
    const size_t n = (size_t)the_problem.states;
    const double h = ldexp(1.0, -k);
    iso_derivative *const f = iso_the_plant.derivative;
    const double *const p = iso_the_plant.defaults;
    double x[ORDER_STATES_MAX];
    double at[ORDER_STATES_MAX];
    double work[ISO_EXPLICIT_WORK(ORDER_STATES_MAX)];
    double history[ISO_AB4_HISTORY(ORDER_STATES_MAX)] = {0.0};
    memcpy(x, the_problem.start, sizeof x);
    if (m->primed) {
        iso_ab4_prime(n, f, h, x, the_problem.input, p, history, at, work);
    }
    for (long step = 0; step < 1L << k; step++) {
        if (m->table != NULL) {
            iso_explicit_step(m->table, n, f, h, x, the_problem.input, p, work);
        } else {
            iso_ab4_step(n, f, h, x, the_problem.input, p, history, work);
        }
    }
    long double y[ORDER_STATES_MAX] = {0.0L};
    long double square = 0.0L;
    the_problem.exact(y, p);
    for (size_t i = 0; i < n; i++) {
        square += ((long double)x[i] - y[i]) * ((long double)x[i] - y[i]);
    }
    return (double)sqrtl(square);
}

/* Prints the observed orders; true if all are the method's. */
static bool has_order(const method *const m)
{
    bool all = true;
    double coarse = error_of(m, m->coarsest);
    for (int i = 1; i <= HALVINGS; i++) {
        const int k = m->coarsest + i;
        const double fine = error_of(m, k);
        const double order = log2(coarse / fine);
        report_note("%s, h = 2^-%d to 2^-%d s: error %.3e to %.3e, order %.4f", m->name, k - 1, k, coarse, fine, order);
        all = all && fabs(order - m->order) <= ORDER_TOLERANCE;
        coarse = fine;
    }
    return all;
}

int main(void)
{
    if (!report_ok(iso_the_plant.states == the_problem.states && iso_the_plant.inputs <= ORDER_INPUTS_MAX,
                   "the plant has the problem's states")) {
        return report_done();
    }
    for (size_t i = 0; i < sizeof methods / sizeof *methods; i++) {
        const bool passed = has_order(&methods[i]);
        report_ok(passed, "%s has order %d within %.1f over %d halvings", methods[i].name, methods[i].order,
                  ORDER_TOLERANCE, HALVINGS);
    }
    for (size_t i = 0; i < sizeof controls / sizeof *controls; i++) {
        const bool passed = has_order(&controls[i]);
        report_ok(!passed, "control: %s has not order %d", controls[i].name, controls[i].order);
    }
    return report_done();
}
