/* A plant that isoc made of a generated mechanism, with its equations in reach: one member of a family. */
#ifndef ISO_TESTS_DYNAMICS_FAMILY_H
#define ISO_TESTS_DYNAMICS_FAMILY_H

#include "core/runtime/plant.h"

typedef struct family_member {
    const char *name;
    bool closed;
    int seed;
    iso_plant (*plant)(void);
    const iso_equations *equations;         /* with a Jacobian */
    const real *(*held)(void);              /* what they read besides; NULL: the parameters */
    void (*settle)(real *x, const real *p); /* what follows the method in a step; NULL for nothing */
} family_member;

/* Ends with NULL. */
extern const family_member *const family[];

#endif
