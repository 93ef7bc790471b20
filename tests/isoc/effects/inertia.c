/* The inertia that is met at a point, or at a joint, against the plant itself: from rest and without weight, in a step
 * of euler a push alone gives the speed step * push / inertia. */
#include <float.h>
#include <math.h>

#include PLANT
#include "core/runtime/tick.h"
#include "tests/host/report.h"

#ifdef ISO_REAL_DOUBLE
#define ULP DBL_EPSILON
#else
#define ULP ((double)FLT_EPSILON)
#endif

enum { PUSHES = PLANT_INPUTS };

int main(void)
{
    static const char *const names[PUSHES] = {"x of the ground", "y of the ground", "z of the ground", "x of the hand",
                                              "y of the hand",   "z of the hand",   "a joint"};
    const iso_plant *const plant = &iso_the_plant;
    for (int push = 0; push < PUSHES; push++) {
        iso_plant_start(plant);
        for (int i = 0; i < PUSHES; i++) {
            plant->u[PLANT_U_PUSH1 + i] = i == push ? R(2.0) : R(0.0);
        }
        (void)iso_plant_tick(plant, 0);
        const double met = (double)plant->y[PLANT_Y_MET1 + push];
        const double seen = 1e-3 * 2.0 / (double)plant->y[PLANT_Y_V1 + push], off = fabs(seen / met - 1.0);
        /* Some hundred roundings of numbers whose differences are a tenth of them. */
        report_ok(off <= 1000.0 * ULP, "along %s: %.6g, %.2g off", names[push], met, off);
    }
    return report_done();
}
