/* The error of core/numbers/log.h over its domain, on the host, and what it is beyond. */
#include "core/numbers/log.h"

#include "tests/core/numbers/exhaustive/measure.h"

static const double bound = 2.0; /* ulp */

static worst of_all;
static uint64_t defined, undefined;

static void each(const real x)
{
    if (x >= ISO_REAL_LEAST) {
        compare(&of_all, iso_log(x), WIDE(log)((wide)x), x);
    } else if (x < R(0.0)) {
        defined += iso_log(x) == iso_log(x);
    } else {
        undefined += iso_log(x) != iso_log(ISO_REAL_LEAST);
    }
}

int main(const int argc, char **const argv)
{
    static const real seams[] = {R(1.0),  R(0.707106781186547524), R(1.41421356237309505), R(2.0), R(0.5), R(3e3),
                                 R(1e-20)};
    sweep(stride_of(argc, argv), ISO_REAL_MAX, seams, sizeof seams / sizeof seams[0], each);
    bounded(of_all, bound, "log");
    result(defined == 0, "log of a negative number is NaN");
    result(undefined == 0, "log of what is below the normal numbers is that of the least");
    result(iso_bits_of(iso_log(R(1.0))) == 0, "log(1) = 0");
    result(iso_log(R(-0.0)) == iso_log(ISO_REAL_LEAST), "log(-0) is log(0)");
    const real top = iso_log(iso_real_of(ISO_EXPONENT_BITS));
    result(top >= iso_log(ISO_REAL_MAX) && iso_not_finite(top) == 0,
           "log of an infinity is that of the largest number");
    return finish();
}
