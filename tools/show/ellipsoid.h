/* The ellipsoid of inertia of a body. */
#ifndef ISO_TOOLS_SHOW_ELLIPSOID_H
#define ISO_TOOLS_SHOW_ELLIPSOID_H

#include "tools/show/shape.h"

typedef struct ellipsoid {
    pose at;   /* its centre and its axes, in the frame of the body */
    vec radii; /* along them; 0 of a point mass */
} ellipsoid;

/* Along each principal axis its radius is sqrt(3) times the deviation of the mass: so that of a uniform rod ends where
 * the rod ends. */
ellipsoid ellipsoid_of(const shape_lump *l);

#endif
