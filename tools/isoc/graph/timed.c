#include "tools/isoc/graph/timed.h"

#include <math.h>

uint64_t phase_of(double turns)
{
    const double fraction = turns - floor(turns);
    return (uint64_t)(fraction * 18446744073709549568.0);
}

/* The curve as a whole number of 62 bits and a shift. */
iso_chirp_table sweep_of(const tick_table *t)
{
    int exponent;
    const double part = frexp(fabs(t->curve), &exponent);
    int shift = -2 - exponent;
    shift = shift > 63 ? 63 : shift < 1 ? 1 : shift;
    return (iso_chirp_table){
        .first = phase_of(t->first),
        .last = phase_of(t->last),
        .curve = (uint64_t)ldexp(part, exponent + 64 + shift),
        .sign = t->curve < 0.0 ? ~UINT64_C(0) : 0,
        .shift = (uint32_t)shift,
        .ticks = (uint32_t)t->ticks,
    };
}
