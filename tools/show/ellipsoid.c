#include "tools/isoc/base/numbers.h"
#include "tools/show/show.h"

ellipsoid ellipsoid_of(const shape_lump *l)
{
    double moment[3], axis[3][3];
    principal_axes(l->inertia, moment, axis);
    const vec z = outer((vec){axis[0][0], axis[1][0], axis[2][0]}, (vec){axis[0][1], axis[1][1], axis[2][1]});
    const double half = (moment[0] + moment[1] + moment[2]) / 2, over = l->mass > 0.0 ? 3.0 / l->mass : 0.0;
    /* half - moment: the second moments of the mass. */
    return (ellipsoid){
        {{{axis[0][0], axis[0][1], z.x}, {axis[1][0], axis[1][1], z.y}, {axis[2][0], axis[2][1], z.z}}, l->centre},
        {sqrt(fmax(over * (half - moment[0]), 0)), sqrt(fmax(over * (half - moment[1]), 0)),
         sqrt(fmax(over * (half - moment[2]), 0))}};
}
