/* core/methods/ab4.h, abm4.h and prime.h: the Adams methods of order four and their priming, against results that are
 * exact in binary. */
#include "core/methods/abm4.h"
#include "tests/core/methods/equations.h"
#include "tests/tap.h"

enum { N = 2, KEPT = ISO_ABM4_SUMS };

/* With h = 1.5, h / 24 = 1/16 and every number below is exact, but where 270 divides. */
static const real h = R(1.5);

/* Memory of one run: the states, and what a history keeps behind them; and of its past, the newest derivative first. */
typedef struct run {
    real x[N];
    real past[KEPT * N + 1];
    real derivatives[ISO_AB4_STEPS * N + 1];
    real work[ISO_PRIME_VECTORS * N + 1];
    iso_history history;
} run;

/* The step has the derivative itself. */
static const iso_equations no_equations = {.derivative = NULL};

/* What a step works on. */
static iso_step step_of(run *const r, iso_derivative *const f, const real *const u, const real *const p)
{
    return (iso_step){
        .history = &r->history, .equations = &no_equations, .f = f, .h = h, .u = u, .p = p, .work = r->work};
}

static void prepare(run *const r, const size_t kept, const real first, const real second)
{
    memset(r, 0, sizeof *r);
    r->x[0] = first;
    r->x[1] = second;
    r->past[kept * N] = R(7.0);
    r->derivatives[ISO_AB4_STEPS * N] = R(7.0);
    r->history = (iso_history){.n = N, .x = r->x, .past = r->past};
}

typedef void take_derivative(const iso_history *history, real h, const real *derivative);

/* Fills the sums from r->derivatives, the oldest first. */
static void take(run *const r, take_derivative *const method, const size_t count)
{
    for (size_t j = count; j-- > 0;) {
        method(&r->history, h, r->derivatives + j * r->history.n);
    }
}

/* Each kernel is compiled once, and cold, so that loops whose counts are not known there are not unrolled: that would
 * be most of what this file takes to compile. */
__attribute__((cold)) static void prime(run *const r, iso_derivative *const f, const real *const u, const real *const p,
                                        take_derivative *const method, const uint8_t count, const bool from_now)
{
    const iso_step step = step_of(r, f, u, p);
    memcpy(r->derivatives, iso_walk_back(&step, count, from_now), count * r->history.n * sizeof *r->derivatives);
    take(r, method, count);
}

__attribute__((cold)) static void ab4(run *const r, iso_derivative *const f, const real *const u, const real *const p)
{
    iso_step step = step_of(r, f, u, p);
    iso_evaluate(&step, step.work, step.history->x);
    iso_ab4_step(&step);
}

__attribute__((cold)) static real abm4(run *const r, iso_derivative *const f, const real *const u, const real *const p,
                                       const uint8_t corrections, const bool evaluate_last)
{
    iso_step step = step_of(r, f, u, p);
    iso_abm4_correct(&step, corrections, evaluate_last);
    return step.error;
}

/* t' = 1, q' = t^4. */
static void quartic(real *restrict dx, const real *restrict x, const real *restrict u, const real *restrict p)
{
    (void)u;
    (void)p;
    dx[0] = R(1.0);
    dx[1] = (x[0] * x[0]) * (x[0] * x[0]);
}

static void test_walk_back(void)
{
    run r;
    prepare(&r, 0, R(3.0), R(0.0));
    const iso_step step = step_of(&r, cubic, NULL, NULL);
    r.work[ISO_PRIME_VECTORS * N] = R(7.0);
    const real *d = iso_walk_back(&step, 3, false);
    tap_ok(r.x[0] == R(3.0) && r.x[1] == R(0.0), "prime: the state is left as it is");
    tap_same(d[0 * N + 1], R(3.375), "prime: the newest derivative is the one at t - h");
    tap_same(d[1 * N + 1], R(0.0), "prime: then the one at t - 2h");
    tap_same(d[2 * N + 1], R(-3.375), "prime: then the one at t - 3h");
    tap_ok(d[0] == R(1.0) && d[N] == R(1.0) && d[2 * N] == R(1.0), "prime: derivatives of every state");
    tap_same(d[3 * N], R(0.0), "prime: no more than asked for");
    tap_ok(r.work[0] == h && r.work[1] == R(18.984375), "prime: the increment from t - h to t");

    d = iso_walk_back(&step, 4, true);
    tap_same(d[0 * N + 1], R(27.0), "prime from now: the newest derivative is the one at t");
    tap_same(d[1 * N + 1], R(3.375), "prime from now: then the one at t - h");
    tap_same(d[3 * N + 1], R(-3.375), "prime from now: the last is the one at t - 3h");
    tap_same(d[4 * N], R(0.0), "prime from now: no more than asked for");
    tap_same(r.work[ISO_PRIME_VECTORS * N], R(7.0), "prime: work space ends where its size says");
}

static void test_ab4_cubic(void)
{
    run r;
    prepare(&r, ISO_AB4_SUMS, R(0.0), R(0.0));
    prime(&r, cubic, NULL, NULL, iso_ab4_take_derivative, 3, false);
    ab4(&r, cubic, NULL, NULL);
    tap_same(r.x[0], R(1.5), "ab4: time advances by h");
    tap_same(r.x[1], R(1.265625), "ab4: the integral of a cubic derivative is exact");
    ab4(&r, cubic, NULL, NULL);
    tap_same(r.x[1], R(20.25), "ab4: exact in the second step too");
    tap_same(r.past[ISO_AB4_SUMS * N], R(7.0), "ab4: what is kept ends where its size says");
}

/* By hand: 16 dq = 55*0 - 59*1 + 37*2 - 9*3 = -12 and 16 dv = 55*(-1) - 59*(-2) + 37*4 - 9*0 = 211. Kept is then what
 * the next step adds to w0 f, negated: 16 (59*0 - 37*1 + 9*2) and 16 (59*(-1) - 37*(-2) + 9*4). */
static void test_ab4_by_hand(void)
{
    static const real derivatives[3 * N] = {R(1.0), R(-2.0), R(2.0), R(4.0), R(3.0), R(0.0)};
    run r;
    prepare(&r, ISO_AB4_SUMS, R(1.0), R(0.0));
    memcpy(r.derivatives, derivatives, sizeof derivatives);
    take(&r, iso_ab4_take_derivative, 3);
    ab4(&r, oscillator, NULL, NULL);
    tap_same(r.x[0], R(0.25), "ab4: position by hand");
    tap_same(r.x[1], R(13.1875), "ab4: speed by hand");
    tap_ok(r.past[0] == R(-19.0) / R(16.0) && r.past[1] == R(51.0) / R(16.0), "ab4: what is kept, by hand");
}

static void test_inputs(void)
{
    const real u[1] = {R(3.0)};
    const real p[1] = {R(0.5)};
    run r;
    prepare(&r, 0, R(1.0), R(0.0));
    r.history.n = 1;
    prime(&r, driven, u, p, iso_ab4_take_derivative, 3, false);
    tap_same(r.derivatives[2], R(1.5), "prime: inputs and parameters reach the derivative");
    ab4(&r, driven, u, p);
    tap_same(r.x[0], R(3.25), "ab4: inputs and parameters reach the derivative");
    prime(&r, driven, u, p, iso_abm4_take_derivative, 4, true);
    (void)abm4(&r, driven, u, p, 1, true);
    tap_same(r.x[0], R(5.5), "abm4: inputs and parameters reach the derivative");
}

typedef struct variant {
    const char *cubic;   /* what is tested */
    const char *quartic; /* ... */
    const char *by_hand;
    uint8_t corrections;
    bool evaluate_last;
    real position, speed; /* by hand */
    real derivative;      /* of the speed, taken at the end of the step */
} variant;

/* By hand, from q = 1, v = 0 and derivatives (0, -1), (1, -2), (2, 4), (3, 0). Predicted as above: q = 1/4, v = 211/16.
 * Corrected, 16 dq = 9 v - 8 and 16 dv = -9 q - 19 + 10 + 4 with the predicted q and v:
 *     q = 1 + (9 * 211/16 - 5*1 + 2) / 16 = 2107/256,    v = (-9/4 - 19 + 10 + 4) / 16 = -29/64.
 * Corrected again: q = 1 + (9 * (-29/64) - 3) / 16 = 571/1024,    v = (-9 * 2107/256 - 5) / 16 = -20243/4096. */
static const variant variants[] = {
    {"PECE: the integral of a cubic derivative is exact", "PECE: Milne's estimate is the error of a quartic derivative",
     "PECE: by hand", 1, true, R(8.23046875), R(-0.453125), R(-8.23046875)},
    {"PEC: the integral of a cubic derivative is exact", "PEC: Milne's estimate is the error of a quartic derivative",
     "PEC: by hand", 1, false, R(8.23046875), R(-0.453125), R(-0.25)},
    {"P(EC)^2E: the integral of a cubic derivative is exact",
     "P(EC)^2E: Milne's estimate is the error of a quartic derivative", "P(EC)^2E: by hand", 2, true, R(0.5576171875),
     R(-4.942138671875), R(-0.5576171875)},
};

static void test_abm4_cubic(const variant *const v)
{
    run r;
    prepare(&r, ISO_ABM4_SUMS, R(0.0), R(0.0));
    prime(&r, cubic, NULL, NULL, iso_abm4_take_derivative, 4, true);
    const real first = abm4(&r, cubic, NULL, NULL, v->corrections, v->evaluate_last);
    const bool good = r.x[0] == R(1.5) && r.x[1] == R(1.265625);
    const real second = abm4(&r, cubic, NULL, NULL, v->corrections, v->evaluate_last);
    tap_ok(good && r.x[1] == R(20.25) && r.past[ISO_ABM4_SUMS * N] == R(7.0) && first == R(0.0) && second == R(0.0),
           v->cubic);
}

/* Without feedback Milne's estimate is the error itself: 19/720 h^5 24. The derivatives are those of t^4 in units of h
 * at 0, -1, -2, -3. Everything is exact but for 19 / 270 and its product, and the error that is compared with: 4
 * roundings. */
static void test_abm4_quartic(const variant *const v)
{
    run r;
    prepare(&r, ISO_ABM4_SUMS, R(0.0), R(0.0));
    const real h4 = (h * h) * (h * h);
    for (size_t j = 0; j < 4; j++) {
        r.derivatives[j * N] = R(1.0);
        r.derivatives[j * N + 1] = (real)(j * j * j * j) * h4;
    }
    take(&r, iso_abm4_take_derivative, 4);
    const real estimate = abm4(&r, quartic, NULL, NULL, v->corrections, v->evaluate_last);
    const real error = r.x[1] - h * h4 / R(5.0);
    const real want = R(19.0) * R(24.0) / R(720.0) * (h * h4);
    tap_ok(iso_abs(error - want) <= R(8.0) * ISO_REAL_EPSILON * want &&
               iso_abs(estimate - want) <= R(8.0) * ISO_REAL_EPSILON * want,
           v->quartic);
}

/* The newest derivative, that of the speed, stands in the last of either's sums, with the weights 9/16 and 1/16; in the
 * one before it is joined by the derivative -1 that was the newest: 37/16 derivative + 9/16, 5/16 derivative + 1/16. */
static void test_abm4_by_hand(const variant *const v)
{
    static const real derivatives[4 * N] = {R(0.0), R(-1.0), R(1.0), R(-2.0), R(2.0), R(4.0), R(3.0), R(0.0)};
    const real part = R(1.0) / R(16.0);
    run r;
    prepare(&r, ISO_ABM4_SUMS, R(1.0), R(0.0));
    memcpy(r.derivatives, derivatives, sizeof derivatives);
    take(&r, iso_abm4_take_derivative, 4);
    (void)abm4(&r, oscillator, NULL, NULL, v->corrections, v->evaluate_last);
    tap_ok(r.x[0] == v->position && r.x[1] == v->speed && r.past[3 * N + 1] == part * (R(9.0) * v->derivative) &&
               r.past[2 * N + 1] == part * (R(37.0) * v->derivative + R(9.0)) &&
               r.past[6 * N + 1] == part * v->derivative &&
               r.past[5 * N + 1] == part * (R(5.0) * v->derivative + R(1.0)) && r.past[ISO_ABM4_SUMS * N] == R(7.0),
           v->by_hand);
}

int main(void)
{
    test_walk_back();
    test_ab4_cubic();
    test_ab4_by_hand();
    test_inputs();
    for (size_t i = 0; i < sizeof variants / sizeof *variants; i++) {
        test_abm4_cubic(&variants[i]);
        test_abm4_quartic(&variants[i]);
        test_abm4_by_hand(&variants[i]);
    }
    tap_done();
}
