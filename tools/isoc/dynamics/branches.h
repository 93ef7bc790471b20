/* Where a loop can be assembled in several ways that meet: the constraints lose rank there. At compile time. */
#ifndef ISOC_DYNAMICS_BRANCHES_H
#define ISOC_DYNAMICS_BRANCHES_H

#include "tools/isoc/dynamics/closing.h"

/* Returns how many coordinates are undetermined at the solution c->x: the freedoms of what is_free moves. If none is, but
 * the constraints have lost rank, it is a multiple root: two ways to close the loops meet. Such a root was found to the
 * root of the rounding only; it is moved to where the constraints lose rank. `meets` [degrees of freedom] becomes true
 * for those that take part in that. */
int branches_look(const closing *c, const bool *is_free, bool *meets);

/* The rank of the constraints' rates in all coordinates, at a position that is a little farther on. */
int branches_rank_nearby(const closing *c);

#endif
