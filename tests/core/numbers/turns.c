/* core/numbers/turns.h: whole turns are taken off an angle and counted; what is left points the same way. */
#include "core/numbers/turns.h"
#include "tests/tap.h"

static const real two_pi = R(6.28318530717958648);
static const real pi = R(3.14159265358979324);

static void test_known(void)
{
    real angle = R(0.0), rest = R(0.0);
    tap_ok(iso_take_turns(&angle, &rest) == 0 && angle == R(0.0), "no angle: no turn");
    angle = R(3.0);
    tap_ok(iso_take_turns(&angle, &rest) == 0, "3 rad: no turn");
    tap_same(angle, R(3.0), "3 rad stays as it is");
    angle = R(-3.0);
    tap_ok(iso_take_turns(&angle, &rest) == 0, "-3 rad: no turn");
    tap_same(angle, R(-3.0), "-3 rad stays as it is");
    angle = R(4.0);
    tap_ok(iso_take_turns(&angle, &rest) == 1 && angle < R(-2.0), "4 rad: one turn, and a negative angle");
    angle = R(-4.0);
    tap_ok(iso_take_turns(&angle, &rest) == -1 && angle > R(2.0), "-4 rad: a turn back, and a positive angle");
    angle = R(1e4);
    tap_ok(iso_take_turns(&angle, &rest) == 1592, "1e4 rad: 1592 turns");
    angle = R(-1e4);
    tap_ok(iso_take_turns(&angle, &rest) == -1592, "-1e4 rad: -1592 turns");
    tap_same(iso_within_turn(R(-1e4)), angle, "and the same angle alone");
}

/* Angles across the domain: the sine and cosine before and after differ by the errors of two calls, 1.5 ulp of 1.0
 * each, and by the rounding of what is left, at most 1 ulp of 1.0 (half an ulp of pi). The whole number of turns is
 * that of x times a rounded constant, rounded: half a turn is missed by at most x epsilon. */
static void test_direction(void)
{
    const real tolerance = R(4.0) * ISO_REAL_EPSILON;
    uint32_t turned = 0, outside = 0, miscounted = 0, unlike = 0;
    for (int32_t i = -20000; i <= 20000; i++) {
        const real x = (real)i * R(0.49951171875);
        real angle = x, rest = R(0.0);
        const real turns = (real)iso_take_turns(&angle, &rest);
        real alone = x;
        unlike += (real)iso_take_whole_turns(&alone) != turns || iso_abs(alone - angle) > tolerance;
        const iso_sine_cosine before = iso_sincos(x);
        const iso_sine_cosine after = iso_sincos(angle);
        turned += iso_abs(before.sin - after.sin) > tolerance || iso_abs(before.cos - after.cos) > tolerance;
        outside += iso_abs(angle) > pi + (iso_abs(x) + R(4.0)) * ISO_REAL_EPSILON;
        miscounted += iso_abs(turns * two_pi + angle - x) > R(1e4) * R(2.0) * ISO_REAL_EPSILON;
    }
    tap_count(turned, 0, "what is left points the same way");
    tap_count(outside, 0, "what is left is within pi, to rounding");
    tap_count(miscounted, 0, "turns and what is left add up to the angle");
    tap_count(unlike, 0, "without a rest the turns are the same, and what is left, to rounding");
}

/* Around the largest and the least count; signed overflow, which C leaves undefined, is one that the sanitizer finds.
 */
static void test_count(void)
{
    int32_t count = INT32_MAX - 1;
    for (int i = 0; i < 4; i++) {
        real angle = R(4.0), rest = R(0.0);
        count = iso_counted_turns(count, iso_take_turns(&angle, &rest));
    }
    tap_ok(count == INT32_MIN + 2, "behind the largest count comes the least");
    tap_ok((int32_t)((uint32_t)count - (uint32_t)(INT32_MAX - 1)) == 4, "so the difference of two counts is right");
    for (int i = 0; i < 4; i++) {
        real angle = R(-4.0), rest = R(0.0);
        count = iso_counted_turns(count, iso_take_turns(&angle, &rest));
    }
    tap_ok(count == INT32_MAX - 1, "and back");
}

/* The end of a tick of h + h_rest seconds. */
typedef struct turned {
    real angle, rest;
} turned;

static turned turn(const real angle, const iso_turning before, const real speed, const real h, const real h_rest)
{
    turned made = {.angle = angle, .rest = R(0.0)};
    iso_turn(&made.angle, &made.rest, before, speed, h, h_rest);
    return made;
}

/* Numbers of which every sum and product is known: e is the distance from 1 to the next. */
static void test_turn(void)
{
    const real e = ISO_REAL_EPSILON, h = R(0.5), h_rest = R(0.25);
    const iso_turning slow = {.angle = R(1.0), .speed = R(1.5) * e}, fast = {.angle = R(1.0), .speed = R(1.0)};
    turned at = turn(R(1.0) + e, slow, slow.speed, h, h_rest);
    tap_same(at.angle, R(1.0) + e, "steady: 1 + 0.75 e is 1 + e");
    tap_same(at.rest, R(0.125) * e, "steady: the rest has what is too much of it, and the way in h_rest");
    at = turn(R(1.5) + R(8.0) * e, fast, fast.speed, h, R(0.0));
    tap_same(at.angle, R(1.5), "steady: the way is the product, where the method is off by rounding");
    at = turn(R(1.5), fast, R(1.0) + R(4.0) * e, h, h_rest);
    tap_same(at.angle, R(1.5), "steady but for rounding: the way is that of the speed before");
    tap_same(at.rest, R(0.25) + e, "steady but for rounding: half of the change is in the rest");
    at = turn(R(1.5), fast, R(1.0) + R(16.0) * e, h, h_rest);
    tap_same(at.rest, R(0.25), "another speed: the way of the method, which lacks that in h_rest");
    at = turn(R(1.75), fast, fast.speed, h, h_rest);
    tap_same(at.angle, R(1.75), "another way: that of the method");
    tap_same(at.rest, R(0.25), "another way: nothing but h_rest is lacking");
    at = turn(R(1.5) + R(16.0) * e, fast, fast.speed, h, R(0.0));
    tap_same(at.angle, R(1.5) + R(16.0) * e, "another way: just beyond rounding");
}

int main(void)
{
    test_known();
    test_turn();
    test_count();
    test_direction();
    tap_done();
}
