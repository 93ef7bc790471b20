/* Start values that satisfy the closures, found at compile time. */
#ifndef ISOC_DYNAMICS_ASSEMBLY_H
#define ISOC_DYNAMICS_ASSEMBLY_H

#include "tools/isoc/dynamics/dynamics.h"

/* Coordinates and speeds that the scene gives no start, or a rough one, are moved, by Newton's method, to where the
 * closures hold; those that it gives are kept, but for what is lost in their digits. Changes the links' start and
 * speed. Notes a problem with residual and rank where they cannot hold, where coordinates stay undetermined, and where
 * constraints repeat each other and the stabilisation cannot bear that. */
void assemble(source *s, const dynamics *d);

#endif
