/* Which masses and inertias a body can have. */
#ifndef ISOC_MECHANISM_INERTIA_H
#define ISOC_MECHANISM_INERTIA_H

#include <stddef.h>

/* NULL if a body can have this tensor (xx, yy, zz, xy, xz, yz) about its centre of mass, else what is wrong with it. */
const char *inertia_fault(const double tensor[6]);

#endif
