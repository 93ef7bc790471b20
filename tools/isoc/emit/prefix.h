/* The name of a plant in other firmware: of its files, and the beginning of all its identifiers. */
#ifndef ISOC_EMIT_PREFIX_H
#define ISOC_EMIT_PREFIX_H

#include "tools/isoc/base/arena.h"

/* Why isoc cannot make files and identifiers with this prefix; NULL where it can. */
const char *prefix_fault(const char *prefix, arena *memory);

#endif
