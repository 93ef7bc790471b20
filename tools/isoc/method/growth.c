#include "tools/isoc/method/growth.h"

#include <math.h>

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
        largest = fmax(largest, sqrt(re[i] * re[i] + im[i] * im[i]));
    }
    for (int i = 0; i < SQUARINGS; i++) {
        largest = sqrt(largest);
    }
    return largest;
}

double growth_of(arena *memory, unsigned recipe, double re, double im)
{
    const double size = sqrt(re * re + im * im), oscillation[] = {0.0, size, -size, 2.0 * re};
    const bool turns = im != 0.0;
    const linear_plant l = {turns ? oscillation : &re, turns ? 2 : 1, turns};
    const unsigned options = ISO_COMPENSATED | ISO_CHECKED | ISO_SMOOTH | ISO_SETTLED;
    int n;
    const double *map = step_map(memory, recipe & ~options, &l, 1.0, &n);
    return growth_of_map(memory, map, n);
}
