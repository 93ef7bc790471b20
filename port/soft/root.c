/* The square root that the C library has for processors without an instruction for it, in place of that one. */
#include <stdint.h>
#include <string.h>

#include "port/soft/binary32.h"

float sqrtf(float x);
float sqrtf(const float x)
{
    uint32_t bits;
    memcpy(&bits, &x, sizeof bits);
    bits = soft_root(bits);
    float root;
    memcpy(&root, &bits, sizeof root);
    return root;
}
