/* The plants of tests/core/runtime/snapshots/test_family.py. */
#ifndef TESTS_SNAPSHOT_FAMILY_H
#define TESTS_SNAPSHOT_FAMILY_H

#include "core/runtime/plant.h"

typedef struct family_member {
    const char *name;
    uint64_t ticks;               /* to run */
    iso_plant (*plant_of)(int i); /* the first or the second of its kind */
} family_member;

extern const family_member *const family[]; /* the last is NULL */

#endif
