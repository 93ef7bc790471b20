/* The rounding error of a sum and of a product: exactly, and without a branch. The compiler must not simplify the
 * differences to zero; the flags of the build see to that. */
#ifndef ISO_CORE_NUMBERS_EXACT_H
#define ISO_CORE_NUMBERS_EXACT_H

#include "core/numbers/real.h"

/* a + b less the rounded `sum` of the two: Knuth (1998), The Art of Computer Programming 2, 4.2.2, theorem B. */
static inline real iso_rest_of_sum(const real a, const real b, const real sum)
{
    const real added = sum - a;
    return (a - (sum - added)) + (b - added);
}

/* The upper half of the significand. The remainder fits into the other half. */
static inline real iso_upper(const real x)
{
#ifdef ISO_REAL_DOUBLE
    return iso_real_of(iso_bits_of(x) & ~((UINT64_C(1) << 27) - 1));
#else
    return iso_real_of(iso_bits_of(x) & ~((UINT32_C(1) << 12) - 1));
#endif
}

/* a b less the rounded `product` of the two, in double to 2^-106 of it: Dekker (1971), A floating-point technique for
 * extending the available precision, Numerische Mathematik 18, 5.12. Not for products near the limits of real. */
static inline real iso_rest_of_product(const real a, const real b, const real product)
{
    const real a_upper = iso_upper(a), b_upper = iso_upper(b);
    const real a_lower = a - a_upper, b_lower = b - b_upper;
    return ((a_upper * b_upper - product) + a_upper * b_lower + a_lower * b_upper) + a_lower * b_lower;
}

#endif
