/* Those of the helpers of gcc.c that a core may have in instructions of its own, as the AVR in avr_sum.S and
 * avr_product.S. */
#include "port/soft/helper.h"

SOFT_HELPER(uint32_t, __addsf3, (uint32_t a, uint32_t b), soft_add(a, b))
SOFT_HELPER(uint32_t, __subsf3, (uint32_t a, uint32_t b), soft_subtract(a, b))
SOFT_HELPER(uint32_t, __mulsf3, (uint32_t a, uint32_t b), soft_multiply(a, b))
