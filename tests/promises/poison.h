/* The plants that a program examines, by name; the one after the last has none. poison.sh writes them down. */
#ifndef ISO_TESTS_CHECK_POISON_H
#define ISO_TESTS_CHECK_POISON_H

#include "core/runtime/plant.h"

typedef struct poison_case {
    const char *name;
    const iso_plant *plant;
} poison_case;

extern const poison_case poison_cases[];

#endif
