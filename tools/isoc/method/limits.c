#include "tools/isoc/method/growth.h"

#include <math.h>

#include "core/methods/table.h"

/* No region of an explicit method reaches so far. */
static const double beyond = 50.0, rate_followed = 4.0, frequency_followed = 2.0;

static const double damping = 0.1;

/* Rounding of a growth of one. */
static const double rounding = 1e-9;

/* The first r up to `end` where r (re + i im) grows, to four decimals. */
static double first_growth(unsigned recipe, double re, double im, double end)
{
    const double least = 0.05, factor = 1.05, fine = 1e-7, decimals = 1e4;
    arena *memory = arena_new();
    double low = 0.0, high = least;
    while (high < end && growth_of(memory, recipe, high * re, high * im) <= 1.0 + rounding) {
        low = high;
        high *= factor;
    }
    if (high < end) {
        while (high - low > fine) {
            const double middle = 0.5 * (low + high);
            *(growth_of(memory, recipe, middle * re, middle * im) <= 1.0 + rounding ? &low : &high) = middle;
        }
    } else {
        low = end;
    }
    arena_free(memory);
    return floor(low * decimals + 0.5) / decimals;
}

stability_limits limits_of(unsigned recipe)
{
    const bool knows = ISO_IS_IMPLICIT(recipe);
    return (stability_limits){
        first_growth(recipe, -1.0, 0.0, knows ? rate_followed : beyond),
        first_growth(recipe, -damping, sqrt(1.0 - damping * damping), knows ? frequency_followed : beyond)};
}
