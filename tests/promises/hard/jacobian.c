/* The factors of the chain's equations, which the implicit methods of the long run need, against central differences of
 * the equations: in double, to 1e-8 of the largest part of hb J. Control: differences taken a milliradian aside do not
 * agree. */
#include <math.h>

#include "tests/promises/hard/chain.h"

static const real masses[] = {R(9.81), R(0.7), R(1.0), R(2.0), R(0.5), R(1.0),
                              R(4.0),  R(1.0), R(0.2), R(1.0), R(3.0), R(1.0)};

/* The factors at the run's state, used to solve for every column of 1 - hb J from central differences at `at`: what is
 * not a column of the unit matrix, as a part of the largest of hb J. */
static double jacobian_error(const hard_run *const run, const real *const at)
{
    static real lu[HARD_STATES_MAX * HARD_STATES_MAX];
    const double d = 1e-5;
    const size_t n = run->problem->n;
    double worst = 0.0;
    double largest = 0.0;
    const real hb = R(1e-3);
    run->problem->equations.factor(lu, run->x, run->u, run->problem->p, hb);
    for (size_t j = 0; j < n; j++) {
        real x[HARD_STATES_MAX];
        real ahead[HARD_STATES_MAX];
        real behind[HARD_STATES_MAX];
        memcpy(x, at, n * sizeof *x);
        x[j] = at[j] + (real)d;
        run->problem->equations.derivative(ahead, x, run->u, run->problem->p);
        x[j] = at[j] - (real)d;
        run->problem->equations.derivative(behind, x, run->u, run->problem->p);
        for (size_t i = 0; i < n; i++) {
            const real derivative = (ahead[i] - behind[i]) / (real)(2.0 * d);
            largest = fmax(largest, fabs((double)(hb * derivative)));
            x[i] = (i == j ? R(1.0) : R(0.0)) - hb * derivative;
        }
        run->problem->equations.solve(x, lu);
        for (size_t i = 0; i < n; i++) {
            worst = fmax(worst, fabs((double)x[i] - (i == j ? 1.0 : 0.0)));
        }
    }
    return worst / largest;
}

static void test_jacobian(const hard_problem *const problem)
{
    static hard_run run;
    real other[HARD_STATES_MAX];
    hard_begin(&run, problem, ISO_RK4, 1e-3);
    (void)hard_go(&run, 300);
    memcpy(other, run.x, sizeof other);
    const double error = jacobian_error(&run, other);
    other[0] += R(1e-3);
    const double elsewhere = jacobian_error(&run, other);
    report_ok(error < 1e-8, "%s: (1 - hb J)^-1 against differences: %.1e", problem->name, error);
    report_ok(elsewhere > 1e-6, "control: a milliradian aside it is %.1e off", elsewhere);
}

int main(void)
{
    const hard_problem problems[] = {
        {"1 link", 2, chain_of_1, {1.0}, masses},
        {"2 links", 4, chain_of_2, {1.0, 0.5}, masses},
        {"3 links", 6, chain_of_3, {1.0, 0.5, -2.0}, masses},
        {"10 links", 20, chain_of_10, {1.5, 0.3, -1.0, 2.0, 0.3, 0.1, 0.3, -3.0, 0.3, 0.7}, masses},
    };
    for (size_t i = 0; i < sizeof problems / sizeof *problems; i++) {
        test_jacobian(&problems[i]);
    }
    return report_done();
}
