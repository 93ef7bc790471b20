/* The operations of port/soft/binary32.h as functions: compiled for a core without a floating-point unit, they are
 * tried on one that has it. */
#ifndef ISO_TESTS_SOFT_OPERATIONS_H
#define ISO_TESTS_SOFT_OPERATIONS_H

#include <stdint.h>

typedef struct operations {
    uint32_t (*add)(uint32_t a, uint32_t b);
    uint32_t (*subtract)(uint32_t a, uint32_t b);
    uint32_t (*multiply)(uint32_t a, uint32_t b);
    uint32_t (*divide)(uint32_t a, uint32_t b);
    uint32_t (*root)(uint32_t a, uint32_t unused);
    /* Bit 0 less, bit 1 equal, bit 2 at most, bit 3 unordered. */
    uint32_t (*compare)(uint32_t a, uint32_t b);
    uint32_t (*from_int32)(uint32_t n, uint32_t unused);
    uint32_t (*from_uint32)(uint32_t n, uint32_t unused);
    uint32_t (*from_int64)(uint32_t low, uint32_t high);
    uint32_t (*from_uint64)(uint32_t low, uint32_t high);
    uint32_t (*to_int32)(uint32_t a, uint32_t unused);
    uint32_t (*to_uint32)(uint32_t a, uint32_t unused);
    uint32_t (*to_int64)(uint32_t a, uint32_t is_high); /* one half of it */
    uint32_t (*to_uint64)(uint32_t a, uint32_t is_high);
} operations;

extern const operations the_operations;

#endif
