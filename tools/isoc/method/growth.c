#include "tools/isoc/method/growth.h"

#include <math.h>

#include "core/methods/all.h"
#include "core/methods/table.h"
#include "tools/isoc/base/numbers.h"
#include "tools/isoc/method/step_map.h"

/* A history shifts its values from place to place, which gives up to five zero eigenvalues in a row. Rounding turns
 * these into its fifth root, and they are slow to find. In the eighth power of the map they are zeros. */
enum { SQUARINGS = 3 };

double growth_of_map(arena *memory, const double *map, int n)
{
    double *re = arena_take(memory, (size_t)n, sizeof *re), *im = arena_take(memory, (size_t)n, sizeof *im);
    double largest = 0.0;
    for (int i = 0; i < SQUARINGS; i++) {
        map = product_of_matrices(memory, map, n, n, map, n);
    }
    if (!eigenvalues(memory, map, n, re, im)) {
        return HUGE_VAL;
    }
    for (int i = 0; i < n; i++) {
        largest = fmax(largest, modulus(re[i], im[i]));
    }
    for (int i = 0; i < SQUARINGS; i++) {
        largest = sqrt(largest);
    }
    return largest;
}

double growth_of(arena *memory, unsigned recipe, double re, double im)
{
    const double size = modulus(re, im), oscillation[] = {0.0, size, -size, 2.0 * re};
    const bool turns = im != 0.0;
    const linear_plant l = {turns ? oscillation : &re, turns ? 2 : 1, turns};
    const unsigned options = ISO_COMPENSATED | ISO_CHECKED | ISO_SMOOTH | ISO_SETTLED;
    int n;
    const double *map = step_map(memory, recipe & ~options, &l, 1.0, &n);
    return growth_of_map(memory, map, n);
}

/* --- limits --- */

/* No region of an explicit method reaches so far. */
static const double beyond = 50.0, rate_followed = 4.0, frequency_followed = 2.0;

static const double damping = 0.1;

/* The rounding of a growth of one. */
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
