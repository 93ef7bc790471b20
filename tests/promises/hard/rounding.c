/* Steps so small that rounding rules: the pendulum, from 1 rad at rest, for a second in steps of 2^-5 s to 2^-20 s
 * (1e-6 s), with and without compensated sums. The solution is cn and sn of Jacobi, computed here by the
 * arithmetic-geometric mean in long double.
 *
 * What must hold:
 *   without compensation the error draws a V: it falls with the method's order, and rises again with the number of
 *   steps. With it the error falls and stays at the bottom. heun and rk4 in float, rk4 in double, whose bottom lies
 *   near 1e-3 s.
 *   at 2^-20 s compensation is better by 30 times at least.
 * Control: the check for the rising branch finds none where sums are compensated.
 * The table is printed, and written to the file that the argument names.
 */
#include <math.h>
#include <stdio.h>

#include "core/numbers/sincos.h"
#include "tests/promises/hard/hard.h"

enum { COARSEST = 5, FINEST = 20, ROWS = FINEST - COARSEST + 1 };

#define GRAVITY R(9.81)
#define START R(1.0)

static void derivative(real *restrict const dx, const real *restrict const x, const real *restrict const u,
                       const real *restrict const p)
{
    (void)u;
    (void)p;
    dx[0] = x[1];
    dx[1] = -GRAVITY * iso_sincos(x[0]).sin;
}

static const hard_problem problem = {"pendulum", 2, {.derivative = derivative}, {(double)START, 0.0}, NULL};

/* sin(q/2) = k cd(w t, k), q' = -2 w k sqrt(1 - k^2) sd(w t, k) with k = sin(START / 2), w^2 = g. Abramowitz and Stegun
 * (1964), 16.4: the amplitude by descending the arithmetic-geometric mean. */
static void solve(long double exact[2], const long double t)
{
    enum { LEVELS = 8 };
    const long double w = sqrtl((long double)GRAVITY);
    const long double k = sinl(0.5L * (long double)START);
    long double a[LEVELS];
    long double c[LEVELS];
    long double b = sqrtl(1.0L - k * k);
    a[0] = 1.0L;
    c[0] = k;
    for (int i = 1; i < LEVELS; i++) {
        a[i] = 0.5L * (a[i - 1] + b);
        c[i] = 0.5L * (a[i - 1] - b);
        b = sqrtl(a[i - 1] * b);
    }
    long double phi = ldexpl(a[LEVELS - 1] * w * t, LEVELS - 1);
    for (int i = LEVELS - 1; i > 0; i--) {
        phi = 0.5L * (phi + asinl(c[i] / a[i] * sinl(phi)));
    }
    const long double dn = sqrtl(1.0L - k * k * sinl(phi) * sinl(phi));
    exact[0] = 2.0L * asinl(k * cosl(phi) / dn);
    exact[1] = -2.0L * w * k * sqrtl(1.0L - k * k) * sinl(phi) / dn;
}

static double error_of(const unsigned recipe, const int k, const long double *const exact)
{
    static hard_run run;
    hard_begin(&run, &problem, recipe, ldexp(1.0, -k));
    (void)hard_go(&run, 1L << k);
    return (double)fmaxl(fabsl((long double)run.x[0] - exact[0]), fabsl((long double)run.x[1] - exact[1]));
}

/* Whether the errors rise again: the last three over ten times the least three in a row, since single ones scatter. */
static bool rises(const double error[ROWS])
{
    double least = HUGE_VAL;
    double last = HUGE_VAL;
    for (int i = 2; i < ROWS; i++) {
        last = error[i - 2] + error[i - 1] + error[i];
        least = fmin(least, last);
    }
    return last > 10.0 * least;
}

static void test_method(const unsigned method, const long double *const exact, FILE *const table)
{
    double plain[ROWS];
    double compensated[ROWS];
    for (int i = 0; i < ROWS; i++) {
        const int k = COARSEST + i;
        plain[i] = error_of(method, k, exact);
        compensated[i] = error_of(method | ISO_COMPENSATED, k, exact);
        report_note("%s " HARD_REAL ", h = 2^-%02d = %.2e s: error %.2e, compensated %.2e", hard_name(method), k,
                    ldexp(1.0, -k), plain[i], compensated[i]);
        fprintf(table, "%s\t" HARD_REAL "\t%.9e\t%.3e\t%.3e\n", hard_name(method), ldexp(1.0, -k), plain[i],
                compensated[i]);
    }
    report_ok(plain[0] > 3.0 * plain[1], "%s: the error falls with the step", hard_name(method));
    report_ok(rises(plain), "%s: then it rises: a V", hard_name(method));
    report_ok(!rises(compensated), "control: %s, compensated: it does not rise", hard_name(method));
    report_ok(plain[ROWS - 1] >= 30.0 * compensated[ROWS - 1],
              "%s: at h = 2^-%d s compensation is better by %.0f times", hard_name(method), FINEST,
              plain[ROWS - 1] / compensated[ROWS - 1]);
}

int main(const int argc, char **const argv)
{
    long double exact[2];
    FILE *const table = argc == 2 ? fopen(argv[1], "w") : NULL;
    if (!report_ok(table != NULL, "the table can be written")) {
        return report_done();
    }
    solve(exact, 1.0L);
    test_method(ISO_RK4, exact, table);
    if (sizeof(real) < sizeof(double)) {
        test_method(ISO_HEUN, exact, table);
    }
    report_ok(fclose(table) == 0, "the table is written");
    return report_done();
}
