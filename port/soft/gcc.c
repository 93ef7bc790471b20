/* The helpers by which gcc computes with float where a processor has no floating-point unit, but for Arm, in place of
 * those of libgcc; sums and products are in gcc_sum.c. GCC Internals: 4.2 Routines for floating point emulation. A
 * number comes and goes where an integer of 32 bits does. */
#include "port/soft/helper.h"

SOFT_HELPER(uint32_t, __divsf3, (uint32_t a, uint32_t b), soft_divide(a, b))
SOFT_HELPER(int, __eqsf2, (uint32_t a, uint32_t b), 1 - (int)soft_is_equal(a, b))
SOFT_HELPER(int, __nesf2, (uint32_t a, uint32_t b), 1 - (int)soft_is_equal(a, b))
SOFT_HELPER(int, __ltsf2, (uint32_t a, uint32_t b), -(int)soft_is_less(a, b))
SOFT_HELPER(int, __lesf2, (uint32_t a, uint32_t b), 1 - (int)soft_is_at_most(a, b))
SOFT_HELPER(int, __gtsf2, (uint32_t a, uint32_t b), (int)soft_is_less(b, a))
SOFT_HELPER(int, __gesf2, (uint32_t a, uint32_t b), (int)soft_is_at_most(b, a) - 1)
SOFT_HELPER(int, __unordsf2, (uint32_t a, uint32_t b), (int)soft_is_unordered(a, b))
SOFT_HELPER(uint32_t, __floatsisf, (uint32_t n), soft_from_int32(n))
SOFT_HELPER(uint32_t, __floatunsisf, (uint32_t n), soft_from_uint32(n))
SOFT_HELPER(uint32_t, __floatdisf, (uint64_t n), soft_from_int64(n))
SOFT_HELPER(uint32_t, __floatundisf, (uint64_t n), soft_from_uint64(n))
SOFT_HELPER(uint32_t, __fixsfsi, (uint32_t a), soft_to_int32(a))
SOFT_HELPER(uint32_t, __fixunssfsi, (uint32_t a), soft_to_uint32(a))
SOFT_HELPER(uint64_t, __fixsfdi, (uint32_t a), soft_to_int64(a))
SOFT_HELPER(uint64_t, __fixunssfdi, (uint32_t a), soft_to_uint64(a))
