#include "tools/isoc/base/numbers.h"

#include <math.h>
#include <string.h>

enum { SWEEPS = 20 }; /* the convergence is quadratic */

/* The rotation of p and q that makes a[p][q] zero, also of the axes. */
static void rotate(double a[3][3], double axes[3][3], int p, int q)
{
    const double half = (a[q][q] - a[p][p]) / (2.0 * a[p][q]);
    const double t = (half < 0.0 ? -1.0 : 1.0) / (fabs(half) + sqrt(1.0 + half * half));
    const double c = 1.0 / sqrt(1.0 + t * t), s = t * c;
    for (int i = 0; i < 3; i++) {
        const double x = a[i][p], y = a[i][q], z = axes[i][p], w = axes[i][q];
        a[i][p] = c * x - s * y, a[i][q] = s * x + c * y;
        axes[i][p] = c * z - s * w, axes[i][q] = s * z + c * w;
    }
    for (int i = 0; i < 3; i++) {
        const double x = a[p][i], y = a[q][i];
        a[p][i] = c * x - s * y, a[q][i] = s * x + c * y;
    }
}

void principal_axes(const double inertia[6], double moments[3], double axes[3][3])
{
    double a[3][3] = {{inertia[0], inertia[3], inertia[4]},
                      {inertia[3], inertia[1], inertia[5]},
                      {inertia[4], inertia[5], inertia[2]}};
    static const double unit[3][3] = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};
    memcpy(axes, unit, sizeof unit);
    for (int pair = 0; pair < 3 * SWEEPS; pair++) {
        const int p = pair % 3 == 2 ? 1 : 0, q = pair % 3 == 0 ? 1 : 2;
        if (a[p][q] != 0.0) {
            rotate(a, axes, p, q);
            a[p][q] = a[q][p] = 0.0;
        }
    }
    for (int i = 0; i < 3; i++) {
        moments[i] = a[i][i];
    }
}
