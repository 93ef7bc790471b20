/* The files of core that a plant needs, so that its folder compiles alone. */
#ifndef ISOC_EMIT_STANDALONE_H
#define ISOC_EMIT_STANDALONE_H

#include "tools/isoc/emit/write.h"

/* Adds the files of core that those in the list include, and those that firmware calls and that need no port. They find
 * each other by relative paths, and in double they need no flag that says so. */
void standalone_files(file_list *files, bool is_double);

#endif
