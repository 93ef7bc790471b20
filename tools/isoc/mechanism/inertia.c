#include "tools/isoc/mechanism/builder.h"

#include <math.h>
#include <stdbool.h>

/* Rounding in a tensor that was computed by hand or rotated: relative to its trace. */
static const double slack = 1e-9;

/* All principal minors of a symmetric matrix are at least zero, to rounding. */
static bool semidefinite(const double t[6], double scale)
{
    const double xx = t[0], yy = t[1], zz = t[2], xy = t[3], xz = t[4], yz = t[5];
    const double determinant = xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * xz) + xz * (xy * yz - yy * xz);
    const double low = -slack * scale, low2 = low * scale, low3 = low2 * scale;
    return xx >= low && yy >= low && zz >= low && xx * yy - xy * xy >= low2 && xx * zz - xz * xz >= low2 &&
           yy * zz - yz * yz >= low2 && determinant >= low3;
}

const char *inertia_fault(const double t[6])
{
    const double scale = fabs(t[0]) + fabs(t[1]) + fabs(t[2]);
    if (!semidefinite(t, scale)) {
        return "is not positive definite: a principal moment is negative";
    }
    /* The second moments of the mass, half the trace times 1 minus the tensor, are a sum of squares. */
    const double half = (t[0] + t[1] + t[2]) / 2;
    const double moments[6] = {half - t[0], half - t[1], half - t[2], -t[3], -t[4], -t[5]};
    if (!semidefinite(moments, scale)) {
        return "is impossible: a principal moment is larger than the sum of the other two";
    }
    return NULL;
}
