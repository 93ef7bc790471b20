/* Words that were typed wrong. */
#ifndef ISOC_BASE_NEAREST_H
#define ISOC_BASE_NEAREST_H

#include <stddef.h>

/* The name of names[count] that is nearest to the typed word; upper and lower case are alike. NULL if none is near: the
 * distance is at most two characters, for a short word one. */
const char *nearest(const char *typed, const char *const *names, size_t count);

#endif
