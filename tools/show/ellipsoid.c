#include "tools/show/ellipsoid.h"

/* A turn in the plane of axes i and j that makes the element at i, j zero (Jacobi 1846): a becomes q' a q, v becomes v
 * q. */
static void turn_plane(double a[3][3], double v[3][3], int i, int j)
{
    if (a[i][j] == 0.0) {
        return;
    }
    const double theta = (a[j][j] - a[i][i]) / (2.0 * a[i][j]);
    const double t = (theta < 0.0 ? -1.0 : 1.0) / (fabs(theta) + sqrt(theta * theta + 1.0));
    const double c = 1.0 / sqrt(t * t + 1.0), s = t * c;
    for (int k = 0; k < 3; k++) {
        const double x = a[k][i], y = a[k][j];
        a[k][i] = c * x - s * y;
        a[k][j] = s * x + c * y;
    }
    for (int k = 0; k < 3; k++) {
        const double x = a[i][k], y = a[j][k];
        a[i][k] = c * x - s * y;
        a[j][k] = s * x + c * y;
    }
    for (int k = 0; k < 3; k++) {
        const double x = v[k][i], y = v[k][j];
        v[k][i] = c * x - s * y;
        v[k][j] = s * x + c * y;
    }
}

ellipsoid ellipsoid_of(const shape_lump *l)
{
    enum { SWEEPS = 12 };
    const double *t = l->inertia, half = (t[0] + t[1] + t[2]) / 2;
    /* The second moments of the mass. */
    double a[3][3] = {{half - t[0], -t[3], -t[4]}, {-t[3], half - t[1], -t[5]}, {-t[4], -t[5], half - t[2]}};
    double v[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (int n = 0; n < SWEEPS; n++) {
        turn_plane(a, v, 0, 1);
        turn_plane(a, v, 0, 2);
        turn_plane(a, v, 1, 2);
    }
    const vec z = outer((vec){v[0][0], v[1][0], v[2][0]}, (vec){v[0][1], v[1][1], v[2][1]});
    const double over = l->mass > 0.0 ? 3.0 / l->mass : 0.0;
    return (ellipsoid){{{{v[0][0], v[0][1], z.x}, {v[1][0], v[1][1], z.y}, {v[2][0], v[2][1], z.z}}, l->centre},
                       {sqrt(fmax(over * a[0][0], 0)), sqrt(fmax(over * a[1][1], 0)), sqrt(fmax(over * a[2][2], 0))}};
}
