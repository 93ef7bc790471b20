/* The observed order of every method on a plant: halving h divides the error at 1 s by 2^order. In double.
 *
 * The error is e(h) = C h^p (1 + D h + ...) + rounding, so log2(e(h) / e(h / 2)) = p + D h / (2 ln 2) + ...: the
 * coarsest step must make the second term small, and the finest must keep e(h) far above rounding, about 2^-53
 * sqrt(1 / h) times the growth of an error in this second, 5: at most 1.5e-13; compensated, some 2^-53 times 5. With
 * the ranges below e(h) is over 5e-12, and D h / (2 ln 2) below 0.09. Only the PEC form of abm4 has so large a D, 60 /
 * s, that it must begin at 2^-10 s; its last errors, 2e-14, are seen compensated only. Steps are powers of two, which
 * meet 1 s exactly.
 *
 * With the argument `sines` the plant has no Jacobian, but the derivative by sines that methods of several stages call:
 * these are tried alone. With the argument `errors` the errors are printed, compensated unless there is a second
 * argument, in whichever real the program has: tests/core/methods/order/test_order.py holds those in float against
 * those in double.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "core/methods/all.h"
#include "core/methods/primed.h"
#include "tests/core/methods/order/order.h"
#include "tests/host/report.h"
#include "tests/one_step.h"

enum {
    HALVINGS = 4,
    FACTORS_MAX = 3 * ORDER_STATES_MAX * ORDER_STATES_MAX,
    PARAMETERS_MAX = 4,
    VECTORS_MAX = 10,
};

/* The accepted distance of an observed order from the method's. */
#define ORDER_TOLERANCE 0.1

static const char *const names[] = ISO_METHOD_NAMES;

/* How a method is tried: h = 2^-coarsest s at first, 2^-8 s where nothing is said; with plain sums, unless it is seen
 * compensated only. */
typedef struct trial {
    int coarsest;
    unsigned options;
} trial;

static const trial trials[ISO_METHODS] = {
    [ISO_EULER] = {12, 0},
    [ISO_HEUN] = {8, 0},
    [ISO_RK4] = {7, 0},
    [ISO_AB4] = {8, 0},
    [ISO_SEMI_IMPLICIT] = {12, 0},
    [ISO_ABM4] = {8, 0},
    [ISO_ABM4_PEC] = {10, ISO_COMPENSATED},
    [ISO_ABM4_PECECE] = {8, 0},
    [ISO_BDF4] = {8, 0},
    [ISO_ROSENBROCK] = {8, 0},
};

static int coarsest_of(const unsigned recipe)
{
    const int coarsest = trials[ISO_METHOD_OF(recipe)].coarsest;
    return coarsest > 0 ? coarsest : 8;
}

typedef struct method {
    const char *name;
    unsigned recipe;
    const iso_tableau *table; /* of a control, in place of the recipe's */
    bool unprimed;            /* what a control keeps from step to step begins with zeros */
    double jacobian;          /* a control's is this times too large */
} method;

static method right(const unsigned recipe)
{
    return (method){names[ISO_METHOD_OF(recipe)], recipe, NULL, false, 1.0};
}

static const iso_tableau wrong_euler = {.stages = 1, .a_over = {1}, .b = {2}, .b_over = 3};
static const iso_tableau wrong_heun = {.stages = 2, .a = {{0}, {1}}, .a_over = {1, 1}, .b = {1, 2}, .b_over = 3};
static const iso_tableau wrong_rk4 = {
    .stages = 4,
    .a = {{0}, {1}, {0, 1}, {0, 0, 1}},
    .a_over = {1, 2, 2, 1},
    .b = {1, 3, 1, 1},
    .b_over = 6,
};

/* Positive controls: one wrong weight, a history that is not there, a Jacobian that is not right. */
static const method controls[] = {
    {"euler with a wrong weight", ISO_EULER, &wrong_euler, false, 1.0},
    {"heun with a wrong weight", ISO_HEUN, &wrong_heun, false, 1.0},
    {"rk4 with a wrong weight", ISO_RK4, &wrong_rk4, false, 1.0},
    {"ab4 without its history", ISO_AB4, NULL, true, 1.0},
    {"abm4 without its history", ISO_ABM4, NULL, true, 1.0},
    {"bdf4 without its history", ISO_BDF4, NULL, true, 1.0},
    {"rosenbrock with a Jacobian 1 % off", ISO_ROSENBROCK, NULL, false, 1.01},
};

static real jacobian_scale;

static void scaled_factor(real *restrict const lu, const real *restrict const x, const real *restrict const u,
                          const real *restrict const p, const real hb)
{
    the_equations->factor(lu, x, u, p, jacobian_scale * hb);
}

/* The state at 1 s with steps of 2^-k s. */
static void run(const method *const m, const int k, real x[ORDER_STATES_MAX * VECTORS_MAX])
{
    const size_t n = (size_t)the_problem.states;
    const real h = (real)ldexp(1.0, -k);
    const real u[ORDER_INPUTS_MAX] = {(real)the_problem.input[0]};
    const real *const p = iso_the_plant.model->defaults;
    iso_equations eq = *the_equations;
    const iso_history history = {.n = n, .x = x};
    real work[ISO_PRIME_VECTORS * ORDER_STATES_MAX], lu[FACTORS_MAX];
    iso_any_progress progress = {{.local_error = R(0.0)}};
    jacobian_scale = (real)m->jacobian;
    eq.factor = scaled_factor;
    eq.linearise = NULL;
    memset(x, 0, ORDER_STATES_MAX * VECTORS_MAX * sizeof *x);
    for (size_t i = 0; i < n; i++) {
        x[i] = (real)the_problem.start[i];
    }
    if (!m->unprimed) {
        iso_method_prime(m->recipe, n, &eq, h, x, u, p, lu, work, &progress.progress);
    }
    for (long step = 0; step < 1L << k; step++) {
        if (m->table != NULL) {
            (void)one_explicit_step(m->table, &history, eq.derivative, h, u, p, work);
        } else {
            iso_method_step(m->recipe, n, &eq, h, x, u, p, lu, work, &progress.progress);
        }
    }
}

/* The error at 1 s: 2-norm over the states. */
static double error_of(const method *const m, const int k)
{
    real x[ORDER_STATES_MAX * VECTORS_MAX];
    double defaults[PARAMETERS_MAX] = {0.0};
    long double y[ORDER_STATES_MAX] = {0.0L};
    long double square = 0.0L;
    run(m, k, x);
    for (int i = 0; i < iso_the_plant.model->parameters; i++) {
        defaults[i] = (double)iso_the_plant.model->defaults[i];
    }
    the_problem.exact(y, defaults);
    for (int i = 0; i < the_problem.states; i++) {
        square += ((long double)x[i] - y[i]) * ((long double)x[i] - y[i]);
    }
    return (double)sqrtl(square);
}

/* Prints the observed orders; true if all are the method's. */
static bool has_order(const method *const m)
{
    const int coarsest = coarsest_of(m->recipe);
    bool all = true;
    double coarse = error_of(m, coarsest);
    for (int i = 1; i <= HALVINGS; i++) {
        const int k = coarsest + i;
        const double fine = error_of(m, k);
        const double order = log2(coarse / fine);
        report_note("%s, h = 2^-%d to 2^-%d s: error %.3e to %.3e, order %.4f", m->name, k - 1, k, coarse, fine, order);
        all = all && fabs(order - ISO_ORDER_OF(m->recipe)) <= ORDER_TOLERANCE;
        coarse = fine;
    }
    return all;
}

/* Lines `name k error`, with steps of 2^-k s. */
static int print_errors(const unsigned options)
{
    for (unsigned i = 0; i < ISO_METHODS; i++) {
        const method m = right(i | options);
        for (int k = coarsest_of(i); k <= coarsest_of(i) + HALVINGS && !ISO_IS_VARYING(i); k++) {
            printf("%s\t%d\t%.9e\n", m.name, k, error_of(&m, k));
        }
    }
    return 0;
}

static void test_order(const method *const m)
{
    const bool passed = has_order(m);
    report_ok(passed, "%s%s has order %d within %.1f over %d halvings", m->name,
              ISO_IS_COMPENSATED(m->recipe) ? ", compensated," : "", ISO_ORDER_OF(m->recipe), ORDER_TOLERANCE,
              HALVINGS);
}

static void test_orders(const bool by_sines)
{
    for (unsigned i = 0; i < ISO_METHODS; i++) {
        if (ISO_IS_VARYING(i) || (by_sines && !ISO_BY_SINES(i))) {
            continue;
        }
        const method plain = right(i | trials[i].options);
        const method compensated = right(i | ISO_COMPENSATED);
        if (plain.recipe != compensated.recipe) {
            test_order(&plain);
        }
        test_order(&compensated);
    }
}

int main(const int count, char **const arguments)
{
    const bool by_sines = count > 1 && strcmp(arguments[1], "sines") == 0;
    if (count > 1 && strcmp(arguments[1], "errors") == 0) {
        return print_errors(count > 2 ? 0 : ISO_COMPENSATED);
    }
    if (!report_ok(iso_the_plant.model->states == the_problem.states &&
                       iso_the_plant.model->inputs <= ORDER_INPUTS_MAX &&
                       iso_the_plant.model->parameters <= PARAMETERS_MAX && the_equations->factors <= FACTORS_MAX &&
                       (by_sines ? the_equations->angle_count : the_equations->factors) > 0,
                   "the plant has the problem's states, and %s", by_sines ? "angles" : "a Jacobian")) {
        return report_done();
    }
    test_orders(by_sines);
    for (size_t i = 0; i < sizeof controls / sizeof *controls && !by_sines; i++) {
        const bool passed = has_order(&controls[i]);
        report_ok(!passed, "control: %s has not order %d", controls[i].name, ISO_ORDER_OF(controls[i].recipe));
    }
    return report_done();
}
