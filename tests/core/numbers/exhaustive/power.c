/* The error of core/numbers/power.h, on the host: numbers of all sizes to powers of many; and what it is at the ends of
 * its domain. */
#include "core/numbers/power.h"

#include "tests/core/numbers/exhaustive/measure.h"

static const real powers[] = {R(0.7), R(-0.3), R(1.0) / R(3.0), R(2.5), R(-1.7), R(12.0), R(0.01), R(1.0), R(-40.0)};
enum { POWERS = sizeof powers / sizeof powers[0] };

static worst of_all; /* in parts of 1 + 3 |y log x| ulp */
static uint64_t beyond, negative;

static void each(const real x)
{
    if (x < R(0.0)) {
        negative += iso_power(x, R(0.7)) == iso_power(x, R(0.7)) && -x >= ISO_REAL_LEAST;
        return;
    }
    for (int i = 0; i < POWERS; i++) {
        const real y = powers[i], got = iso_power(x, y);
        const wide exponent = (wide)y * WIDE(log)((wide)x), size = WIDE(fabs)(exponent);
        const wide near = (wide)ISO_EXP_RANGE * (1 - 4 * (wide)ISO_REAL_EPSILON);
        if (x >= ISO_REAL_LEAST && size < near) {
            worst one = {0.0, x};
            compare(&one, got, WIDE(pow)((wide)x, (wide)y), x);
            const double part = one.error / (double)(1 + 3 * size);
            of_all = part <= of_all.error ? of_all : (worst){part, x};
        } else if (size > (wide)ISO_EXP_RANGE * (1 + 4 * (wide)ISO_REAL_EPSILON) || x < ISO_REAL_LEAST) {
            const bool is_large = x < ISO_REAL_LEAST ? y < R(0.0) : exponent > 0;
            beyond += iso_bits_of(got) != (is_large ? ISO_EXPONENT_BITS : 0);
        }
    }
}

int main(const int argc, char **const argv)
{
    static const real seams[] = {R(1.0), R(0.707106781186547524), R(1.41421356237309505), R(2.0), R(0.5), R(3e3)};
    sweep(8 * stride_of(argc, argv), ISO_REAL_MAX, seams, sizeof seams / sizeof seams[0], each);
    bounded(of_all, 1.0, "power, in parts of its bound");
    result(beyond == 0, "beyond the range of exp, and of 0, it is 0 or an infinity");
    result(negative == 0, "NaN of what is below 0");
    const real infinite = iso_real_of(ISO_EXPONENT_BITS), none = infinite - infinite;
    result(iso_power(R(-0.0), R(0.5)) == R(0.0) && iso_power(R(-0.0), R(-0.5)) == infinite, "of -0 as of 0");
    result(iso_power(R(3.7), R(0.0)) == R(1.0) && iso_power(R(1.0), R(-77.7)) == R(1.0), "x^0 = 1 and 1^y = 1");
    const real bad[] = {iso_power(R(0.0), R(0.0)), iso_power(infinite, R(0.5)), iso_power(none, R(0.5)),
                        iso_power(R(2.0), none), iso_power(-none, R(0.0))};
    bool nan = true;
    for (int i = 0; i < 5; i++) {
        nan = nan && bad[i] != bad[i];
    }
    result(nan, "NaN of 0^0 and of what is not finite");
    return finish();
}
