/* A decay to nothing, x' = -x at h = 1/8 s, down through the denormal numbers: to 1.4e-45 in float, 4.9e-324 in double.
 *
 * The equation is linear, so that a run from 2^-s is 2^-s times the run from 1, which stays among the normal numbers.
 * What must hold, for every method, compensated or not, in float and in double:
 *   bit for bit, while x is 2^16 times the least normal number or more: until then all that a step computes is normal;
 *   then to 32 times the least denormal: the terms of a step lose half of that each, and the 1 / (1 - exp(-h)) = 8.5
 *   last steps count; and to 9 ulps, since what a term lost can tip the rounding of x in each of them;
 *   denormals are kept: x takes values between 0 and the least normal number, and comes to rest below 32 times the
 *   least.
 *
 *     denormals count METHOD from-one|from-denormals|from-infinity
 *
 * takes 1000 steps from there and does nothing else: tests/promises/hard/hard.t counts the instructions.
 */
#include <math.h>
#include <stdlib.h>

#include "tests/promises/hard/hard.h"

#define STEP 0.125

static void derivative(real *restrict const dx, const real *restrict const x, const real *restrict const u,
                       const real *restrict const p)
{
    (void)u;
    (void)p;
    dx[0] = -x[0];
}

static void factor(real *restrict const lu, const real *restrict const x, const real *restrict const u,
                   const real *restrict const p, const real hb)
{
    (void)x;
    (void)u;
    (void)p;
    lu[0] = R(-1.0);
    iso_dense_factor(lu, 1, hb);
}

static void solve(real *restrict const d, const real *restrict const lu)
{
    iso_dense_solve(d, lu, 1);
}

static const hard_problem from_one = {"decay", 1, {derivative, factor, solve, .factors = 1}, {1.0}, NULL};

static void test_method(const unsigned recipe)
{
    static hard_run run[2];
    const double least = HARD_PICK(ldexp(1.0, -149), ldexp(1.0, -1074));
    const double normal = HARD_PICK(ldexp(1.0, -126), ldexp(1.0, -1022));
    const int s = HARD_PICK(100, 996);
    hard_problem from_small = from_one;
    from_small.start[0] = ldexp(1.0, -s);
    hard_begin(&run[0], &from_one, recipe, STEP);
    hard_begin(&run[1], &from_small, recipe, STEP);
    bool same = true;
    long denormals = 0;
    double worst = 0.0;
    for (long i = 0; i < 600; i++) {
        (void)hard_go(&run[0], 1);
        (void)hard_go(&run[1], 1);
        const double want = ldexp((double)run[0].x[0], -s);
        const double got = (double)run[1].x[0];
        same = same && (got == want || fabs(want) < normal * 65536.0);
        denormals += fabs(got) > 0.0 && fabs(got) < normal;
        worst = fmax(worst, fabs(got - want) / (32.0 * least + 9.0 * (double)ISO_REAL_EPSILON * fabs(want)));
    }
    const char *const name = hard_name(recipe);
    const char *const also = ISO_IS_COMPENSATED(recipe) ? ", compensated" : "";
    report_ok(same, "%s%s: the same bits, scaled, down to the last normal numbers", name, also);
    report_ok(worst <= 1.0, "%s%s: then off by %.2f of what rounding allows", name, also, worst);
    report_ok(denormals > 50 && fabs((double)run[1].x[0]) <= 32.0 * least,
              "%s%s: %ld states are denormal, the last is %.0f times the least", name, also, denormals,
              fabs((double)run[1].x[0]) / least);
}

static int count(const unsigned recipe, const char *const from)
{
    enum { STEPS = 1000 };
    static hard_run run;
    hard_begin(&run, &from_one, recipe, STEP);
    if (strcmp(from, "from-denormals") == 0) {
        run.x[0] = iso_real_of((iso_bits)12345);
    } else if (strcmp(from, "from-infinity") == 0) {
        run.x[0] = iso_real_of(ISO_EXPONENT_BITS);
    }
    hard_prime(&run);
    (void)hard_go(&run, STEPS);
    return 0;
}

int main(const int argc, char **const argv)
{
    if (argc == 4 && strcmp(argv[1], "count") == 0) {
        return count((unsigned)atoi(argv[2]), argv[3]);
    }
    static const unsigned methods[] = {ISO_EULER,    ISO_HEUN,        ISO_RK4,  ISO_AB4,       ISO_ABM4,
                                       ISO_ABM4_PEC, ISO_ABM4_PECECE, ISO_BDF4, ISO_ROSENBROCK};
    for (size_t i = 0; i < sizeof methods / sizeof *methods; i++) {
        test_method(methods[i]);
        test_method(methods[i] | ISO_COMPENSATED);
    }
    return report_done();
}
