/* What passes through the last joint is what its body needs beside its weight: its mass times the specific force at its
 * centre of mass. The memories of a sensor are what the outputs of the same tick show. */
#include <float.h>
#include <math.h>

#include PLANT
#include "core/runtime/tick.h"
#include "tests/host/report.h"

int main(void)
{
    const iso_plant *const plant = &iso_the_plant;
    double off = 0.0, largest = 0.0;
    bool same = true;
    iso_plant_start(plant);
    for (uint32_t tick = 0; tick < 1000; tick++) {
        (void)iso_plant_tick(plant, tick);
        const real *const y = plant->y;
        for (int i = 0; i < 3; i++) {
            off = fmax(off, fabs((double)(y[PLANT_Y_X + i] - y[PLANT_Y_FORCE_X + i])));
            largest = fmax(largest, fabs((double)y[PLANT_Y_FORCE_X + i]));
        }
        same = same && y[PLANT_Y_ALONG] == y[PLANT_Y_ACROSS] && y[PLANT_Y_TURNING] == y[PLANT_Y_ACCELERATION];
    }
    /* Both are sums of some hundred products of numbers of this size. */
    report_ok(off <= 200.0 * DBL_EPSILON * largest, "mass times specific force is the reaction: %.2g of %.2g N off",
              off, largest);
    report_ok(same, "a memory has the accelerations at the end of its tick");
    return report_done();
}
