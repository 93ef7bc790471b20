/* The error of core/numbers/exp.h over its domain, on the host; that it never falls; and what it is beyond. */
#include "core/numbers/exp.h"

#include "tests/core/numbers/exhaustive/measure.h"

static const double bound = 1.0; /* ulp */

static worst of_all;
static uint64_t falls;

/* The next larger number. */
static real after(const real x)
{
    const iso_bits b = iso_bits_of(x);
    return b == ISO_SIGN_BIT ? iso_real_of(1) : iso_real_of(b & ISO_SIGN_BIT ? b - 1 : b + 1);
}

static void each(const real x)
{
    const real got = iso_exp(x);
    compare(&of_all, got, WIDE(exp)((wide)x), x);
    falls += iso_exp(after(x)) < got;
}

int main(const int argc, char **const argv)
{
    enum { SEAMS = 1 + 2 * 255 };
    real seams[SEAMS] = {R(1.0)};
    for (int k = -255; k < 255; k++) {
        const real x = (real)((k + 0.5) * 0.693147180559945309 * (double)ISO_EXP_RANGE / 177.2);
        seams[k + 256] = iso_abs(x) < ISO_EXP_RANGE * R(0.999) ? x : R(1.0);
    }
    sweep(stride_of(argc, argv), ISO_EXP_RANGE, seams, SEAMS, each);
    bounded(of_all, bound, "exp");
    result(falls == 0, "exp never falls");
    const real infinite = iso_real_of(ISO_EXPONENT_BITS), least = iso_exp(-ISO_EXP_RANGE),
               most = iso_exp(ISO_EXP_RANGE);
    result(iso_exp(R(0.0)) == R(1.0) && iso_exp(R(-0.0)) == R(1.0), "exp(0) = 1");
    result(iso_exp(infinite) == most && iso_exp(ISO_REAL_MAX) == most,
           "exp beyond its domain is what it is at its end");
    result(iso_exp(-infinite) == least && iso_exp(-ISO_REAL_MAX) == least, "and so below");
    result(least >= ISO_REAL_LEAST && iso_not_finite(most) == 0, "both ends are normal numbers");
    return finish();
}
