/* Words that were typed wrong. */
#ifndef ISOC_BASE_NEAREST_H
#define ISOC_BASE_NEAREST_H

#include <stddef.h>

/* The one of names[count] that is nearest to what was typed, upper and lower case alike; NULL if none is near: within two
 * characters, of a short word one. */
const char *nearest(const char *typed, const char *const *names, size_t count);

#endif
