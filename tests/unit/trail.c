/* core/trail.h: advancing the state with and without compensation, keeping slopes, checking a step. */
#include "core/trail.h"
#include "tests/tap.h"

/* The first real whose successor is two away: 2^24 in float, 2^53 in double. */
static const real big = R(2.0) / ISO_REAL_EPSILON;

static void test_advance(void)
{
    real x[2] = {R(1.0), R(2.0)}, moved[2] = {R(0.0), R(0.0)};
    const iso_trail plain = {.n = 2, .x = x};
    const iso_trail watched = {.n = 2, .x = x, .moved = moved};
    iso_advance(&plain, 1, R(0.5));
    tap_ok(x[0] == R(1.0) && x[1] == R(2.5) && moved[1] == R(0.0), "advance: the state that is named");
    iso_advance(&watched, 1, R(0.25));
    tap_ok(x[1] == R(2.75) && moved[1] == R(0.25) && moved[0] == R(0.0), "advance: the increment is kept for a check");
}

/* x and carry after x + dx: what rounding takes from the sum is all in the carry. */
static void split(const real from, const real dx, const real sum, const real rest, const char *const name)
{
    real x = from, carry = R(0.0);
    const iso_trail trail = {.n = 1, .x = &x, .carry = &carry};
    iso_advance(&trail, 0, dx);
    tap_ok(x == sum && carry == rest, name);
}

static void test_compensated(void)
{
    split(R(1.0), R(2.0), R(3.0), R(0.0), "compensated: nothing is left of an exact sum");
    split(big, R(1.0), big, R(1.0), "compensated: an increment below the ulp is carried");
    split(big, R(3.0), big + R(4.0), R(-1.0), "compensated: so is a rest that rounding added");
    split(R(3.0), big, big + R(4.0), R(-1.0), "compensated: and one of the state, below a large increment");
    split(-big, R(-3.0), -big - R(4.0), R(1.0), "compensated: with the other sign");
    split(big, -big, R(0.0), R(0.0), "compensated: cancellation is exact");

    real x = big, carry = R(0.0);
    const iso_trail trail = {.n = 1, .x = &x, .carry = &carry};
    iso_advance(&trail, 0, R(1.0));
    iso_advance(&trail, 0, R(1.0));
    tap_ok(x == big + R(2.0) && carry == R(0.0), "compensated: what was carried goes into the next step");
}

/* 2^20 increments, each too small to move 1 alone: an eighth of its ulp (exact in every step, so that the sum is, too),
 * and one of many digits, 1e-8 in float. */
enum { MANY = 1 << 20 };

static void add_many(const iso_trail *const trail, const real dx)
{
    for (uint32_t i = 0; i < MANY; i++) {
        iso_advance(trail, 0, dx);
    }
}

static void test_many(void)
{
    const real eighth = ISO_REAL_EPSILON / R(8.0);
    real x = R(1.0), carry = R(0.0);
    const iso_trail plain = {.n = 1, .x = &x};
    const iso_trail compensated = {.n = 1, .x = &x, .carry = &carry};
    add_many(&plain, eighth);
    tap_same(x, R(1.0), "a million small increments are lost without compensation");
    add_many(&compensated, eighth);
    tap_same(x, R(1.0) + (real)(MANY / 8) * ISO_REAL_EPSILON, "compensated: a million small increments are all there");
    tap_same(carry, R(0.0), "compensated: and nothing is left");

    /* A carry is at most an epsilon here, and its own rounding half an epsilon of that: a million times, below an eighth
     * of an epsilon. The result and what it is compared with are rounded once each. */
    const real small = R(0.0838861) * ISO_REAL_EPSILON;
    x = R(1.0);
    carry = R(0.0);
    add_many(&compensated, small);
    tap_ok(iso_abs(x - (R(1.0) + (real)MANY * small)) <= ISO_REAL_EPSILON,
           "compensated: a million times one of many digits, to an ulp");
}

static void test_keep(void)
{
    real x[2] = {R(0.0), R(0.0)};
    real slopes[7] = {R(1.0), R(2.0), R(3.0), R(4.0), R(5.0), R(6.0), R(9.0)};
    const real slope[2] = {R(7.0), R(8.0)};
    const iso_trail trail = {.n = 2, .x = x, .slopes = slopes, .kept = 3};
    const iso_trail none = {.n = 2, .x = x, .slopes = slopes, .kept = 0};
    iso_keep_slope(&trail, slope);
    tap_ok(slopes[0] == R(7.0) && slopes[1] == R(8.0), "keep: the newest stands first");
    tap_ok(slopes[2] == R(1.0) && slopes[3] == R(2.0) && slopes[4] == R(3.0) && slopes[5] == R(4.0),
           "keep: the others move on, the oldest goes");
    tap_same(slopes[6], R(9.0), "keep: nothing beyond");
    iso_keep_slope(&none, slope + 1);
    tap_same(slopes[0], R(7.0), "keep: nothing where none are kept");
}

static real power_of(const int t, const unsigned m)
{
    real power = R(1.0);
    for (unsigned i = 0; i < m; i++) {
        power *= (real)t;
    }
    return power;
}

/* With h = 45/16 the denominators 2, 12, 24 and 720 divide it in binary. */
static const real h = R(2.8125);

/* What a check of a method of this order says to an increment of h (1 + wrong), true but for `wrong` where the slope is
 * (degree + 1) t^degree from t = 0 to 1, in units of h. A second state stands still. */
static real check(const uint8_t order, const unsigned degree, const real wrong, real *const error)
{
    real x[2] = {R(0.0), R(0.0)}, moved[2] = {h + h * wrong, R(0.0)};
    real slopes[8] = {R(0.0)};
    const real slope[2] = {(real)(degree + 1), R(0.0)};
    for (int j = 0; j < 4; j++) {
        slopes[2 * j] = (real)(degree + 1) * power_of(-j, degree);
    }
    const iso_trail trail = {.n = 2, .x = x, .slopes = slopes, .moved = moved, .kept = order, .order = order};
    return iso_check(&trail, h, slope, error);
}

static void test_check(const uint8_t order, const char *const exact, const char *const wrong)
{
    real error[2] = {R(9.0), R(9.0)};
    bool zero = true;
    for (unsigned degree = 0; degree <= order; degree++) {
        zero = zero && check(order, degree, R(0.0), NULL) == R(0.0);
    }
    tap_ok(zero && check(order, order + 1U, R(0.0), NULL) > R(0.0), exact);
    tap_ok(check(order, order, R(0.125), error) == R(0.125) * h && error[0] == R(0.125) * h && error[1] == R(0.0) &&
               check(order, order, R(-0.125), error) == R(0.125) * h && error[0] == R(-0.125) * h,
           wrong);
}

int main(void)
{
    test_advance();
    test_compensated();
    test_many();
    test_keep();
    test_check(1, "check of order 1: exact for degree 1, not 2", "check of order 1: an increment wrong by h/8");
    test_check(2, "check of order 2: exact for degree 2, not 3", "check of order 2: an increment wrong by h/8");
    test_check(3, "check of order 3: exact for degree 3, not 4", "check of order 3: an increment wrong by h/8");
    test_check(4, "check of order 4: exact for degree 4, not 5", "check of order 4: an increment wrong by h/8");
    const iso_trail unchecked = {.n = 1};
    tap_same(iso_check(&unchecked, h, NULL, NULL), R(0.0), "no check: no error");
    tap_done();
}
