/* core/methods/adams.h: its tables in whole numbers, single sub-steps against results that are exact in binary, and
 * what a budget promises. How accurate whole runs are: tests/core/methods/adaptive. */
#include "core/methods/abm4.h"
#include "tests/core/methods/adaptive/run.h"
#include "tests/tap.h"

enum { N = 2 };

/* Evaluations of any derivative below. */
static uint32_t evaluations;

static void prepare(adams_memory *const m, const real first, const real second)
{
    const real start[N] = {first, second};
    adams_prepare(m, N, start, ISO_ADAMS_TOLERANCE, ISO_ADAMS_BUDGET);
    evaluations = 0;
}

static real *row(adams_memory *const m, const size_t j)
{
    return m->history.past + (j - 1) * N;
}

/* t' = 1, q' = t^3. */
static void cubic(real *restrict dx, const real *restrict x, const real *restrict u, const real *restrict p)
{
    (void)u;
    (void)p;
    evaluations++;
    dx[0] = R(1.0);
    dx[1] = x[0] * x[0] * x[0];
}

/* t' = 1, v' = u - 64 v: the faster the coarser the steps may be that follow. */
static void pulled(real *restrict dx, const real *restrict x, const real *restrict u, const real *restrict p)
{
    (void)p;
    evaluations++;
    dx[0] = R(1.0);
    dx[1] = u[0] - R(64.0) * x[1];
}

/* q' = v, v' = -q. */
static void oscillator(real *restrict dx, const real *restrict x, const real *restrict u, const real *restrict p)
{
    (void)u;
    (void)p;
    evaluations++;
    dx[0] = x[1];
    dx[1] = -x[0];
}

/* t' = 1, q' = u. */
static void driven(real *restrict dx, const real *restrict x, const real *restrict u, const real *restrict p)
{
    (void)x;
    (void)p;
    evaluations++;
    dx[0] = R(1.0);
    dx[1] = u[0];
}

/* t' = 1, q' = 0, but not a number for u = 0. */
static void undefined(real *restrict dx, const real *restrict x, const real *restrict u, const real *restrict p)
{
    (void)x;
    (void)p;
    evaluations++;
    dx[0] = R(1.0);
    dx[1] = R(1.0) / u[0] - R(1.0) / u[0];
}

/* The table in whole numbers, and rows 5: of order 5 it is left out, of the others it is zero. */
enum { OVER = 1440, TABLE_ORDERS = ISO_ADAMS_ORDERS + 1, TABLE_ROWS = TABLE_ORDERS + 1 };

static bool whole_table(int32_t l[TABLE_ORDERS + 2][TABLE_ROWS])
{
    bool whole = true;
    for (size_t q = 0; q <= TABLE_ORDERS + 1; q++) {
        for (size_t j = 0; j <= ISO_ADAMS_ORDERS; j++) {
            const real times = (real)OVER * iso_table_nordsieck[q][j];
            l[q][j] = (int32_t)(times + R(0.5));
            /* a quotient and a product are rounded */
            whole = whole && iso_abs(times - (real)l[q][j]) <= times * ISO_REAL_EPSILON;
        }
        l[q][TABLE_ORDERS] = q == TABLE_ORDERS ? OVER / (2 * 3 * 4 * 5) : 0;
    }
    return whole;
}

/* The polynomial of the l and its derivative at -i, times OVER. */
static int32_t value(const int32_t l[TABLE_ROWS], const int32_t i)
{
    int32_t sum = 0;
    for (int j = TABLE_ORDERS; j >= 0; j--) {
        sum = l[j] - i * sum;
    }
    return sum;
}

static int32_t derivative(const int32_t l[TABLE_ROWS], const int32_t i)
{
    int32_t sum = 0;
    for (int j = TABLE_ORDERS; j > 0; j--) {
        sum = j * l[j] - i * sum;
    }
    return sum;
}

/* The implicit Adams method of order q less the truth for x = t^(q+1) from t = -1 to 0, times over: its derivatives are
 * (q + 1) (-j)^q. */
static int32_t adams_error(const iso_adams *const am, const int32_t q)
{
    int32_t sum = 0;
    for (int32_t j = 0; j < ISO_ADAMS_DERIVATIVES; j++) {
        int32_t power = am->b[j];
        for (int32_t i = 0; i < q; i++) {
            power *= -j;
        }
        sum += power;
    }
    const int32_t exact = q % 2 == 0 ? 1 : -1;
    return (q + 1) * sum - exact * am->over;
}

static void test_table(void)
{
    int32_t l[TABLE_ORDERS + 2][TABLE_ROWS];
    bool start_held = true;
    bool derivatives_held = true;
    bool first = true;
    bool last = true;
    bool moulton = true;
    bool errors = true;
    int32_t factorial = 1;
    tap_ok(whole_table(l), "table: whole numbers over 1440, rounded");
    for (int32_t q = 1; q <= TABLE_ORDERS; q++) {
        const iso_adams *const am = &iso_table_am[q - 1];
        factorial *= q;
        start_held = start_held && value(l[q], 1) == 0;
        for (int32_t i = 1; i < q; i++) {
            derivatives_held = derivatives_held && derivative(l[q], i) == 0;
        }
        first = first && l[q][1] == OVER;
        last = last && l[q][q] * factorial == OVER;
        for (int32_t j = q + 1; j <= TABLE_ORDERS; j++) {
            last = last && l[q][j] == 0;
        }
        errors = errors && adams_error(am, q) * OVER == (l[q][0] - l[q + 1][0]) * factorial * (q + 1) * am->over;
    }
    for (int32_t q = 1; q <= TABLE_ORDERS + 1; q++) {
        moulton = moulton && l[q][0] * iso_table_am[q - 1].over == iso_table_am[q - 1].b[0] * OVER;
    }
    tap_ok(start_held, "table: a correction leaves the state one step before alone");
    tap_ok(derivatives_held, "table: and the derivatives before that");
    tap_ok(first, "table: it moves the derivative at the end by itself");
    tap_ok(last, "table: the last of order q is 1 / q!, and the others are zero");
    tap_ok(moulton, "table: the correction of the state is that of the implicit Adams method");
    tap_ok(errors, "table: what the next order has more of it are the error constants of these methods");
    tap_ok(derivative(l[4], 4) != 0, "table, control: four steps before, the derivative does change");
}

/* z of t^4 at t = 3 with h = 1/2: all binary; one step further it is that at 3.5. */
static void test_predict(void)
{
    adams_memory m;
    real z[ISO_ADAMS_ORDERS + 1];
    prepare(&m, R(3.0), R(81.0));
    row(&m, 1)[1] = R(54.0);   /* 4 t^3 h */
    row(&m, 2)[1] = R(13.5);   /* 6 t^2 h^2 */
    row(&m, 3)[1] = R(1.5);    /* 4 t h^3 */
    row(&m, 4)[1] = R(0.0625); /* h^4 */
    iso_adams_predict(&m.history, 1, z);
    tap_same(z[0], R(69.0625), "predict: the increment of a quartic is exact");
    tap_same(z[1], R(85.75), "predict: and its derivative");
    tap_same(z[2], R(18.375), "predict: and its second row");
    tap_same(z[3], R(1.75), "predict: and its third");
    tap_same(z[4], R(0.0625), "predict: and its fourth");
}

/* The state of `cubic` at t = 3, x = t^4 / 4, in the middle of a run with two steps to the tick of 1. Order 4: the
 * Taylor rows. Order 3: those of the parabola through the derivatives at 3, 5/2 and 2, which is t^3 - (t - 3) (t - 5/2)
 * (t - 2). */
static void in_the_middle(adams_memory *const m, const uint8_t order)
{
    prepare(m, R(3.0), R(20.25));
    row(m, 1)[0] = R(0.5);
    row(m, 1)[1] = R(13.5);
    row(m, 2)[1] = order == 4 ? R(3.375) : R(3.3125);
    row(m, 3)[1] = order == 4 ? R(0.375) : R(0.3125);
    row(m, 4)[1] = order == 4 ? R(0.015625) : R(0.0);
    row(m, 5)[1] = order == 4 ? R(0.0) : R(0.375); /* the last correction, h^4 x^(4) */
    m->state = (iso_adams_state){.order = order, .level = 1};
}

static void test_exact(void)
{
    adams_memory m;
    in_the_middle(&m, 4);
    const real error = adams_tick(&m, cubic, R(1.0), NULL);
    tap_same(m.x[0], R(4.0), "order 4: the clock is exact");
    tap_same(m.x[1], R(64.0), "order 4: the integral of a cubic derivative is exact");
    tap_same(error, R(0.0), "order 4: and its estimate is zero");
    tap_same(row(&m, 1)[1], R(32.0), "order 4: the first row is the derivative at the end");
    tap_same(row(&m, 3)[1], R(0.5), "order 4: the rows move on");
    tap_count(m.state.substeps, 2, "order 4: two steps of half a tick");
    tap_count(m.state.evaluations, 4, "order 4: two evaluations each");
    tap_count(evaluations, 4, "order 4: which are all that there were");
}

/* Whether rows 2 to 4 of the quartic are these, to the roundings of some operations. */
static bool has_rows(adams_memory *const m, const real second, const real third, const real fourth)
{
    const real near = R(8.0) * ISO_REAL_EPSILON;
    return iso_abs(row(m, 2)[1] - second) <= near * second && iso_abs(row(m, 3)[1] - third) <= near * second &&
           iso_abs(row(m, 4)[1] - fourth) <= near * second;
}

/* At order 3 the parabola misses h^4 x^(4) = 3/8 of the derivative at 7/2; 1/24 of it is the local error. The next
 * correction of a quartic is the same. */
static void test_estimate(void)
{
    const real correction = R(0.375);
    const real near = R(8.0) * ISO_REAL_EPSILON; /* of what was rounded: four operations */
    adams_memory m;
    in_the_middle(&m, 3);
    iso_adams_run run = adams_walk(&m, cubic, R(1.0));
    m.options.tolerance_absolute = R(1.0);
    m.options.tolerance_relative = R(0.0);
    const adams_memory before = m;
    const real estimate = iso_adams_try(&run);
    tap_ok(iso_abs(estimate - correction / R(24.0)) <= near, "estimate: 1/24 of the correction at order 3");
    tap_ok(memcmp(before.x, m.x, sizeof m.x) == 0, "a sub-step that was only tried leaves the state as it is");
    m.options.tolerance_absolute = R(0.25);
    m.options.tolerance_relative = R(0.25) / m.x[1];
    tap_ok(iso_abs(iso_adams_try(&run) - R(2.0) * estimate) <= near * estimate,
           "estimate: over the sum of the absolute tolerance and the relative one");
    m.state.age = 1;
    const iso_adams_estimates estimates = iso_adams_correct(&run);
    const real corrected = R(20.25) + (R(17.125) + R(5.0) / R(12.0) * correction);
    tap_ok(iso_abs(m.x[1] - corrected) <= near * corrected, "corrected by 5/12 of the correction");
    tap_ok(iso_abs((R(37.515625) - m.x[1]) - run.error[1]) <= near * corrected,
           "estimate: the true error of a quartic");
    tap_ok(estimates.higher <= near, "estimate: at order 4 a quartic has none");
    in_the_middle(&m, 3);
    (void)iso_adams_try(&run);
    row(&m, 5)[1] = R(0.0);
    m.state.age = 1;
    tap_ok(iso_adams_correct(&run).higher > R(1.0), "estimate, control: a correction of before that is not right");
}

/* A tolerance T is T (1 + |x|), x at the start of the sub-step, in every state: of states that stand elsewhere, with
 * the same motion. All numbers but the reciprocal are exact. */
static void test_tolerance(void)
{
    static const real places[] = {R(0.0), R(1.0), R(-1.0), R(3.0), R(-1023.0)};
    const real correction = R(0.375) / R(24.0);
    bool good = true, accepted = true, absolute = true;
    for (size_t i = 0; i < sizeof places / sizeof *places; i++) {
        for (real t = R(5.0); t > R(1e-5); t *= R(0.125)) {
            const real size = iso_abs(places[i]);
            adams_memory m;
            in_the_middle(&m, 3);
            m.x[1] = places[i];
            m.options = iso_adams_default;
            m.options.tolerance_absolute = t * (m.options.tolerance_absolute / ISO_ADAMS_TOLERANCE);
            m.options.tolerance_relative = t * (m.options.tolerance_relative / ISO_ADAMS_TOLERANCE);
            iso_adams_run run = adams_walk(&m, cubic, R(1.0));
            const real estimate = iso_adams_try(&run), allowed = t * (R(1.0) + size);
            const real near = R(8.0) * ISO_REAL_EPSILON * estimate;
            good = good && iso_abs(estimate - correction / allowed) <= near;
            iso_adams_attempt(&run);
            accepted = accepted && (m.state.rejected > 0) == (correction > allowed);
            absolute = absolute && iso_abs(estimate - correction / t) <= near;
        }
    }
    tap_ok(good, "tolerance: the estimate is over T (1 + |x|)");
    tap_ok(accepted, "tolerance: above it a sub-step is refused");
    tap_ok(!absolute, "tolerance, control: an absolute one is another");
}

/* The rows of a quartic at 7/2 where the parabola was: at order 3 through the derivatives at 7/2, 3 and 5/2, at order 4
 * as they are. */
static void test_orders(void)
{
    adams_memory m;
    in_the_middle(&m, 3);
    iso_adams_run run = adams_walk(&m, cubic, R(1.0));
    (void)iso_adams_try(&run);
    (void)iso_adams_correct(&run);
    tap_ok(has_rows(&m, R(4.53125), R(0.375), R(0.0)), "order 3: a parabola through three derivatives");
    iso_adams_raise(&run);
    tap_ok(has_rows(&m, R(4.59375), R(0.4375), R(0.015625)), "raise: the quartic as it is");
    tap_count(m.state.order, 4, "raise: the order");
    iso_adams_lower(&run);
    tap_ok(has_rows(&m, R(4.53125), R(0.375), R(0.0)), "lower: the parabola again");
    tap_same(row(&m, 4)[1], R(0.0), "lower: the row is gone");
    tap_ok(iso_abs(row(&m, 5)[1] - R(0.375)) <= R(8.0) * ISO_REAL_EPSILON, "lower: the last correction is known");
    tap_count(m.state.order, 3, "lower: the order");
}

/* Halved and doubled, the parabola goes through the derivatives of t^3 at 3, 11/4 and 5/2, or at 3, 2 and 1. */
static void test_scale(void)
{
    adams_memory m;
    in_the_middle(&m, 3);
    iso_adams_run run = adams_walk(&m, cubic, R(1.0));
    iso_adams_halve(&run);
    tap_ok(has_rows(&m, R(0.83984375), R(0.04296875), R(0.0)),
           "halve: a parabola through derivatives half as far back");
    tap_same(row(&m, 1)[1], R(6.75), "halve: the first row by 1/2");
    tap_count(m.state.level, 2, "halve: one level more");
    tap_count(run.remaining, 4, "halve: twice the sub-steps");
    iso_adams_double(&run);
    tap_ok(has_rows(&m, R(3.3125), R(0.3125), R(0.0)), "double: undoes it");
    iso_adams_double(&run);
    tap_ok(has_rows(&m, R(12.5), R(2.0), R(0.0)), "double: a parabola through derivatives twice as far back");
    tap_same(row(&m, 5)[1], R(6.0), "double: the correction by 2^4");
    tap_count(m.state.level, 0, "double: one level less");
    tap_count(run.remaining, 1, "double: half the sub-steps");

    in_the_middle(&m, 3);
    row(&m, 5)[1] = R(0.0);
    iso_adams_halve(&run);
    tap_ok(!has_rows(&m, R(0.83984375), R(0.04296875), R(0.0)), "halve, control: not without the last correction");
}

/* With H = 2^-6 every sub-step is a power of two, so that the clock of the plant adds up without rounding. */
static void test_ends_on_ticks(void)
{
    const real h = R(0.015625);
    adams_memory m;
    prepare(&m, R(0.0), R(0.0));
    m.options.budget = ISO_ADAMS_BUDGET_HOST;
    real u[1] = {R(0.0)};
    bool on_time = true;
    uint8_t finest = 0;
    uint8_t coarsest = UINT8_MAX;
    adams_begin(&m, pulled, h, u);
    for (uint32_t i = 1; i <= 128; i++) {
        u[0] = i % 32 == 0 ? R(64.0) - u[0] : u[0];
        (void)adams_tick(&m, pulled, h, u);
        on_time = on_time && m.x[0] == (real)i * h;
        finest = m.state.level > finest ? m.state.level : finest;
        coarsest = m.state.level < coarsest ? m.state.level : coarsest;
    }
    tap_ok(on_time, "every tick ends on the tick, exactly");
    tap_ok(finest >= coarsest + 3, "while steps are halved and doubled");
    tap_ok(m.state.rejected > 0, "and some rejected");
    tap_count(m.state.budget_bound, 0, "none of them for the budget");
}

/* A tolerance that nothing meets: all of the budget is used, and every sub-step counted. */
static void test_budget(void)
{
    static const uint32_t budgets[] = {1, 2, 3, 8, 13, 16};
    bool bounded = true;
    bool exact = true;
    bool counted = true;
    bool booked = true;
    for (size_t i = 0; i < sizeof budgets / sizeof *budgets; i++) {
        adams_memory m;
        prepare(&m, R(1.0), R(0.0));
        m.options.tolerance_absolute = R(1e-30);
        m.options.tolerance_relative = R(0.0);
        m.options.budget = budgets[i];
        adams_begin(&m, oscillator, R(1.0), NULL);
        uint32_t before = evaluations;
        for (int n = 0; n < 64; n++) {
            (void)adams_tick(&m, oscillator, R(1.0), NULL);
            bounded = bounded && evaluations - before <= 2 * budgets[i];
            exact = exact && (n < 8 || evaluations - before == 2 * budgets[i]);
            before = evaluations;
        }
        counted = counted && m.state.budget_bound == m.state.substeps;
        booked = booked && m.state.evaluations == evaluations;
    }
    tap_ok(bounded, "budget: never more than two evaluations for each sub-step of it");
    tap_ok(exact, "budget: all of it is used for a tolerance that cannot be met");
    tap_ok(counted, "budget: every sub-step with too large an error is counted");
    tap_ok(booked, "budget: so is every evaluation");
}

/* The same where the step is far too large again and again: rejections and restarts are within the budget. */
static void test_budget_of_jumps(void)
{
    adams_memory m;
    prepare(&m, R(0.0), R(0.0));
    real u[1] = {R(1.0)};
    uint32_t worst = 0;
    adams_begin(&m, pulled, R(0.125), u);
    for (int i = 0; i < 64; i++) {
        const uint32_t before = evaluations;
        u[0] = i % 3 == 0 ? -u[0] : u[0];
        (void)adams_tick(&m, pulled, R(0.125), u);
        worst = evaluations - before > worst ? evaluations - before : worst;
    }
    tap_ok(worst <= 2 * ISO_ADAMS_BUDGET, "budget: with a jump every third tick, too");
    tap_ok(m.state.budget_bound > 0, "budget: which binds, and says so");
    tap_same(m.x[0], R(8.0), "budget: and every tick ends on the tick");
    m.options.driven = true;
    const uint32_t before = evaluations;
    (void)adams_tick(&m, pulled, R(0.125), u);
    tap_ok(evaluations - before <= 2 * ISO_ADAMS_BUDGET + 1, "budget: one evaluation more where inputs change");
}

/* The derivative of q jumps from 0 to 1 between two ticks. The jump is exactly on a tick: nothing is lost but the
 * rounding of the sum. */
static void test_restart(void)
{
    adams_memory m;
    real u[1] = {R(0.0)};
    prepare(&m, R(0.0), R(0.0));
    adams_begin(&m, driven, R(1.0), u);
    for (int i = 0; i < 8; i++) {
        (void)adams_tick(&m, driven, R(1.0), u);
    }
    tap_count(m.state.level, 0, "restart: a plant at rest takes steps of a tick");
    tap_count(m.state.restarts, 0, "restart: and none is needed");
    tap_count(m.state.order, 4, "restart: at full order");
    u[0] = R(1.0);
    (void)adams_tick(&m, driven, R(1.0), u);
    tap_count(m.state.restarts, 1, "restart: a derivative that jumped is found, once");
    tap_same(m.x[1], R(1.0), "restart: and nothing of the step is lost");
    tap_ok(m.state.rejected >= 2, "restart: after two sub-steps with estimates that halving did not quarter");

    m.state = (iso_adams_state){0};
    m.options.driven = true;
    u[0] = R(0.0);
    adams_begin(&m, driven, R(1.0), u);
    u[0] = R(1.0);
    (void)adams_tick(&m, driven, R(1.0), u);
    tap_count(m.state.restarts + m.state.rejected, 0,
              "restart: not needed where the derivative is taken at every tick");
    tap_same(m.x[1], R(2.0), "restart: which loses nothing either");
}

/* A start's step is a quarter of the tolerance: h^2 / (2 H) |x'| <= tol / 4, for |x'| = 1 = H and tol = 2^-9 h = 2^-5.
 */
static void test_start(void)
{
    const real u[1] = {R(1.0)};
    adams_memory m;
    prepare(&m, R(0.0), R(0.0));
    m.options.tolerance_absolute = R(0.001953125);
    m.options.tolerance_relative = R(0.0);
    m.options.budget = 64;
    adams_begin(&m, driven, R(1.0), u);
    tap_count(m.state.level, 5, "start: the step by the first derivative");
    tap_count(m.state.order, 1, "start: order 1");
    tap_count(evaluations, 1, "start: one evaluation");
    tap_same(row(&m, 1)[1], R(0.03125), "start: h times the derivative");
    m.options.budget = 8;
    adams_begin(&m, driven, R(1.0), u);
    tap_count(m.state.level, 3, "start: not smaller than the budget can walk");
    tap_same(m.x[1], R(0.0), "start: the state is left as it is");
}

/* Steps of a tick at order 4 are those of abm4, whose derivatives at 0, -h, -2h, -3h are those of the rows below. */
static void test_abm4(void)
{
    enum { STEPS = 32 };
    const real h = R(0.0625);
    /* Derivatives, the newest first, of a motion that passes at 1, 0; any would do. */
    static const real derivatives[ISO_AB4_STEPS] = {R(-1.0), R(-0.75), R(-0.5), R(0.25)};
    real x[N] = {R(1.0), R(0.0)};
    real kept[ISO_AB4_STEPS * N], sums[ISO_ABM4_SUMS * N] = {R(0.0)};
    real work[2 * N];
    adams_memory m;
    prepare(&m, x[0], x[1]);
    m.options.tolerance_absolute = R(1.0);
    m.options.tolerance_relative = R(0.0);
    m.state = (iso_adams_state){.order = 4};
    for (size_t s = 0; s < N; s++) {
        for (size_t j = 0; j < ISO_AB4_STEPS; j++) {
            kept[j * N + s] = s == 0 ? derivatives[ISO_AB4_STEPS - 1 - j] : derivatives[j];
        }
        const real f0 = kept[s], f1 = kept[N + s], f2 = kept[2 * N + s], f3 = kept[3 * N + s];
        const real by = h / R(144.0); /* the cubic through the four, differentiated at the newest */
        row(&m, 1)[s] = h * f0;
        row(&m, 2)[s] = by * (R(132.0) * f0 - R(216.0) * f1 + R(108.0) * f2 - R(24.0) * f3);
        row(&m, 3)[s] = by * (R(48.0) * f0 - R(120.0) * f1 + R(96.0) * f2 - R(24.0) * f3);
        row(&m, 4)[s] = by * (R(6.0) * f0 - R(18.0) * f1 + R(18.0) * f2 - R(6.0) * f3);
    }
    const iso_history history = {.n = N, .x = x, .past = sums};
    for (size_t j = ISO_AB4_STEPS; j-- > 0;) {
        iso_abm4_take_derivative(&history, h, kept + j * N);
    }
    real off = R(0.0);
    real first = R(0.0);
    for (int i = 0; i < STEPS; i++) {
        const iso_adams_run run = adams_walk(&m, oscillator, h);
        const real estimate = iso_adams_try(&run);
        (void)iso_adams_correct(&run);
        iso_step step = {.history = &history, .f = oscillator, .h = h, .work = work};
        iso_abm4_step(&step);
        const real milne = step.error;
        first = i == 0 ? iso_larger(estimate - milne, R(0.0)) / milne : first;
        off = iso_larger(off, iso_larger(m.x[0] - x[0], m.x[1] - x[1]));
    }
    /* Every step rounds some ten numbers of at most 1 on either side, and nothing grows. */
    tap_ok(off <= (real)(2 * 10 * STEPS) * ISO_REAL_EPSILON, "abm4: the same method at order 4 and a step of a tick");
    tap_ok(first <= R(100.0) * ISO_REAL_EPSILON, "abm4: and Milne's estimate");
    tap_count(m.state.evaluations, 2 * STEPS, "abm4: and its evaluations");
}

/* What is not a number ends in the budget, and is left for the guard to find. */
static void test_not_a_number(void)
{
    real u[1] = {R(1.0)};
    adams_memory m;
    prepare(&m, R(1.0), R(0.0));
    adams_begin(&m, undefined, R(1.0), u);
    (void)adams_tick(&m, undefined, R(1.0), u);
    tap_same(m.x[1], R(0.0), "a number comes out");
    const uint32_t before = evaluations;
    u[0] = R(0.0);
    (void)adams_tick(&m, undefined, R(1.0), u);
    tap_ok(iso_not_finite(m.x[1]) != 0, "what is not a number comes out");
    tap_ok(evaluations - before <= 2 * ISO_ADAMS_BUDGET, "what is not a number does not cost more than the budget");
    tap_ok(m.state.budget_bound > 0, "what is not a number is never within the tolerance");
}

/* Compensated sums: half an ulp of 1 is added again and again, by a derivative of one ulp and ticks of 1/2. */
static void slow(real *restrict dx, const real *restrict x, const real *restrict u, const real *restrict p)
{
    (void)x;
    (void)u;
    (void)p;
    dx[0] = ISO_REAL_EPSILON;
    dx[1] = R(0.0);
}

static void test_compensated(void)
{
    adams_memory m;
    real compensation[N] = {R(0.0)};
    prepare(&m, R(1.0), R(0.0));
    m.history.compensation = compensation;
    adams_begin(&m, slow, R(0.5), NULL);
    for (int i = 0; i < 16; i++) {
        (void)adams_tick(&m, slow, R(0.5), NULL);
    }
    tap_same(m.x[0], R(1.0) + R(8.0) * ISO_REAL_EPSILON, "compensated: halves of an ulp add up");
    prepare(&m, R(1.0), R(0.0));
    adams_begin(&m, slow, R(0.5), NULL);
    for (int i = 0; i < 16; i++) {
        (void)adams_tick(&m, slow, R(0.5), NULL);
    }
    tap_same(m.x[0], R(1.0), "compensated, control: without it they are lost");
}

int main(void)
{
    test_table();
    test_predict();
    test_exact();
    test_estimate();
    test_tolerance();
    test_orders();
    test_scale();
    test_ends_on_ticks();
    test_budget();
    test_budget_of_jumps();
    test_restart();
    test_start();
    test_abm4();
    test_not_a_number();
    test_compensated();
    tap_done();
}
