/* The helpers by which code for an Arm core without a unit for double computes with it, in place of libgcc's: as in
 * aeabi.c, in two registers of integers. */
#include "port/soft/binary64.h"
#include "port/soft/helper.h"

SOFT_HELPER(uint64_t, __aeabi_dadd, (uint64_t a, uint64_t b), soft64_add(a, b))
SOFT_HELPER(uint64_t, __aeabi_dsub, (uint64_t a, uint64_t b), soft64_subtract(a, b))
SOFT_HELPER(uint64_t, __aeabi_drsub, (uint64_t a, uint64_t b), soft64_subtract(b, a))
SOFT_HELPER(uint64_t, __aeabi_dmul, (uint64_t a, uint64_t b), soft64_multiply(a, b))
SOFT_HELPER(uint64_t, __aeabi_ddiv, (uint64_t a, uint64_t b), soft64_divide(a, b))
SOFT_HELPER(uint32_t, __aeabi_dcmpeq, (uint64_t a, uint64_t b), soft64_is_equal(a, b))
SOFT_HELPER(uint32_t, __aeabi_dcmplt, (uint64_t a, uint64_t b), soft64_is_less(a, b))
SOFT_HELPER(uint32_t, __aeabi_dcmple, (uint64_t a, uint64_t b), soft64_is_at_most(a, b))
SOFT_HELPER(uint32_t, __aeabi_dcmpge, (uint64_t a, uint64_t b), soft64_is_at_most(b, a))
SOFT_HELPER(uint32_t, __aeabi_dcmpgt, (uint64_t a, uint64_t b), soft64_is_less(b, a))
SOFT_HELPER(uint32_t, __aeabi_dcmpun, (uint64_t a, uint64_t b), soft64_is_unordered(a, b))
SOFT_HELPER(uint64_t, __aeabi_i2d, (uint32_t n), soft64_from_int32(n))
SOFT_HELPER(uint64_t, __aeabi_ui2d, (uint32_t n), soft64_from_uint32(n))
SOFT_HELPER(uint64_t, __aeabi_l2d, (uint64_t n), soft64_from_int64(n))
SOFT_HELPER(uint64_t, __aeabi_ul2d, (uint64_t n), soft64_from_uint64(n))
SOFT_HELPER(uint32_t, __aeabi_d2iz, (uint64_t a), soft64_to_int32(a))
SOFT_HELPER(uint32_t, __aeabi_d2uiz, (uint64_t a), soft64_to_uint32(a))
SOFT_HELPER(uint64_t, __aeabi_d2lz, (uint64_t a), soft64_to_int64(a))
SOFT_HELPER(uint64_t, __aeabi_d2ulz, (uint64_t a), soft64_to_uint64(a))
SOFT_HELPER(uint64_t, __aeabi_f2d, (uint32_t a), soft64_from_binary32(a))
SOFT_HELPER(uint32_t, __aeabi_d2f, (uint64_t a), soft64_to_binary32(a))
