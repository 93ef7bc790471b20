/* The operations of port/soft/binary64.h as functions, as those of binary32.h are in operations.h. */
#ifndef ISO_TESTS_SOFT_WIDE_OPERATIONS_H
#define ISO_TESTS_SOFT_WIDE_OPERATIONS_H

#include <stdbool.h>
#include <stdint.h>

typedef uint64_t wide_operation(uint64_t a, uint64_t b);

typedef enum wide_kind {
    WIDE_SUM,
    WIDE_DIFFERENCE,
    WIDE_PRODUCT,
    WIDE_QUOTIENT,
    WIDE_ROOT,
    WIDE_COMPARISON, /* bit 0 less, bit 1 equal, bit 2 at most, bit 3 unordered */
    WIDE_FROM_INT32,
    WIDE_FROM_UINT32,
    WIDE_FROM_INT64,
    WIDE_FROM_UINT64,
    WIDE_TO_INT32,
    WIDE_TO_UINT32,
    WIDE_TO_INT64,
    WIDE_TO_UINT64,
    WIDE_FROM_BINARY32,
    WIDE_TO_BINARY32,
    WIDE_KINDS
} wide_kind;

extern const char *const wide_names[WIDE_KINDS];
extern wide_operation *const wide_operations[WIDE_KINDS];

/* Operations of two numbers. */
static inline bool wide_has_two(const wide_kind kind)
{
    return kind < WIDE_ROOT || kind == WIDE_COMPARISON;
}

#endif
