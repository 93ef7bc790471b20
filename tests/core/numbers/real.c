/* core/numbers/real.h: comparison, selection and classification by bits, over all pairs of a list of awkward numbers.
 */
#include "core/numbers/real.h"
#include "tests/tap.h"

#ifdef ISO_REAL_DOUBLE
#define SMALLEST_NORMAL DBL_MIN
#define LARGEST DBL_MAX
#else
#define SMALLEST_NORMAL FLT_MIN
#define LARGEST FLT_MAX
#endif

/* Finite numbers in ascending order, -0 before 0; from bits where a literal could be flushed or rounded. */
enum { FINITE = 20, ZERO = FINITE / 2 };
static real finite[FINITE];

static real infinity(void)
{
    return iso_real_of(ISO_EXPONENT_BITS);
}

static real next_above(const real x)
{
    return iso_real_of(iso_bits_of(x) + 1);
}

static real next_below(const real x)
{
    return iso_real_of(iso_bits_of(x) - 1);
}

static void fill(void)
{
    const real smallest = iso_real_of(1); /* denormal */
    const real positive[] = {smallest,
                             iso_real_of(2),
                             next_below(SMALLEST_NORMAL),
                             SMALLEST_NORMAL,
                             next_below(R(1.0)),
                             R(1.0),
                             next_above(R(1.0)),
                             R(1e4),
                             LARGEST};
    for (unsigned i = 0; i < sizeof positive / sizeof positive[0]; i++) {
        finite[ZERO + 1 + i] = positive[i];
        finite[ZERO - 2 - i] = -positive[i];
    }
    finite[ZERO - 1] = R(-0.0);
    finite[ZERO] = R(0.0);
}

/* Pairs of the list on which a function disagrees with the order of the list. */
static uint32_t wrong_less(void)
{
    uint32_t wrong = 0;
    for (unsigned i = 0; i < FINITE; i++) {
        for (unsigned j = 0; j < FINITE; j++) {
            const iso_bits want = i < j ? ~(iso_bits)0 : 0;
            wrong += iso_less(finite[i], finite[j]) != want;
            const bool zeros = finite[i] == R(0.0) && finite[j] == R(0.0); /* which are equal */
            wrong += iso_bits_of(iso_above(finite[j], finite[i])) != (zeros ? 0 : want & iso_bits_of(R(1.0)));
        }
    }
    return wrong;
}

static uint32_t wrong_min_max(void)
{
    uint32_t wrong = 0;
    for (unsigned i = 0; i < FINITE; i++) {
        for (unsigned j = 0; j < FINITE; j++) {
            const real low = finite[i < j ? i : j];
            const real high = finite[i < j ? j : i];
            wrong += iso_bits_of(iso_min(finite[i], finite[j])) != iso_bits_of(low);
            wrong += iso_bits_of(iso_max(finite[i], finite[j])) != iso_bits_of(high);
        }
    }
    return wrong;
}

static uint32_t wrong_clamp(void)
{
    uint32_t wrong = 0;
    for (unsigned low = 0; low < FINITE; low++) {
        for (unsigned high = low; high < FINITE; high++) {
            for (unsigned i = 0; i < FINITE; i++) {
                const unsigned want = i < low ? low : i > high ? high : i;
                const real got = iso_clamp(finite[i], finite[low], finite[high]);
                wrong += iso_bits_of(got) != iso_bits_of(finite[want]);
            }
        }
    }
    return wrong;
}

static uint32_t wrong_abs(void)
{
    uint32_t wrong = 0;
    for (unsigned i = 0; i < FINITE; i++) {
        const real want = finite[i < ZERO ? FINITE - 1 - i : i];
        wrong += iso_bits_of(iso_abs(finite[i])) != iso_bits_of(want);
    }
    return wrong;
}

static uint32_t wrong_finite(void)
{
    uint32_t wrong = 0;
    for (unsigned i = 0; i < FINITE; i++) {
        wrong += iso_not_finite(finite[i]) != 0;
    }
    return wrong;
}

static void test_lists(void)
{
    tap_count(wrong_less(), 0, "less: every pair of finite numbers");
    tap_count(wrong_min_max(), 0, "min and max: every pair of finite numbers");
    tap_count(wrong_clamp(), 0, "clamp: every number in every interval");
    tap_count(wrong_abs(), 0, "abs: every finite number");
    tap_count(wrong_finite(), 0, "not_finite: no finite number");

    const real kept = finite[3];
    finite[3] = finite[4];
    tap_ok(wrong_less() > 0 && wrong_clamp() == 0, "the comparison of lists notices two equal numbers");
    finite[3] = kept;
    finite[0] = infinity();
    tap_count(wrong_finite(), 1, "the comparison of lists notices an infinity");
}

static void test_zeros(void)
{
    tap_ok(iso_bits_of(R(-0.0)) == ISO_SIGN_BIT, "bits_of: -0 is the sign bit");
    tap_bits(iso_less(R(-0.0), R(0.0)), ~(iso_bits)0, "less: -0 is below 0");
    tap_same(iso_min(R(0.0), R(-0.0)), R(-0.0), "min of the zeros is -0");
    tap_same(iso_max(R(-0.0), R(0.0)), R(0.0), "max of the zeros is 0");
    tap_same(iso_abs(R(-0.0)), R(0.0), "abs: -0 gives 0");
    tap_same(iso_positive(R(-0.0)), R(0.0), "positive: -0 gives 0");
    tap_same(iso_positive(-SMALLEST_NORMAL), R(0.0), "positive: what is below 0 gives 0");
    tap_same(iso_positive(iso_real_of(1)), iso_real_of(1), "positive: the smallest denormal is itself");
    tap_same(iso_negative(R(0.0)), R(0.0), "negative: 0 gives 0");
    tap_same(iso_negative(R(-0.0)), R(-0.0), "negative: -0 is itself");
    tap_same(iso_negative(SMALLEST_NORMAL), R(0.0), "negative: what is above 0 gives 0");
    tap_same(iso_negative(-iso_real_of(1)), -iso_real_of(1), "negative: the smallest denormal below 0 is itself");
}

static void test_special(void)
{
    const real infinite = infinity();
    const iso_bits all = ~(iso_bits)0;
    const iso_bits quiet = ISO_EXPONENT_BITS | (ISO_EXPONENT_BITS >> 1);

    tap_bits(iso_less(LARGEST, infinite), all, "less: the largest number is below infinity");
    tap_bits(iso_less(infinite, LARGEST), 0, "less: infinity is not below the largest number");
    tap_bits(iso_less(-infinite, infinite), all, "less: -infinity is below infinity");
    tap_same(iso_min(infinite, R(1.0)), R(1.0), "min with infinity");
    tap_same(iso_max(infinite, R(1.0)), infinite, "max with infinity");
    tap_same(iso_clamp(-infinite, R(-1.0), R(1.0)), R(-1.0), "clamp of -infinity");
    tap_same(iso_abs(-infinite), infinite, "abs of -infinity");
    tap_bits(iso_not_finite(infinite), all, "not_finite: infinity");
    tap_bits(iso_not_finite(-infinite), all, "not_finite: -infinity");
    tap_bits(iso_not_finite(iso_real_of(quiet)), all, "not_finite: quiet NaN");
    tap_bits(iso_not_finite(iso_real_of(quiet | ISO_SIGN_BIT)), all, "not_finite: negative NaN");
    tap_bits(iso_not_finite(iso_real_of(ISO_EXPONENT_BITS + 1)), all, "not_finite: signalling NaN");
    tap_bits(iso_not_finite(LARGEST), 0, "not_finite: the largest number is finite");
    tap_bits(iso_beyond(infinite, ISO_REAL_MAX), all, "beyond: infinity");
    tap_bits(iso_beyond(iso_real_of(quiet), ISO_REAL_MAX), all, "beyond: quiet NaN");
    tap_bits(iso_beyond(iso_real_of(ISO_EXPONENT_BITS + 1), R(1.0)), all, "beyond: signalling NaN");
    tap_bits(iso_beyond(-LARGEST, ISO_REAL_MAX), 0, "beyond: not the largest number");
    tap_bits(iso_beyond(R(-8.0), R(8.0)), 0, "beyond: not the end of a range");
    tap_bits(iso_beyond(-next_above(R(8.0)), R(8.0)), all, "beyond: an ulp from there");
    tap_bits(iso_beyond(next_above(R(8.0)), R(8.0)), all, "beyond: on the other side too");
    tap_bits(iso_beyond(R(-0.0), R(8.0)), 0, "beyond: not zero");
}

static void test_select(void)
{
    const iso_bits all = ~(iso_bits)0;
    tap_same(iso_select(all, R(1.5), R(-2.5)), R(1.5), "select: the first under a mask of ones");
    tap_same(iso_select(0, R(1.5), R(-2.5)), R(-2.5), "select: the second under a mask of zeros");
    tap_same(iso_select(all, R(-0.0), R(1.0)), R(-0.0), "select: keeps the sign of zero");
    tap_bits(iso_bits_of(iso_select(0, R(1.0), iso_real_of(ISO_EXPONENT_BITS + 5))), ISO_EXPONENT_BITS + 5,
             "select: keeps the payload of a NaN");
    tap_bits(iso_bits_of(iso_real_of(1)), 1, "real_of and bits_of: a denormal passes through");

    volatile real tiny = iso_real_of(3);
    tap_bits(iso_bits_of(tiny - iso_real_of(2)), 1, "denormals are kept by a subtraction");
    tap_same(ISO_REAL_EPSILON, next_above(R(1.0)) - R(1.0), "epsilon is one ulp of 1");
}

int main(void)
{
    fill();
    test_zeros();
    test_special();
    test_select();
    test_lists();
    tap_done();
}
