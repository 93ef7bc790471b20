/* core/methods/table.h and method.h: every recipe, with its recipe and its size known to the compiler and known only
 * when it runs: the same bits, the evaluations and the memory that are claimed, and the error of a step that it checks.
 */
/* With the rows of all methods before what they share. */
#include "tests/general.h"

#include "tests/core/methods/method/run.h"
#include "tests/tap.h"

_Static_assert(STATE_MAX == ISO_METHOD_STATE(ISO_AB4 | ISO_COMPENSATED | ISO_CHECKED, N), "the most that is kept");

static const real guard = R(7.0);

call_counts calls;

typedef struct recipe_case {
    const char *name;
    unsigned recipe;
    prime_function *prime;
    step_function *step;
    unsigned evaluations, jacobians, solutions;
} recipe_case;

#define CASE(name, recipe, evaluations, jacobians, solutions)                                                          \
    {#name, recipe, prime_##name, step_##name, evaluations, jacobians, solutions},
static const recipe_case cases[] = {RECIPES(CASE)};

/* A guard stands behind what the recipe says that it needs of states and of work. */
static void begin(run *const r, const unsigned recipe, const size_t work)
{
    memset(r, 0, sizeof *r);
    r->x[0] = R(0.1);
    r->x[1] = R(0.2);
    r->x[2] = R(0.3);
    r->x[3] = R(-0.1);
    r->x[ISO_METHOD_STATE(recipe, N)] = guard;
    r->work[work] = guard;
    r->lu[FACTORS] = guard;
}

enum { STEPS = 200 };

static void test_bits(const recipe_case *const c)
{
    static run fixed, any;
    begin(&fixed, c->recipe, WORK_MAX);
    begin(&any, c->recipe, WORK_MAX);
    c->prime(&fixed, R(0.01));
    for (unsigned i = 0; i < STEPS; i++) {
        c->step(&fixed, R(0.01));
    }
    general_prime(c->recipe, N, &equations, R(0.01), any.x, NULL, NULL, any.lu, any.work, &any.progress.progress);
    for (unsigned i = 0; i < STEPS; i++) {
        general_step(c->recipe, N, &equations, R(0.01), any.x, NULL, NULL, any.lu, any.work, &any.progress.progress);
    }
    const bool same =
        memcmp(fixed.x, any.x, sizeof fixed.x) == 0 && fixed.x[0] != R(0.1) &&
        iso_bits_of(fixed.progress.progress.local_error) == iso_bits_of(any.progress.progress.local_error) &&
        iso_bits_of(fixed.progress.progress.residual) == iso_bits_of(any.progress.progress.residual);
    tap_ok(same, c->name);
}

/* What a step needs, the first as any other; and that neither priming nor a step writes beyond its memory. */
static void test_costs(const recipe_case *const c)
{
    static run r;
    begin(&r, c->recipe, ISO_METHOD_PRIME_WORK(c->recipe, N));
    c->prime(&r, R(0.01));
    bool kept = r.work[ISO_METHOD_PRIME_WORK(c->recipe, N)] == guard && r.x[0] == R(0.1) && r.x[3] == R(-0.1);
    r.work[ISO_METHOD_PRIME_WORK(c->recipe, N)] = R(0.0);
    r.work[ISO_METHOD_WORK(c->recipe, N)] = guard;
    memset(&calls, 0, sizeof calls);
    c->step(&r, R(0.01));
    tap_count(calls.derivative, c->evaluations, "evaluations of a step");
    tap_ok(calls.factor == c->jacobians && calls.solve == c->solutions, "Jacobians and solutions of a step");
    kept = kept && r.x[ISO_METHOD_STATE(c->recipe, N)] == guard && r.work[ISO_METHOD_WORK(c->recipe, N)] == guard &&
           r.lu[FACTORS] == guard;
    tap_ok(kept, "state, work space and factors end where their sizes say");
    tap_ok((r.progress.progress.local_error > R(0.0)) == ISO_IS_CHECKED(c->recipe),
           "the error of a step is told if asked for");
    tap_ok(ISO_IS(c->recipe, ISO_BDF4) ? c->evaluations > 1 || r.progress.progress.residual > R(0.0)
                                       : r.progress.progress.residual == R(0.0),
           "the residual of Newton's first iteration is told");
}

/* t' = 1, q' = t^degree, but for semi_implicit, which needs a rate: q'' = 1. */
static unsigned degree;

static real power_of(const real t, const unsigned m)
{
    real power = R(1.0);
    for (unsigned i = 0; i < m; i++) {
        power *= t;
    }
    return power;
}

static void quadrature(real *restrict dx, const real *restrict x, const real *restrict u, const real *restrict p)
{
    (void)u;
    (void)p;
    dx[0] = R(1.0);
    dx[1] = power_of(x[0], degree);
}

static void factor_quadrature(real *restrict lu, const real *restrict x, const real *restrict u, const real *restrict p,
                              const real hb)
{
    (void)u;
    (void)p;
    lu[0] = R(0.0);
    lu[1] = R(0.0);
    lu[2] = (real)degree * power_of(x[0], degree - 1U);
    lu[3] = R(0.0);
    iso_dense_factor(lu, 2, hb);
}

static void solve_quadrature(real *restrict d, const real *restrict lu)
{
    iso_dense_solve(d, lu, 2);
}

/* A step from t = 0 to 1, after three before it, must be found wrong by just its error, q(1) - q(0) - 1 / (degree + 1),
 * in the step after it. Sizes are below 128, and their roundings some dozen. */
static void test_error(const unsigned recipe, const char *const name)
{
    static const iso_equations eq = {quadrature, factor_quadrature, solve_quadrature, .factors = 4};
    static run r;
    real from = R(0.0), to = R(0.0);
    memset(&r, 0, sizeof r);
    degree = (unsigned)ISO_ORDER_OF(recipe);
    r.x[0] = R(-3.0);
    general_prime(recipe, 2, &eq, R(1.0), r.x, NULL, NULL, r.lu, r.work, &r.progress.progress);
    for (unsigned i = 0; i < 5; i++) {
        from = i == 3 ? r.x[1] : from;
        to = i == 4 ? r.x[1] : to;
        general_step(recipe, 2, &eq, R(1.0), r.x, NULL, NULL, r.lu, r.work, &r.progress.progress);
    }
    const real error = iso_abs((to - from) - R(1.0) / (real)(degree + 1));
    const real tolerance = R(16.0) * R(128.0) * ISO_REAL_EPSILON;
    tap_ok(error > R(8.0) * tolerance && iso_abs(r.progress.progress.local_error - error) <= tolerance, name);
}

/* q'' = 1 by semi-implicit Euler: every step goes h^2 / 2 too far. */
static void accelerate(real *restrict dx, const real *restrict x, const real *restrict u, const real *restrict p)
{
    (void)u;
    (void)p;
    dx[0] = x[1];
    dx[1] = R(1.0);
}

static void test_semi_implicit_error(void)
{
    static const iso_equations eq = {.derivative = accelerate};
    static run r;
    const unsigned recipe = ISO_SEMI_IMPLICIT | ISO_CHECKED;
    memset(&r, 0, sizeof r);
    iso_method_prime(recipe, 2, &eq, R(0.75), r.x, NULL, NULL, r.lu, r.work, &r.progress.progress);
    iso_method_step(recipe, 2, &eq, R(0.75), r.x, NULL, NULL, r.lu, r.work, &r.progress.progress);
    iso_method_step(recipe, 2, &eq, R(0.75), r.x, NULL, NULL, r.lu, r.work, &r.progress.progress);
    tap_same(r.progress.progress.local_error, R(0.28125), "semi_implicit: the error of a step is told in the next");
}

/* Errors of size 1 for as long as it takes to know it, then one of this size. */
static bool leaps(const real error)
{
    iso_progress progress = {.local_error = R(0.0)};
    for (int i = 0; i < ISO_USUAL_STEPS; i++) {
        iso_watch(&progress, R(1.0));
    }
    iso_watch(&progress, error);
    return progress.discontinuity;
}

static void test_watch(void)
{
    iso_progress progress = {.local_error = R(0.0)};
    bool never = true;
    for (int i = 0; i < ISO_USUAL_STEPS; i++) {
        iso_watch(&progress, i % 2 == 0 ? R(0.0) : R(1e6));
        never = never && !progress.discontinuity;
    }
    tap_ok(never, "watch: nothing is usual at the start");
    tap_ok(!leaps(ISO_DISCONTINUITY_RATIO) && leaps(ISO_DISCONTINUITY_RATIO + R(1.0)) && !leaps(R(0.0)),
           "watch: a jump is a leap of the error");
    tap_ok(!leaps(iso_real_of(ISO_EXPONENT_BITS | 1)), "watch: what is not a number is left to the guard");

    for (int i = 0; i < 2 * ISO_USUAL_STEPS; i++) {
        iso_watch(&progress, R(1.0));
    }
    iso_watch(&progress, R(1e4));
    const bool first = progress.discontinuity;
    iso_watch(&progress, R(1e4));
    tap_ok(!first && !progress.discontinuity, "watch: what was usual of late is so yet");
    for (int i = 0; i < 16 * ISO_USUAL_STEPS; i++) {
        iso_watch(&progress, R(1.0));
    }
    iso_watch(&progress, R(1e4));
    tap_ok(progress.discontinuity, "watch: but not for ever");
    iso_watch(&progress, R(1e4));
    tap_ok(!progress.discontinuity, "watch: a second leap to the same size is none");
}

int main(void)
{
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        test_bits(&cases[i]);
        test_costs(&cases[i]);
    }
    test_error(ISO_EULER | ISO_CHECKED, "euler: the error of a step is told in the next");
    test_error(ISO_HEUN | ISO_CHECKED, "heun: the error of a step is told in the next");
    test_error(ISO_RK4 | ISO_CHECKED, "rk4: the error of a step is told in the next");
    test_error(ISO_AB4 | ISO_CHECKED, "ab4: the error of a step is told in the next");
    test_error(ISO_ROSENBROCK | ISO_CHECKED, "rosenbrock: the error of a step is told in the next");
    test_semi_implicit_error();
    test_watch();
    tap_done();
}
