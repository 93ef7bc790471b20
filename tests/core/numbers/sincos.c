/* core/numbers/sincos.h on every target: against correctly rounded values, its symmetry, and its bits.
 * tests/core/numbers/exhaustive/sincos.c measures the error over the whole domain, on the host.
 */
#include "core/numbers/sincos.h"
#include "tests/tap.h"

typedef struct sincos_row {
    iso_bits x;
    iso_bits sin;
    iso_bits cos;
} sincos_row;

#include "tests/core/numbers/sincos_table.h"

enum { ROWS = sizeof sincos_table / sizeof sincos_table[0] };

/* A value of the table is within half an ulp of the true one, which is below 1: 0.25 ulp of 1.0. So a difference of at
 * most 1.25 ulp of 1.0, which is exact, proves the promised 1.5. */
static const real tolerance = R(1.25) * ISO_REAL_EPSILON;

static bool near(const real got, const iso_bits want, const real allowed)
{
    const real difference = got - iso_real_of(want);
    return !iso_not_finite(got) && iso_abs(difference) <= allowed;
}

/* Rows of the table where a value is further away than allowed. */
static uint32_t wrong_rows(const real allowed)
{
    uint32_t wrong = 0;
    for (unsigned i = 0; i < ROWS; i++) {
        const iso_sine_cosine got = iso_sincos(iso_real_of(sincos_table[i].x));
        const bool good = near(got.sin, sincos_table[i].sin, allowed) && near(got.cos, sincos_table[i].cos, allowed);
        if (!good && allowed >= tolerance) {
            tap_note_bits("wrong at", sincos_table[i].x);
        }
        wrong += !good;
    }
    return wrong;
}

static void test_table(void)
{
    tap_count(wrong_rows(tolerance), 0, "sine and cosine within 1.5 ulp of 1.0 of the true value");
    tap_ok(wrong_rows(R(0.0)) > 0, "the comparison notices a difference: not every value is correctly rounded");

    uint32_t inside = 0;
    for (unsigned i = 0; i < ROWS; i++) {
        const iso_sine_cosine got = iso_sincos(iso_real_of(sincos_table[i].x));
        inside += iso_abs(got.sin) <= R(1.0) && iso_abs(got.cos) <= R(1.0);
    }
    tap_count(inside, ROWS, "sine and cosine stay in [-1, 1]");
}

/* A function that takes them from those of another angle: how far the step may be within which it promises 1 ulp of 1.0
 * more; a long one, and its error. */
typedef struct from_another {
    iso_sine_cosine (*of)(iso_sine_cosine from, real d);
    real short_step, long_step, long_error;
} from_another;

#ifdef ISO_REAL_DOUBLE
static const from_another beyond = {iso_sincos_beyond, R(0.07), R(0.5), R(5.4e-9)};
static const from_another close_to = {iso_sincos_close, R(1.6e-3), R(0.5), R(2.7e-4)};
#else
static const from_another beyond = {iso_sincos_beyond, R(0.25), R(1.0), R(2.0e-4)};
static const from_another close_to = {iso_sincos_close, R(0.005), R(0.5), R(2.1e-2)};
#endif

/* Rows of the table where a value from that of an angle `step` before it is further away than allowed. The difference
 * of two near angles is exact, so that the rounding of the one before is none of the result. */
static uint32_t wrong_from(const from_another *const f, const real step, const real allowed)
{
    uint32_t wrong = 0;
    for (unsigned i = 0; i < ROWS; i++) {
        const real x = iso_real_of(sincos_table[i].x), before = x - step;
        const iso_sine_cosine got = f->of(iso_sincos(before), x - before);
        const bool is_exact = before + (x - before) == x;
        wrong +=
            is_exact && !(near(got.sin, sincos_table[i].sin, allowed) && near(got.cos, sincos_table[i].cos, allowed));
    }
    return wrong;
}

static void test_from(const from_another *const f)
{
    static const real parts[] = {R(1.0), R(0.73), R(0.1), R(1e-3), R(-1e-4), R(-0.3), R(-1.0)};
    const real promised = tolerance + ISO_REAL_EPSILON;
    uint32_t wrong = 0, far_off = 0, same = 0;
    for (unsigned i = 0; i < sizeof parts / sizeof parts[0]; i++) {
        wrong += wrong_from(f, parts[i] * f->short_step, promised);
        far_off += wrong_from(f, parts[i] * f->long_step, f->long_error);
    }
    for (unsigned i = 0; i < ROWS; i++) {
        const iso_sine_cosine at = iso_sincos(iso_real_of(sincos_table[i].x)), got = f->of(at, R(0.0));
        same += got.sin == at.sin && got.cos == at.cos;
    }
    tap_count(wrong, 0, "from another angle, near by: 1 ulp of 1.0 more");
    tap_count(far_off, 0, "from one far away: by the first term that is left out");
    tap_ok(wrong_from(f, f->long_step, promised) > 0 && wrong_from(f, f->long_step, f->long_error * R(0.01)) > 0,
           "which is found");
    tap_count(same, ROWS, "from the angle itself: the same");
}

static void test_symmetry(void)
{
    uint32_t odd = 0, even = 0;
    for (unsigned i = 0; i < ROWS; i++) {
        const real x = iso_real_of(sincos_table[i].x);
        const iso_sine_cosine right = iso_sincos(x);
        const iso_sine_cosine left = iso_sincos(-x);
        odd += left.sin == -right.sin;
        even += left.cos == right.cos;
    }
    tap_count(odd, ROWS, "sin(-x) = -sin(x) exactly");
    tap_count(even, ROWS, "cos(-x) = cos(x) exactly");
}

/* Below 2^-27 the sine is its argument and the cosine 1, whatever the rounding. */
static void test_small(void)
{
    const real denormal = iso_real_of(1);
    tap_same(iso_sincos(denormal).sin, denormal, "sine of the smallest denormal is itself");
    tap_same(iso_sincos(-denormal).sin, -denormal, "sine of the smallest negative denormal is itself");
    tap_same(iso_sincos(denormal).cos, R(1.0), "cosine of the smallest denormal is 1");
    tap_ok(iso_sincos(R(0.0)).sin == R(0.0), "sine of 0 is 0");
    tap_same(iso_sincos(R(0.0)).cos, R(1.0), "cosine of 0 is 1");
    tap_ok(iso_sincos(R(-0.0)).sin == R(0.0), "sine of -0 is 0");
}

static bool is_nan(const real x)
{
    return x != x;
}

static void test_not_finite(void)
{
    const real infinite = iso_real_of(ISO_EXPONENT_BITS);
    const real nan = iso_real_of(ISO_EXPONENT_BITS | (ISO_EXPONENT_BITS >> 1));
    tap_ok(is_nan(iso_sincos(infinite).sin) && is_nan(iso_sincos(infinite).cos), "infinity gives NaN");
    tap_ok(is_nan(iso_sincos(-infinite).sin) && is_nan(iso_sincos(-infinite).cos), "-infinity gives NaN");
    tap_ok(is_nan(iso_sincos(nan).sin) && is_nan(iso_sincos(nan).cos), "NaN gives NaN");
}

/* The bits of all results, as one number (FNV-1a over words): equal on every target and at every optimisation. A change
 * of the algorithm in core/numbers/sincos.h changes the number wanted here. */
static void test_bits(void)
{
#ifdef ISO_REAL_DOUBLE
    const uint64_t want = UINT64_C(0xc5acbb54e30efdc4);
#else
    const uint64_t want = UINT64_C(0xcc96b3a6d0bee9d5);
#endif
    uint64_t hash = UINT64_C(0xcbf29ce484222325);
    for (unsigned i = 0; i < ROWS; i++) {
        const iso_sine_cosine got = iso_sincos(iso_real_of(sincos_table[i].x));
        hash = (hash ^ iso_bits_of(got.sin)) * UINT64_C(0x100000001b3);
        hash = (hash ^ iso_bits_of(got.cos)) * UINT64_C(0x100000001b3);
    }
    tap_bits(hash, want, "the same bits on every target");
}

int main(void)
{
    test_table();
    test_from(&beyond);
    test_from(&close_to);
    test_symmetry();
    test_small();
    test_not_finite();
    test_bits();
    tap_done();
}
