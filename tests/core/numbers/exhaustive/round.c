/* iso_round and iso_floor of core/numbers/pieces.h, on the host: exact for every number, against the library of C in
 * the rounding to nearest, where the half goes to the even one. What is negative and rounds to zero gives +0.
 *
 * usage: round [STRIDE|all], see tests/core/numbers/exhaustive/measure.h. A whole number and a half stand beside seams:
 * around each power of two the next numbers are tried.
 */
#include "core/numbers/pieces.h"

#include "tests/core/numbers/exhaustive/measure.h"

#ifdef PLANTED
/* Halves go away from zero. */
#define iso_round(x) ((real)WIDE(round)((wide)(x)))
#endif

static worst of_round, of_floor;

static void each(const real x)
{
    compare(&of_round, iso_round(x), WIDE(nearbyint)((wide)x), x);
    compare(&of_floor, iso_floor(x), WIDE(floor)((wide)x), x);
}

int main(const int argc, char **const argv)
{
    enum { HALVES = 2000 };
    const real whole = R(1.0) / ISO_REAL_EPSILON, infinity = (real)INFINITY;
    real places[DIGITS + 4];
    for (int i = 0; i < DIGITS + 4; i++) {
        places[i] = (real)ldexp(1.0, i - 2);
    }
    sweep(stride_of(argc, argv), ISO_REAL_MAX, places, DIGITS + 4, each);
    for (int i = 0; i < HALVES; i++) {
        each((real)i + R(0.5));
        each(-(real)i - R(0.5));
        each(whole / R(2.0) - (real)i - R(0.5));
        each(whole / R(2.0) + (real)i + R(0.5));
        each(-whole / R(2.0) - (real)i - R(0.5));
    }
    bounded(of_round, 0.0, "round");
    bounded(of_floor, 0.0, "floor");
    result(iso_round(infinity) == infinity && iso_round(-infinity) == -infinity && isnan(iso_round((real)NAN)),
           "round: infinities and a NaN are themselves");
    result(iso_bits_of(iso_round(R(-0.25))) == 0 && iso_bits_of(iso_round(R(0.5))) == 0,
           "round: what is nearest to 0 gives +0");
    return finish();
}
