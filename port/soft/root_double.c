/* The square root of a double, in place of that of the C library, on processors without an instruction for it. */
#include <stdint.h>
#include <string.h>

#include "port/soft/binary64.h"

double sqrt(double x);
double sqrt(const double x)
{
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    bits = soft64_root(bits);
    double root;
    memcpy(&root, &bits, sizeof root);
    return root;
}
