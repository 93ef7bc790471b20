/* The modes of x' = J x, and whether a method holds them with a step. */
#ifndef ISOC_STABILITY_MODES_H
#define ISOC_STABILITY_MODES_H

#include "tools/isoc/stability/slopes.h"

typedef struct modes {
    slopes of;
    double *re, *im; /* [of.n] the eigenvalues */
    bool found;
} modes;

modes modes_of(arena *memory, slopes at);

/* How many of them grow by the method alone, and the fastest of these. A mode that grows by itself is none of them. */
int count_growing(const modes *m, unsigned recipe, double step, int *fastest);

/* The largest step up to which none does; infinite where there is no such limit. */
double largest_step(const modes *m, unsigned recipe);

/* The fastest growth by the method alone, however slow. */
typedef struct drift {
    double rate;      /* 1/s: by e in 1 / rate; 0 where nothing does */
    double frequency; /* rad/s */
} drift;

drift drift_of(const modes *m, unsigned recipe, double step);

#endif
