/* The helpers by which code for an Arm core without a floating-point unit computes with float, in place of libgcc's.
 * Arm (2023), Run-time ABI for the Arm Architecture, version 2023Q3: 5.1.2 and 5.1.3. A number comes and goes in a
 * register of integers. */
#include "port/soft/helper.h"

SOFT_HELPER(uint32_t, __aeabi_fadd, (uint32_t a, uint32_t b), soft_add(a, b))
SOFT_HELPER(uint32_t, __aeabi_fsub, (uint32_t a, uint32_t b), soft_subtract(a, b))
SOFT_HELPER(uint32_t, __aeabi_frsub, (uint32_t a, uint32_t b), soft_subtract(b, a))
SOFT_HELPER(uint32_t, __aeabi_fmul, (uint32_t a, uint32_t b), soft_multiply(a, b))
SOFT_HELPER(uint32_t, __aeabi_fdiv, (uint32_t a, uint32_t b), soft_divide(a, b))
SOFT_HELPER(uint32_t, __aeabi_fcmpeq, (uint32_t a, uint32_t b), soft_is_equal(a, b))
SOFT_HELPER(uint32_t, __aeabi_fcmplt, (uint32_t a, uint32_t b), soft_is_less(a, b))
SOFT_HELPER(uint32_t, __aeabi_fcmple, (uint32_t a, uint32_t b), soft_is_at_most(a, b))
SOFT_HELPER(uint32_t, __aeabi_fcmpge, (uint32_t a, uint32_t b), soft_is_at_most(b, a))
SOFT_HELPER(uint32_t, __aeabi_fcmpgt, (uint32_t a, uint32_t b), soft_is_less(b, a))
SOFT_HELPER(uint32_t, __aeabi_fcmpun, (uint32_t a, uint32_t b), soft_is_unordered(a, b))
SOFT_HELPER(uint32_t, __aeabi_i2f, (uint32_t n), soft_from_int32(n))
SOFT_HELPER(uint32_t, __aeabi_ui2f, (uint32_t n), soft_from_uint32(n))
SOFT_HELPER(uint32_t, __aeabi_l2f, (uint64_t n), soft_from_int64(n))
SOFT_HELPER(uint32_t, __aeabi_ul2f, (uint64_t n), soft_from_uint64(n))
SOFT_HELPER(uint32_t, __aeabi_f2iz, (uint32_t a), soft_to_int32(a))
SOFT_HELPER(uint32_t, __aeabi_f2uiz, (uint32_t a), soft_to_uint32(a))
SOFT_HELPER(uint64_t, __aeabi_f2lz, (uint32_t a), soft_to_int64(a))
SOFT_HELPER(uint64_t, __aeabi_f2ulz, (uint32_t a), soft_to_uint64(a))
