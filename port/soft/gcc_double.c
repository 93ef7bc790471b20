/* The helpers by which gcc computes with double where a processor has no unit for it, but for Arm, in place of those of
 * libgcc: as in gcc.c. A number of binary64 comes and goes where an integer of 64 bits does, one of binary32 where the
 * processor has it. */
#include <string.h>

#include "port/soft/binary64.h"
#include "port/soft/helper.h"

SOFT_HELPER(uint64_t, __adddf3, (uint64_t a, uint64_t b), soft64_add(a, b))
SOFT_HELPER(uint64_t, __subdf3, (uint64_t a, uint64_t b), soft64_subtract(a, b))
SOFT_HELPER(uint64_t, __muldf3, (uint64_t a, uint64_t b), soft64_multiply(a, b))
SOFT_HELPER(uint64_t, __divdf3, (uint64_t a, uint64_t b), soft64_divide(a, b))
SOFT_HELPER(int, __eqdf2, (uint64_t a, uint64_t b), 1 - (int)soft64_is_equal(a, b))
SOFT_HELPER(int, __nedf2, (uint64_t a, uint64_t b), 1 - (int)soft64_is_equal(a, b))
SOFT_HELPER(int, __ltdf2, (uint64_t a, uint64_t b), -(int)soft64_is_less(a, b))
SOFT_HELPER(int, __ledf2, (uint64_t a, uint64_t b), 1 - (int)soft64_is_at_most(a, b))
SOFT_HELPER(int, __gtdf2, (uint64_t a, uint64_t b), (int)soft64_is_less(b, a))
SOFT_HELPER(int, __gedf2, (uint64_t a, uint64_t b), (int)soft64_is_at_most(b, a) - 1)
SOFT_HELPER(int, __unorddf2, (uint64_t a, uint64_t b), (int)soft64_is_unordered(a, b))
SOFT_HELPER(uint64_t, __floatsidf, (uint32_t n), soft64_from_int32(n))
SOFT_HELPER(uint64_t, __floatunsidf, (uint32_t n), soft64_from_uint32(n))
SOFT_HELPER(uint64_t, __floatdidf, (uint64_t n), soft64_from_int64(n))
SOFT_HELPER(uint64_t, __floatundidf, (uint64_t n), soft64_from_uint64(n))
SOFT_HELPER(uint32_t, __fixdfsi, (uint64_t a), soft64_to_int32(a))
SOFT_HELPER(uint32_t, __fixunsdfsi, (uint64_t a), soft64_to_uint32(a))
SOFT_HELPER(uint64_t, __fixdfdi, (uint64_t a), soft64_to_int64(a))
SOFT_HELPER(uint64_t, __fixunsdfdi, (uint64_t a), soft64_to_uint64(a))

uint64_t __extendsfdf2(float a);
uint64_t __extendsfdf2(const float a)
{
    uint32_t bits;
    memcpy(&bits, &a, sizeof bits);
    return soft64_from_binary32(bits);
}

float __truncdfsf2(uint64_t a);
float __truncdfsf2(const uint64_t a)
{
    const uint32_t bits = soft64_to_binary32(a);
    float number;
    memcpy(&number, &bits, sizeof number);
    return number;
}
