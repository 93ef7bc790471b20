/* The error of core/numbers/tanh.h over all numbers, on the host; its symmetry, its range, and how far it falls. */
#include "core/numbers/tanh.h"

#include "tests/core/numbers/exhaustive/measure.h"

static const double bound = 4.0, deepest = 2.0; /* ulp */

static worst of_all, fall;
static uint64_t asymmetric, outside;

static void each(const real x)
{
    const real got = iso_tanh(x);
    const real next = iso_tanh(iso_real_of(iso_bits_of(x) + 1)); /* one further from 0 */
    compare(&of_all, got, WIDE(tanh)((wide)x), x);
    asymmetric += iso_bits_of(iso_tanh(-x)) != (iso_bits_of(got) ^ ISO_SIGN_BIT);
    outside += iso_beyond(got, R(1.0)) != 0;
    const double down = (double)((wide)(iso_abs(got) - iso_abs(next)) / ulp_of((wide)got));
    if (down > fall.error) {
        fall = (worst){down, x};
    }
}

int main(const int argc, char **const argv)
{
    static const real seams[] = {R(0.5), R(1.0), R(9.0), R(9.02), R(19.0), R(19.1), R(32.0), R(0.52), R(0.55), R(0.31)};
    sweep(stride_of(argc, argv), ISO_REAL_MAX, seams, sizeof seams / sizeof seams[0], each);
    bounded(of_all, bound, "tanh");
    bounded(fall, deepest, "how far tanh falls");
    result(asymmetric == 0, "tanh(-x) = -tanh(x)");
    result(outside == 0, "tanh stays in [-1, 1]");
    const real infinite = iso_real_of(ISO_EXPONENT_BITS);
    result(iso_tanh(infinite) == R(1.0) && iso_tanh(-infinite) == R(-1.0), "tanh of an infinity is 1");
    result(iso_tanh(R(0.0)) == R(0.0), "tanh(0) = 0");
    return finish();
}
