/* Load cells take at the end of each tick what the outputs of the scene show of the same joint or closure then. */
#include <float.h>
#include <math.h>

#include PLANT
#include "core/runtime/tick.h"
#include "tests/host/report.h"

/* Each is sums of some hundred products, which may be shared and ordered otherwise where other values are computed too.
 */
#define TOLERANCE (200.0 * (sizeof(real) == sizeof(float) ? (double)FLT_EPSILON : DBL_EPSILON))

/* How far the first of so many is from the second, and the largest of these. */
static void compare(const real *a, const real *b, int count, double *off, double *largest)
{
    for (int i = 0; i < count; i++) {
        *off = fmax(*off, fabs((double)a[i] - (double)b[i]));
        *largest = fmax(*largest, fabs((double)b[i]));
    }
}

int main(void)
{
    const iso_plant *const plant = &iso_the_plant;
    const real *const y = plant->y;
    bool same = true;
    double forces = 0.0, force = 0.0, moments = 0.0, moment = 0.0, others = 0.0, other = 0.0;
    iso_plant_start(plant);
    for (uint32_t tick = 0; tick < 200; tick++) {
        (void)iso_plant_tick(plant, tick);
        compare(y + PLANT_Y_FELT_X, y + PLANT_Y_FORCE_X, 3, &forces, &force);
        compare(y + PLANT_Y_TURNED_X, y + PLANT_Y_MOMENT_X, 3, &moments, &moment);
        compare(y + PLANT_Y_PASSED, y + PLANT_Y_THROUGH_Y, 1, &others, &other);
        same = same && y[PLANT_Y_NOW] == y[PLANT_Y_FORCE_Y] && y[PLANT_Y_IN_SCENE] == y[PLANT_Y_FORCE_Y];
    }
    report_ok(force > 0.0 && forces <= TOLERANCE * force, "the force of a joint: %.2g of %.3g N off", forces, force);
    report_ok(moments <= TOLERANCE * (force + moment), "its moment: %.2g of %.3g N*m off", moments, moment);
    report_ok(other > 0.0 && others <= TOLERANCE * other, "another connection: %.2g of %.3g N off", others, other);
    report_ok(same, "a formula of an output is the output");
    return report_done();
}
