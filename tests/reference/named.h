/* The outputs of the plant that a program is linked with, by name. */
#ifndef ISO_TESTS_REFERENCE_NAMED_H
#define ISO_TESTS_REFERENCE_NAMED_H

#include <string.h>

#include "core/runtime/plant.h"

/* Which output is called so; -1: none. */
static inline int find_output(const char *const wanted)
{
    const char *at = iso_the_plant.model->output_names;
    const size_t length = strlen(wanted);
    for (int i = 0; i < iso_the_plant.model->outputs; i++) {
        const size_t here = strcspn(at, ",");
        if (here == length && strncmp(at, wanted, here) == 0) {
            return i;
        }
        at += here + 1;
    }
    return -1;
}

#endif
