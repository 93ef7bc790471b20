#include "tools/isoc/mechanism/limits.h"

#include "core/methods/recipe.h"

/* From the root loci of the methods (Hairer and Wanner, 1996, Solving Ordinary Differential Equations II, IV.2 and V.1);
 * tests/stability/stability.c compares. An implicit method has no limit of a rate; its limit here is how well a fixed
 * number of iterations follows what changes within a step, and of bdf4 where a lightly damped oscillation grows. The sub-steps of adams follow its error: it has
 * the limits of abm4. */
static const stability_limits limits[ISO_METHODS] = {
    [ISO_EULER] = {2.0, 0.2},          [ISO_HEUN] = {2.0, 1.0498},           [ISO_RK4] = {2.7853, 2.9509},
    [ISO_AB4] = {0.3, 0.4077},         [ISO_SEMI_IMPLICIT] = {2.0, 1.80998}, [ISO_ABM4] = {1.2848, 0.9101},
    [ISO_ABM4_PEC] = {0.1579, 0.2066}, [ISO_ABM4_PECECE] = {1.0538, 1.0688}, [ISO_BDF4] = {4.0, 0.8},
    [ISO_ROSENBROCK] = {4.0, 2.0},     [ISO_ADAMS] = {1.2848, 0.9101},
};

stability_limits limits_of(unsigned recipe)
{
    return limits[ISO_METHOD_OF(recipe)];
}
