/* Whether this program computes with the bits that are promised: a short run of arithmetic against its stored result.
 *
 * It finds what no preprocessor sees: fused multiply-add (-std=gnu11 on a processor that has it: -ffp-contract=off is
 * missing), division by a reciprocal, sums in another order, numbers near zero flushed to it or another rounding than to
 * nearest by a mode of the processor, x87. It sees the flags of its own file and the mode of the processor: compile it
 * with those of the plant.
 */
#ifndef ISO_CORE_NUMBERS_SELF_CHECK_H
#define ISO_CORE_NUMBERS_SELF_CHECK_H

#include <stdbool.h>

#include "core/numbers/real.h"

#define iso_self_check ISO_REAL_NAME(iso_self_check)

/* True if the bits are right. A few thousand instructions; call it once, at the start. */
bool iso_self_check(void);

#endif
