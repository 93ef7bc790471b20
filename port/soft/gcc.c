/* The helpers by which gcc computes with float where a processor has no floating-point unit, but for Arm, in place of those
 * of libgcc. GCC Internals: 4.2 Routines for floating point emulation. A number comes and goes where an integer of 32 bits
 * does. */
#include <stdint.h>

#include "port/soft/binary32.h"

/* The function __NAME with these parameters is this expression. */
#define HELPER(type, name, parameters, expression)                                                                     \
    type __##name parameters;                                                                                          \
    type __##name parameters                                                                                           \
    {                                                                                                                  \
        return expression;                                                                                             \
    }

HELPER(uint32_t, addsf3, (uint32_t a, uint32_t b), soft_add(a, b))
HELPER(uint32_t, subsf3, (uint32_t a, uint32_t b), soft_subtract(a, b))
HELPER(uint32_t, mulsf3, (uint32_t a, uint32_t b), soft_multiply(a, b))
HELPER(uint32_t, divsf3, (uint32_t a, uint32_t b), soft_divide(a, b))
HELPER(int, eqsf2, (uint32_t a, uint32_t b), 1 - (int)soft_is_equal(a, b))
HELPER(int, nesf2, (uint32_t a, uint32_t b), 1 - (int)soft_is_equal(a, b))
HELPER(int, ltsf2, (uint32_t a, uint32_t b), -(int)soft_is_less(a, b))
HELPER(int, lesf2, (uint32_t a, uint32_t b), 1 - (int)soft_is_at_most(a, b))
HELPER(int, gtsf2, (uint32_t a, uint32_t b), (int)soft_is_less(b, a))
HELPER(int, gesf2, (uint32_t a, uint32_t b), (int)soft_is_at_most(b, a) - 1)
HELPER(int, unordsf2, (uint32_t a, uint32_t b), (int)soft_is_unordered(a, b))
HELPER(uint32_t, floatsisf, (uint32_t n), soft_from_int32(n))
HELPER(uint32_t, floatunsisf, (uint32_t n), soft_from_uint32(n))
HELPER(uint32_t, floatdisf, (uint64_t n), soft_from_int64(n))
HELPER(uint32_t, floatundisf, (uint64_t n), soft_from_uint64(n))
HELPER(uint32_t, fixsfsi, (uint32_t a), soft_to_int32(a))
HELPER(uint32_t, fixunssfsi, (uint32_t a), soft_to_uint32(a))
HELPER(uint64_t, fixsfdi, (uint32_t a), soft_to_int64(a))
HELPER(uint64_t, fixunssfdi, (uint32_t a), soft_to_uint64(a))
