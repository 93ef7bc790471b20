/* The helpers by which code for an Arm core without a floating-point unit computes with float, in place of libgcc's.
 * Arm (2023), Run-time ABI for the Arm Architecture, version 2023Q3: 5.1.2 and 5.1.3. A number comes and goes in a register
 * of integers. */
#include <stdint.h>

#include "port/soft/binary32.h"

/* The function __aeabi_NAME with these parameters is this expression. */
#define HELPER(type, name, parameters, expression)                                                                     \
    type __aeabi_##name parameters;                                                                                    \
    type __aeabi_##name parameters                                                                                     \
    {                                                                                                                  \
        return expression;                                                                                             \
    }

HELPER(uint32_t, fadd, (uint32_t a, uint32_t b), soft_add(a, b))
HELPER(uint32_t, fsub, (uint32_t a, uint32_t b), soft_subtract(a, b))
HELPER(uint32_t, frsub, (uint32_t a, uint32_t b), soft_subtract(b, a))
HELPER(uint32_t, fmul, (uint32_t a, uint32_t b), soft_multiply(a, b))
HELPER(uint32_t, fdiv, (uint32_t a, uint32_t b), soft_divide(a, b))
HELPER(uint32_t, fcmpeq, (uint32_t a, uint32_t b), soft_is_equal(a, b))
HELPER(uint32_t, fcmplt, (uint32_t a, uint32_t b), soft_is_less(a, b))
HELPER(uint32_t, fcmple, (uint32_t a, uint32_t b), soft_is_at_most(a, b))
HELPER(uint32_t, fcmpge, (uint32_t a, uint32_t b), soft_is_at_most(b, a))
HELPER(uint32_t, fcmpgt, (uint32_t a, uint32_t b), soft_is_less(b, a))
HELPER(uint32_t, fcmpun, (uint32_t a, uint32_t b), soft_is_unordered(a, b))
HELPER(uint32_t, i2f, (uint32_t n), soft_from_int32(n))
HELPER(uint32_t, ui2f, (uint32_t n), soft_from_uint32(n))
HELPER(uint32_t, l2f, (uint64_t n), soft_from_int64(n))
HELPER(uint32_t, ul2f, (uint64_t n), soft_from_uint64(n))
HELPER(uint32_t, f2iz, (uint32_t a), soft_to_int32(a))
HELPER(uint32_t, f2uiz, (uint32_t a), soft_to_uint32(a))
HELPER(uint64_t, f2lz, (uint32_t a), soft_to_int64(a))
HELPER(uint64_t, f2ulz, (uint32_t a), soft_to_uint64(a))
