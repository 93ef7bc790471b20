/* The functions of core/numbers on every target: their exact values, and the bits of all results.
 * tests/core/numbers/exhaustive measures their errors, on the host.
 */
#include "core/numbers/angle.h"
#include "core/numbers/exp.h"
#include "core/numbers/log.h"
#include "core/numbers/noise.h"
#include "core/numbers/pieces.h"
#include "core/numbers/root.h"
#include "core/numbers/tanh.h"
#include "tests/tap.h"

static void test_exact(void)
{
    tap_same(iso_exp(R(0.0)), R(1.0), "exp(0)");
    tap_same(iso_log(R(1.0)), R(0.0), "log(1)");
    tap_same(iso_tanh(R(-0.0)), R(-0.0), "tanh(-0)");
    tap_same(iso_tanh(R(40.0)), R(1.0), "tanh(40)");
    tap_same(iso_atan2(R(-0.0), R(2.0)), R(-0.0), "atan2(-0, 2)");
    tap_same(iso_atan2(R(3.0), R(-0.0)), R(1.57079632679489662), "atan2(3, -0)");
    tap_same(iso_asin(R(-1.0)), R(-1.57079632679489662), "asin(-1)");
    tap_same(iso_acos(R(1.0)), R(0.0), "acos(1)");
    tap_same(iso_sqrt(R(2.25)), R(1.5), "sqrt(2.25)");
}

static void test_sign(void)
{
    const real denormal = iso_real_of(1);
    tap_same(iso_sign(denormal), R(1.0), "sign of the smallest denormal");
    tap_same(iso_sign(-denormal), R(-1.0), "sign of its negative");
    tap_same(iso_sign(R(0.0)), R(0.0), "sign(0)");
    tap_same(iso_sign(R(-0.0)), R(-0.0), "sign(-0)");
    tap_same(iso_sign(iso_real_of(ISO_SIGN_BIT | ISO_EXPONENT_BITS)), R(-1.0), "sign of -infinity");
}

static void test_floor(void)
{
    const real whole = R(1.0) / ISO_REAL_EPSILON; /* from here on every number is whole */
    const real infinite = iso_real_of(ISO_EXPONENT_BITS);
    tap_same(iso_floor(R(2.5)), R(2.0), "floor(2.5)");
    tap_same(iso_floor(R(3.5)), R(3.0), "floor(3.5)");
    tap_same(iso_floor(R(-2.5)), R(-3.0), "floor(-2.5)");
    tap_same(iso_floor(R(-3.0)), R(-3.0), "floor(-3)");
    tap_same(iso_floor(R(-0.0)), R(-0.0), "floor(-0)");
    tap_same(iso_floor(iso_real_of(1)), R(0.0), "floor of the smallest denormal");
    tap_same(iso_floor(-iso_real_of(1)), R(-1.0), "floor of its negative");
    tap_same(iso_floor(whole - R(0.5)), whole - R(1.0), "floor below the whole numbers");
    tap_same(iso_floor(R(0.5) - whole), -whole, "floor below their negatives");
    tap_same(iso_floor(whole + R(1.0)), whole + R(1.0), "floor of an odd whole number");
    tap_same(iso_floor(R(4.0) * whole), R(4.0) * whole, "floor of a large number");
    tap_same(iso_floor(infinite), infinite, "floor of infinity");
}

static void test_round(void)
{
    const real whole = R(1.0) / ISO_REAL_EPSILON, infinite = iso_real_of(ISO_EXPONENT_BITS);
    tap_same(iso_round(R(2.5)), R(2.0), "round(2.5)");
    tap_same(iso_round(R(3.5)), R(4.0), "round(3.5)");
    tap_same(iso_round(R(-2.75)), R(-3.0), "round(-2.75)");
    tap_same(iso_round(R(-0.5)), R(0.0), "round(-0.5)");
    tap_same(iso_round(whole / R(2.0) + R(0.5)), whole / R(2.0), "round of a half between large numbers");
    tap_same(iso_round(whole + R(1.0)), whole + R(1.0), "round of an odd whole number");
    tap_same(iso_round(-infinite), -infinite, "round of -infinity");
}

static void test_where(void)
{
    tap_same(iso_where(R(1.0), R(-2.5)), R(-2.5), "where 1");
    tap_same(iso_where(R(0.0), iso_real_of(ISO_EXPONENT_BITS)), R(0.0), "where 0, of an infinity");
    tap_same(iso_only(R(1.0), R(-2.5)), R(-2.5), "only where 1");
    tap_ok(iso_only(R(0.0), R(1.0)) != iso_only(R(0.0), R(1.0)), "only where 0: no number");
    tap_same(iso_unless(R(0.0), R(-2.5)), R(-2.5), "unless 0");
    tap_same(iso_unless(R(1.0), iso_real_of(ISO_EXPONENT_BITS)), R(0.0), "unless 1, of an infinity");
    tap_same(iso_above(R(0.0), R(-0.0)), R(0.0), "0 is not above -0");
    tap_same(iso_above(R(-0.0), R(0.0)), R(0.0), "-0 is not above 0");
    tap_same(iso_above(iso_real_of(1), R(0.0)), R(1.0), "the smallest denormal is above 0");
    tap_same(iso_above(R(0.0), -iso_real_of(1)), R(1.0), "0 is above its negative");
    tap_same(iso_above(R(2.0), R(2.0)), R(0.0), "2 is not above 2");
}

static void test_noise(void)
{
    const uint64_t tick = UINT64_C(123), later = tick + (UINT64_C(1) << 32);
    tap_ok(iso_bits_of(iso_noise(tick, 7)) != iso_bits_of(iso_noise(later, 7)), "2^32 ticks later it is another");
    tap_ok(iso_bits_of(iso_noise(tick, 7)) != iso_bits_of(iso_noise(tick, 8)), "of another seed it is another");
}

/* One number of all bits (FNV-1a over words). */
static uint64_t mixed(const uint64_t hash, const real x)
{
    return (hash ^ iso_bits_of(x)) * UINT64_C(0x100000001b3);
}

/* Equal on every target and at every optimisation. A change of an algorithm changes the number wanted here. */
static void test_bits(void)
{
#ifdef ISO_REAL_DOUBLE
    const uint64_t want = UINT64_C(0xad2bf39578a8d25a);
#else
    const uint64_t want = UINT64_C(0xd429e117bc9bb4bb);
#endif
    enum { NUMBERS = 400 };
    uint64_t hash = UINT64_C(0xcbf29ce484222325);
    real x = R(-1.0625), y = R(1e-3);
    for (int i = 0; i < NUMBERS; i++) {
        x = x * R(-0.9921875); /* 1 down to 0.05, of both signs */
        y = y * R(1.0703125);  /* up to 6e8 */
        hash = mixed(mixed(hash, iso_exp(x * R(64.0))), iso_log(y));
        hash = mixed(mixed(hash, iso_tanh(x * R(8.0))), iso_atan2(x, y - R(1.0)));
        hash = mixed(mixed(hash, iso_sqrt(y)), iso_floor(x * y) + iso_round(x));
        hash = mixed(hash, iso_inverse_root(y));
        hash = mixed(mixed(hash, iso_exp(y * x)), iso_noise((uint64_t)i * UINT64_C(10000000019), (uint32_t)i % 3));
    }
    tap_bits(hash, want, "the same bits on every target");
}

int main(void)
{
    test_exact();
    test_sign();
    test_floor();
    test_round();
    test_where();
    test_noise();
    test_bits();
    tap_done();
}
