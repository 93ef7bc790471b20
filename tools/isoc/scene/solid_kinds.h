/* The solids that a body can be made of: one row for each. */
#ifndef ISOC_SCENE_SOLID_KINDS_H
#define ISOC_SCENE_SOLID_KINDS_H

#include <stdbool.h>

typedef struct solid_row {
    const char *word, *example;
    int numbers; /* that its size has; 0: three or six */
    bool hollow; /* its second radius is within the first */
    /* The principal moments of inertia about the centre, over the mass, as factors of the squares of the size's
     * numbers: sum over n of [axis][n] size[n]^2. Those of a lump are its size. */
    double moments[3][3];
} solid_row;

enum { SOLIDS = 6 };

/* The row of a word; NULL if there is none. */
const solid_row *find_solid(const char *word);

#endif
