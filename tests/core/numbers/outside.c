/* Functions outside of their domain, as the table of core/README.md says: each row of it, in float and in double. A NaN
 * has either sign here; no result says which sign one has. */
#include "core/numbers/angle.h"
#include "core/numbers/exp.h"
#include "core/numbers/log.h"
#include "core/numbers/pieces.h"
#include "core/numbers/power.h"
#include "core/numbers/root.h"
#include "core/numbers/sincos.h"
#include "core/numbers/sqrt.h"
#include "core/numbers/tanh.h"
#include "tests/tap.h"

/* An infinity, and quiet NaNs of both signs: of these the highest bit of the fraction is one. */
static real infinite, not_a_number[2];

static void set_numbers(void)
{
    const iso_bits quiet = ISO_EXPONENT_BITS | (iso_bits_of(R(1.5)) ^ iso_bits_of(R(1.0)));
    infinite = iso_real_of(ISO_EXPONENT_BITS);
    not_a_number[0] = iso_real_of(quiet);
    not_a_number[1] = iso_real_of(quiet | ISO_SIGN_BIT);
}

static bool is_nan(const real x)
{
    return (iso_bits_of(x) & ~ISO_SIGN_BIT) > ISO_EXPONENT_BITS;
}

static bool same(const real a, const real b)
{
    return iso_bits_of(a) == iso_bits_of(b);
}

typedef real function(real x);

static real sine(const real x)
{
    return iso_sincos(x).sin;
}

static real cosine(const real x)
{
    return iso_sincos(x).cos;
}

/* Of both NaNs, and of a number or two that have none. */
static bool all_nan(function *const f, const real first, const real second)
{
    return is_nan(f(not_a_number[0])) && is_nan(f(not_a_number[1])) && is_nan(f(first)) && is_nan(f(second));
}

static bool keeps_nan(function *const f)
{
    return all_nan(f, not_a_number[0], not_a_number[0]);
}

/* Of an infinity and of a NaN as of the largest number, with the sign. */
static bool saturates(function *const f, const real sign)
{
    return same(f(sign * infinite), f(sign * ISO_REAL_MAX)) &&
           same(f(not_a_number[sign < R(0.0)]), f(sign * ISO_REAL_MAX));
}

static void test_elementary(void)
{
    tap_ok(all_nan(sine, infinite, -infinite) && all_nan(cosine, infinite, -infinite),
           "sin and cos: NaN of an infinity and of a NaN");
    tap_ok(saturates(iso_exp, R(1.0)) && saturates(iso_exp, R(-1.0)) && same(iso_exp(R(1e4)), iso_exp(ISO_REAL_MAX)) &&
               same(iso_exp(R(-1e4)), iso_exp(-ISO_REAL_MAX)) && iso_exp(R(-1e4)) > R(0.0) &&
               iso_not_finite(iso_exp(infinite)) == 0,
           "exp: beyond its domain, of an infinity and of a NaN the value at the end, finite and above 0");
    tap_ok(saturates(iso_tanh, R(1.0)) && same(iso_tanh(infinite), R(1.0)) && saturates(iso_tanh, R(-1.0)) &&
               same(iso_tanh(-infinite), R(-1.0)),
           "tanh: of a NaN 1 with its sign");
}

/* The end of the range is 2 to the power of 1 + the largest exponent; a NaN counts as up to twice of that. */
static void test_logarithm(void)
{
    const real end = iso_log(ISO_REAL_MAX), twice = end + R(0.7),
               least = iso_log(iso_real_of(ISO_EXPONENT_BITS & ~(ISO_EXPONENT_BITS << 1)));
    tap_ok(same(iso_log(R(0.0)), least) && same(iso_log(-R(0.0)), least) && same(iso_log(iso_real_of(1)), least),
           "log: of zeros and of what is below its domain the value at its end");
    tap_ok(is_nan(iso_log(R(-1.0))) && is_nan(iso_log(-infinite)) && is_nan(iso_log(-iso_real_of(1))),
           "log: NaN of what is below 0");
    tap_ok(iso_log(infinite) >= end && iso_log(infinite) <= end + R(1e-4),
           "log: of an infinity that of the largest number");
    tap_ok(iso_log(not_a_number[0]) >= end && iso_log(not_a_number[0]) <= twice && is_nan(iso_log(not_a_number[1])),
           "log: of a NaN up to 0.7 more, or NaN, by its sign");
}

static void test_power(void)
{
    tap_ok(same(iso_power(R(0.0), R(0.7)), R(0.0)) && same(iso_power(R(0.0), R(-0.7)), infinite) &&
               same(iso_power(R(1e30), R(40.0)), infinite) && same(iso_power(R(1e30), R(-40.0)), R(0.0)),
           "power: 0 or an infinity of 0 and beyond the domain of exp");
    tap_ok(is_nan(iso_power(R(-2.0), R(0.7))) && is_nan(iso_power(R(0.0), R(0.0))) &&
               is_nan(iso_power(infinite, R(0.7))) && is_nan(iso_power(not_a_number[0], R(0.7))) &&
               is_nan(iso_power(not_a_number[1], R(0.7))) && is_nan(iso_power(R(2.0), not_a_number[0])),
           "power: NaN below 0, of 0 to the power 0, of an infinity and of a NaN");
}

static void test_angles(void)
{
    const real pi = iso_atan2(R(0.0), R(-1.0)), over = R(1.0) + ISO_REAL_EPSILON;
    bool nan = true;
    for (int i = 0; i < 2; i++) {
        const real bad = not_a_number[i];
        nan = nan && is_nan(iso_atan2(bad, R(1.0))) && is_nan(iso_atan2(R(1.0), bad)) && is_nan(iso_atan2(bad, bad)) &&
              is_nan(iso_atan2(bad, R(0.0))) && is_nan(iso_atan2(R(0.0), bad));
    }
    tap_ok(nan, "atan2: NaN of a NaN");
    tap_ok(is_nan(iso_atan2(infinite, infinite)) && is_nan(iso_atan2(-infinite, infinite)) &&
               is_nan(iso_atan2(infinite, -infinite)) && is_nan(iso_atan2(-infinite, -infinite)),
           "atan2: NaN of two infinities");
    tap_ok(same(iso_atan2(R(0.0), R(0.0)), R(0.0)) && same(iso_atan2(-R(0.0), R(0.0)), -R(0.0)) &&
               same(iso_atan2(R(0.0), -R(0.0)), pi) && same(iso_atan2(-R(0.0), -R(0.0)), -pi),
           "atan2: of two zeros 0, or pi where x is -0, with the sign of y");
    tap_ok(all_nan(iso_asin, over, -over) && all_nan(iso_asin, infinite, -infinite), "asin: NaN beyond 1");
    tap_ok(all_nan(iso_acos, over, -over) && all_nan(iso_acos, infinite, -infinite), "acos: NaN beyond 1");
}

static void test_roots(void)
{
    tap_ok(all_nan(iso_sqrt, R(-1.0), -infinite) && same(iso_sqrt(-R(0.0)), -R(0.0)) &&
               same(iso_sqrt(infinite), infinite),
           "sqrt: NaN below 0 and of a NaN, -0 of -0");
    tap_ok(all_nan(iso_inverse_root, R(-1.0), -infinite) && iso_not_finite(iso_inverse_root(R(0.0))) == 0 &&
               same(iso_inverse_root(infinite), R(0.0)),
           "1 / sqrt: finite at 0; 0 of an infinity; NaN below 0 and of a NaN");
}

static void test_pieces(void)
{
    const real whole = R(3.0) / ISO_REAL_EPSILON;
    tap_ok(keeps_nan(iso_floor) && same(iso_floor(infinite), infinite) && same(iso_floor(-infinite), -infinite) &&
               same(iso_floor(whole), whole) && same(iso_floor(-ISO_REAL_MAX), -ISO_REAL_MAX),
           "floor: an infinity and a NaN stay, and numbers that are all whole");
    tap_ok(keeps_nan(iso_round) && same(iso_round(infinite), infinite) && same(iso_round(-infinite), -infinite) &&
               same(iso_round(whole), whole) && same(iso_round(-ISO_REAL_MAX), -ISO_REAL_MAX),
           "round: likewise");
    tap_ok(same(iso_sign(not_a_number[0]), R(1.0)) && same(iso_sign(not_a_number[1]), R(-1.0)),
           "sign: of a NaN 1 with its sign");
    tap_ok(keeps_nan(iso_abs), "abs: NaN of a NaN");
    tap_ok(is_nan(iso_positive(not_a_number[0])) && same(iso_positive(not_a_number[1]), R(0.0)),
           "max(x, 0): a NaN, or 0, by its sign");
    tap_ok(same(iso_negative(not_a_number[0]), R(0.0)) && is_nan(iso_negative(not_a_number[1])),
           "min(x, 0): 0, or a NaN, by its sign");
}

static bool is_either(const real x, const real other)
{
    return is_nan(x) || same(x, other);
}

static bool is_bit(const real x)
{
    return same(x, R(0.0)) || same(x, R(1.0));
}

static void test_choices(void)
{
    bool either = true, clamped = true, bit = true, chosen = true;
    for (int i = 0; i < 2; i++) {
        const real bad = not_a_number[i], sign = i == 0 ? R(1.0) : R(-1.0);
        const real kept = iso_clamp(bad, R(2.0), R(3.0));
        either = either && is_either(iso_min(bad, R(2.0)), R(2.0)) && is_either(iso_min(R(2.0), bad), R(2.0)) &&
                 is_either(iso_max(bad, R(2.0)), R(2.0)) && is_either(iso_max(R(2.0), bad), R(2.0));
        clamped = clamped && (is_nan(kept) || same(kept, R(2.0)) || same(kept, R(3.0)));
        bit = bit && is_bit(iso_above(bad, R(2.0))) && is_bit(iso_above(R(2.0), bad)) && is_bit(iso_above(bad, bad)) &&
              is_bit(iso_above(sign * infinite, sign * infinite));
        const real which = iso_where(bad, R(2.0)) + iso_unless(bad, R(3.0));
        chosen = chosen && (same(which, R(2.0)) || same(which, R(3.0)));
    }
    tap_ok(either, "min, max: of a NaN it or the other number");
    tap_ok(clamped, "clamp: of a NaN it or a limit");
    tap_ok(bit, "comparison: of a NaN, or of an infinity with itself, 0 or 1");
    tap_ok(chosen, "if: a condition that is a NaN holds or does not");
}

int main(void)
{
    set_numbers();
    tap_ok(is_nan(not_a_number[0]) && is_nan(not_a_number[1]) && !is_nan(infinite) && !is_nan(R(1.0)) &&
               !is_nan(ISO_REAL_MAX),
           "control: what is a NaN, and what is none");
    tap_ok(!saturates(iso_abs, R(1.0)) && !keeps_nan(iso_exp), "control: another function is noticed");
    test_elementary();
    test_logarithm();
    test_power();
    test_angles();
    test_roots();
    test_pieces();
    test_choices();
    tap_done();
}
