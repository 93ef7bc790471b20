#include "core/numbers/self_check.h"

ISO_RARE bool iso_self_check(void)
{
    return iso_bits_are_kept();
}
