/* Problems with reference solutions. References are right to the digits that are given: computed with many more, twice.
 */
#ifndef ISO_TESTS_ADAMS_PROBLEMS_H
#define ISO_TESTS_ADAMS_PROBLEMS_H

#include "core/runtime/plant.h"

enum { PROBLEM_STATES_MAX = 10, PROBLEMS = 9 };

typedef struct problem {
    const char *name;
    iso_derivative *f;
    size_t n;
    double start[PROBLEM_STATES_MAX];
    double end; /* s, after `ticks` ticks */
    int ticks;
    double reference[PROBLEM_STATES_MAX];
    int first_tolerance; /* 10^-this is where the error begins to follow the tolerance */
    double share; /* what the error at the end is of the tolerances of all sub-steps: three times what was measured */
    double cost;  /* evaluations against those of abm4 with a fixed step at the same error, at most */
} problem;

/* Motions that are smooth: orbits, mechanisms, and problems of DETEST. */
extern const problem problems[PROBLEMS];

/* A stiff one. */
extern const problem problem_bushing;

#endif
