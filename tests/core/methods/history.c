/* core/methods/history.h: advancing the state with and without compensation, sums of derivatives, checking a step. */
#include "core/methods/history.h"
#include "tests/tap.h"

/* The first real whose successor is two away: 2^24 in float, 2^53 in double. */
static const real big = R(2.0) / ISO_REAL_EPSILON;

static void test_advance(void)
{
    real x[2] = {R(1.0), R(2.0)}, check[2] = {R(3.0), R(4.0)};
    const iso_history plain = {.n = 2, .x = x};
    const iso_history watched = {.n = 2, .x = x, .check = check, .checked = 1};
    iso_advance(&plain, 1, R(0.5));
    tap_ok(x[0] == R(1.0) && x[1] == R(2.5) && check[1] == R(4.0), "advance: the state that is named");
    iso_advance(&watched, 1, R(0.25));
    tap_ok(x[1] == R(2.75) && check[1] == R(-3.75) && check[0] == R(3.0),
           "advance: for a check the sum of the derivatives is taken from the increment");
}

/* x and compensation after x + dx: what rounding takes from the sum is all in the compensation. */
static void split(const real from, const real dx, const real sum, const real rest, const char *const name)
{
    real x = from, compensation = R(0.0);
    const iso_history history = {.n = 1, .x = &x, .compensation = &compensation};
    iso_advance(&history, 0, dx);
    tap_ok(x == sum && compensation == rest, name);
}

static void test_compensated(void)
{
    split(R(1.0), R(2.0), R(3.0), R(0.0), "compensated: nothing is left of an exact sum");
    split(big, R(1.0), big, R(1.0), "compensated: an increment below the ulp is carried");
    split(big, R(3.0), big + R(4.0), R(-1.0), "compensated: so is a rest that rounding added");
    split(R(3.0), big, big + R(4.0), R(-1.0), "compensated: and one of the state, below a large increment");
    split(-big, R(-3.0), -big - R(4.0), R(1.0), "compensated: with the other sign");
    split(big, -big, R(0.0), R(0.0), "compensated: cancellation is exact");

    real x = big, compensation = R(0.0);
    const iso_history history = {.n = 1, .x = &x, .compensation = &compensation};
    iso_advance(&history, 0, R(1.0));
    iso_advance(&history, 0, R(1.0));
    tap_ok(x == big + R(2.0) && compensation == R(0.0), "compensated: what was carried goes into the next step");
}

/* 2^20 increments, each too small to move 1 alone: an eighth of its ulp (exact in every step, so that the sum is, too),
 * and one of many digits, 1e-8 in float. */
enum { MANY = 1 << 20 };

static void add_many(const iso_history *const history, const real dx)
{
    for (uint32_t i = 0; i < MANY; i++) {
        iso_advance(history, 0, dx);
    }
}

static void test_many(void)
{
    const real eighth = ISO_REAL_EPSILON / R(8.0);
    real x = R(1.0), compensation = R(0.0);
    const iso_history plain = {.n = 1, .x = &x};
    const iso_history compensated = {.n = 1, .x = &x, .compensation = &compensation};
    add_many(&plain, eighth);
    tap_same(x, R(1.0), "a million small increments are lost without compensation");
    add_many(&compensated, eighth);
    tap_same(x, R(1.0) + (real)(MANY / 8) * ISO_REAL_EPSILON, "compensated: a million small increments are all there");
    tap_same(compensation, R(0.0), "compensated: and nothing is left");

    /* A compensation is at most an epsilon here, and its own rounding half an epsilon of that: a million times, below
     * an eighth of an epsilon. The result and what it is compared with are rounded once each. */
    const real small = R(0.0838861) * ISO_REAL_EPSILON;
    x = R(1.0);
    compensation = R(0.0);
    add_many(&compensated, small);
    tap_ok(iso_abs(x - (R(1.0) + (real)MANY * small)) <= ISO_REAL_EPSILON,
           "compensated: a million times one of many digits, to an ulp");
}

/* With h = 45/16 the denominators 2, 12, 24, 720 and 1440 divide it in binary. */
static const real h = R(2.8125);

/* The implicit formula of order four without its first weight, h / 24 (19, -5, 1), over derivatives 2, 3, 5, the newest
 * last, of one state, and their negatives of the other. What the sums were before must not show. */
static void test_take_derivative(void)
{
    static const real derivatives[3][2] = {{R(2.0), R(-2.0)}, {R(3.0), R(-3.0)}, {R(5.0), R(-5.0)}};
    const real part = h / R(24.0);
    real sums[7] = {R(11.0), R(12.0), R(13.0), R(14.0), R(15.0), R(16.0), R(9.0)};
    for (int i = 0; i < 3; i++) {
        iso_take_derivative(&iso_table_am[3], 1, 3, h, 2, derivatives[i], sums);
    }
    tap_same(sums[0], part * (R(19.0) * R(5.0) - R(5.0) * R(3.0) + R(2.0)), "sums: first that of all derivatives");
    tap_same(sums[2], part * (R(5.0) * R(5.0) - R(3.0)), "sums: then what the next derivative is added to");
    tap_same(sums[4], part * R(5.0), "sums: and what the one after it");
    tap_ok(sums[1] == -sums[0] && sums[3] == -sums[2] && sums[5] == -sums[4], "sums: of every state");
    iso_take_derivative(&iso_table_am[3], 1, 0, h, 2, derivatives[0], sums + 6);
    tap_same(sums[6], R(9.0), "sums: nothing beyond, and nothing where none are kept");
}

static real power_of(const int t, const unsigned m)
{
    real power = R(1.0);
    for (unsigned i = 0; i < m; i++) {
        power *= (real)t;
    }
    return power;
}

/* What a check with so many derivatives from before the end of the step says to an increment of h (1 + wrong), true but
 * for `wrong` where the derivative is (degree + 1) t^degree from t = 0 to 1, in units of h. A second state stands
 * still. */
static real check(const uint8_t checked, const unsigned degree, const real wrong, real *const error)
{
    real x[2] = {R(0.0), R(0.0)}, kept[2 * ISO_ADAMS_DERIVATIVES] = {R(0.0)};
    const iso_history history = {.n = 2, .x = x, .check = kept, .checked = checked};
    for (int past = checked; past-- > 0;) {
        const real derivative[2] = {(real)(degree + 1) * power_of(-past, degree), R(0.0)};
        iso_keep_derivative(&history, h, derivative);
    }
    iso_advance(&history, 0, h + h * wrong);
    iso_advance(&history, 1, R(0.0));
    const real derivative[2] = {(real)(degree + 1), R(0.0)};
    return iso_check(&history, h, derivative, error);
}

static void test_check(const uint8_t checked, const char *const exact, const char *const wrong)
{
    real error[2] = {R(9.0), R(9.0)};
    bool zero = true;
    for (unsigned degree = 0; degree <= checked; degree++) {
        zero = zero && check(checked, degree, R(0.0), NULL) == R(0.0);
    }
    tap_ok(zero && check(checked, checked + 1U, R(0.0), NULL) > R(0.0), exact);
    tap_ok(check(checked, checked, R(0.125), error) == R(0.125) * h && error[0] == R(0.125) * h && error[1] == R(0.0) &&
               check(checked, checked, R(-0.125), error) == R(0.125) * h && error[0] == R(-0.125) * h,
           wrong);
}

/* What a centred check says of steps of 1 from t = -3 to 0, where the derivative is (degree + 1) t^degree; the
 * increment of one of the steps is wrong by 1. The last step moved in two parts. */
static real centred(const unsigned degree, const int wrong)
{
    real x[1] = {R(0.0)}, kept[ISO_CENTRED_KEPT] = {R(0.0)};
    const iso_history history = {.n = 1, .x = x, .check = kept, .checked = ISO_CENTRED_KEPT, .centred = true};
    for (int t = -3; t < 0; t++) {
        const real derivative[1] = {(real)(degree + 1) * power_of(t, degree)};
        const real dx = power_of(t + 1, degree + 1) - power_of(t, degree + 1) + (t == wrong ? R(1.0) : R(0.0));
        iso_keep_derivative(&history, R(1.0), derivative);
        iso_advance(&history, 0, dx - R(4.0));
        iso_check_moved(&history, 0, R(4.0));
    }
    const real derivative[1] = {degree == 0 ? R(1.0) : R(0.0)};
    return iso_check(&history, R(1.0), derivative, NULL);
}

/* Sums of up to 3^6, rounded at a dozen places. */
static void test_centred(void)
{
    const real tolerance = R(12.0) * R(729.0) * ISO_REAL_EPSILON;
    bool zero = true;
    for (unsigned degree = 0; degree <= 5; degree++) {
        zero = zero && centred(degree, 1) <= tolerance;
    }
    tap_ok(zero, "centred check: exact for degree 5");
    /* t^7 has the seventh derivative 7!. */
    tap_ok(iso_abs(centred(6, 1) - R(1.8)) <= R(3.0) * tolerance, "centred check: not for degree 6, 7! / 2800");
    tap_ok(iso_abs(centred(0, -1) - R(11.0) / R(60.0)) <= tolerance &&
               iso_abs(centred(0, -2) - R(38.0) / R(60.0)) <= tolerance &&
               iso_abs(centred(0, -3) - R(11.0) / R(60.0)) <= tolerance,
           "centred check: the mean of three steps, most of the middle one");
}

int main(void)
{
    test_advance();
    test_compensated();
    test_many();
    test_take_derivative();
    test_check(1, "check with 1 derivative: exact for degree 1, not 2",
               "check with 1 derivative: an increment wrong by h/8");
    test_check(2, "check with 2 derivatives: exact for degree 2, not 3",
               "check with 2 derivatives: an increment wrong by h/8");
    test_check(3, "check with 3 derivatives: exact for degree 3, not 4",
               "check with 3 derivatives: an increment wrong by h/8");
    test_check(4, "check with 4 derivatives: exact for degree 4, not 5",
               "check with 4 derivatives: an increment wrong by h/8");
    test_check(5, "check with 5 derivatives: exact for degree 5, not 6",
               "check with 5 derivatives: an increment wrong by h/8");
    test_centred();
    const iso_history unchecked = {.n = 1};
    tap_same(iso_check(&unchecked, h, NULL, NULL), R(0.0), "no check: no error");
    tap_done();
}
