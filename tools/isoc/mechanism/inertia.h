/* Which masses and inertias a body can have. */
#ifndef ISOC_MECHANISM_INERTIA_H
#define ISOC_MECHANISM_INERTIA_H

#include <stddef.h>

/* NULL if the tensor (xx, yy, zz, xy, xz, yz) about a centre of mass can be a body's, else what is wrong with it. */
const char *inertia_fault(const double tensor[6]);

#endif
