/* How fast something may be that a method holds with a step. */
#ifndef ISOC_METHOD_LIMITS_H
#define ISOC_METHOD_LIMITS_H

typedef struct stability_limits {
    double rate;      /* h |lambda| of what decays without oscillation */
    double frequency; /* h omega of an oscillation with a tenth of critical damping */
} stability_limits;

/* Of a recipe: where growth.h first finds growth, to four decimals. An implicit method holds what its Jacobian at the start of
 * a step knows, but not what begins within it: there a rate counts to 4 at most, after which 2 % are left of it, and a
 * frequency to 2, a third of a turn. adams has the limits of a sub-step; these follow the error. */
stability_limits limits_of(unsigned recipe);

#endif
