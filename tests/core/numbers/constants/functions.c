/* Under memcheck: the functions of core/numbers with arguments marked undefined. A branch or an address that depends on
 * one is an error that memcheck counts.
 */
#include <stdio.h>
#include <valgrind/memcheck.h>

#include "core/numbers/angle.h"
#include "core/numbers/exp.h"
#include "core/numbers/log.h"
#include "core/numbers/pieces.h"
#include "core/numbers/power.h"
#include "core/numbers/root.h"
#include "core/numbers/tanh.h"

enum { NUMBERS = 64 };

static real sum_of(const real x, const real y)
{
    real sum = iso_exp(x) + iso_log(y) + iso_tanh(x) + iso_atan2(y, x) + iso_asin(x) + iso_acos(y) +
               iso_inverse_root(x) + iso_power(x, y);
    sum += iso_sign(x) + iso_floor(y) + iso_round(x) + iso_where(iso_above(x, y), y) + iso_unless(iso_above(y, x), x) +
           iso_only(iso_above(x, y), y) + iso_positive(x) + iso_negative(y) + iso_clamp(x, y, x + R(1.0)) + iso_abs(y);
#ifdef PLANTED
    sum += x > y ? iso_exp(sum) : y;
#endif
    return sum;
}

int main(void)
{
    real x[NUMBERS], y[NUMBERS];
    for (int i = 0; i < NUMBERS; i++) {
        x[i] = R(0.3) * (real)i - R(7.0);
    }
    VALGRIND_MAKE_MEM_UNDEFINED(x, sizeof x);
    for (int i = 0; i < NUMBERS; i++) {
        y[i] = sum_of(x[i], x[NUMBERS - 1 - i]);
    }
    const unsigned errors = (unsigned)VALGRIND_COUNT_ERRORS;
    VALGRIND_MAKE_MEM_DEFINED(y, sizeof y);
    printf("# %u errors, last value %g\n", errors, (double)y[NUMBERS - 1]);
    return errors > 0;
}
