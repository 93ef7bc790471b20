/* How fast something may be that a method holds with a step. */
#ifndef ISOC_MECHANISM_LIMITS_H
#define ISOC_MECHANISM_LIMITS_H

typedef struct stability_limits {
    double rate;      /* h |lambda| of what decays without oscillation */
    double frequency; /* h omega of an oscillation with a tenth of critical damping */
} stability_limits;

/* Of a method; zero where none are known. */
stability_limits limits_of(unsigned recipe);

#endif
