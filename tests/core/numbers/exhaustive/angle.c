/* The errors of core/numbers/angle.h, on the host: of points in all directions and of many sizes, and of |x| <= 1. */
#include "core/numbers/angle.h"

#include "tests/core/numbers/exhaustive/measure.h"

static const double bound = 4.0, inverse_bound = 4.0; /* ulp */

static worst of_atan2, of_asin, of_acos;
static uint64_t asymmetric;

static void compare_point(const real y, const real x)
{
    const wide want = WIDE(atan2)((wide)y, (wide)x);
    const real got = iso_atan2(y, x);
    asymmetric += iso_bits_of(iso_atan2(-y, x)) != (iso_bits_of(got) ^ ISO_SIGN_BIT);
    if (WIDE(fabs)(want) >= (wide)ISO_REAL_LEAST) {
        compare(&of_atan2, got, want, y);
    }
}

/* The direction whose tangent is x, by points of two sizes and in all eight parts. */
static void each_tangent(const real x)
{
    const real other = random_real(20);
    compare_point(x, R(1.0));
    compare_point(R(1.0), x);
    compare_point(x, R(-1.0));
    compare_point(R(-1.0), x);
    if (iso_not_finite(x * other) == 0) {
        compare_point(x * other, other);
    }
}

/* The largest points, whose sum |x| + |y| is infinite, and those near them. */
static void each_large(const real x)
{
    static const real parts[] = {R(1.0), R(0.75), R(0.5), R(0.42), R(0.41), R(1e-6)};
    for (size_t i = 0; i < sizeof parts / sizeof parts[0]; i++) {
        compare_point(x, ISO_REAL_MAX * parts[i]);
        compare_point(ISO_REAL_MAX * parts[i], -x);
    }
}

static void each_sine(const real x)
{
    compare(&of_asin, iso_asin(x), WIDE(asin)((wide)x), x);
    compare(&of_acos, iso_acos(x), WIDE(acos)((wide)x), x);
}

static void test_special(void)
{
    static const real pi = R(3.14159265358979324);
    const real infinite = iso_real_of(ISO_EXPONENT_BITS), zero = R(0.0), denormal = iso_real_of(1);
    result(iso_bits_of(iso_atan2(zero, zero)) == 0 && iso_bits_of(iso_atan2(-zero, zero)) == ISO_SIGN_BIT,
           "atan2(0, 0) = 0, atan2(-0, 0) = -0");
    result(iso_atan2(zero, -zero) == pi && iso_atan2(-zero, R(-2.0)) == -pi, "atan2(0, -0) = pi, atan2(-0, -2) = -pi");
    result(iso_atan2(R(1.0), zero) == pi / 2 && iso_atan2(R(-1.0), -zero) == -pi / 2, "atan2(1, 0) = pi/2");
    result(iso_atan2(infinite, R(1.0)) == pi / 2 && iso_atan2(R(-1.0), infinite) == R(0.0), "of one infinity");
    result(iso_atan2(infinite, infinite) != iso_atan2(infinite, infinite), "of two infinities NaN");
    result(iso_atan2(denormal, denormal) == pi / 4, "of denormals");
    result(iso_bits_of(iso_acos(R(1.0))) == 0 && iso_acos(R(-1.0)) == pi, "acos(1) = 0, acos(-1) = pi");
    result(iso_asin(R(1.5)) != iso_asin(R(1.5)) && iso_acos(R(-1.5)) != iso_acos(R(-1.5)), "beyond 1 NaN");
}

int main(const int argc, char **const argv)
{
    static const real seams[] = {R(1.0), R(0.41421356), R(2.41421356), R(0.5), R(0.25), R(2.0), R(1e9)};
    static const real sines[] = {R(0.70710678), R(0.5), R(0.9), R(0.99), R(0.38268343), R(0.923879533)};
    const uint64_t stride = stride_of(argc, argv);
    sweep(8 * stride, ISO_REAL_MAX, seams, sizeof seams / sizeof seams[0], each_tangent);
    for (int i = 0; i < 100000; i++) {
        const real part = (real)i * R(1e-5);
        each_large(ISO_REAL_MAX * (R(0.2) + R(0.8) * part));
    }
    sweep(4 * stride, R(1.0), sines, sizeof sines / sizeof sines[0], each_sine);
    bounded(of_atan2, bound, "atan2");
    bounded(of_asin, inverse_bound, "asin");
    bounded(of_acos, inverse_bound, "acos");
    result(asymmetric == 0, "atan2(-y, x) = -atan2(y, x)");
    test_special();
    return finish();
}
