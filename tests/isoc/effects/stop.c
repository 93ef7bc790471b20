/* A block between two stops, as stiff as method and step allow: an impact leaves the speed of its law (impact.h), and
 * gives no energy. */
#include <math.h>

#include PLANT
#include "core/runtime/tick.h"
#include "tests/host/report.h"
#include "tests/isoc/effects/impact.h"

int main(void)
{
    const iso_plant *const plant = &iso_the_plant;
    iso_plant_start(plant);
    plant->model->output(plant->memory);
    const double first = (double)plant->y[PLANT_Y_ENERGY];
    double worst = 0.0, most = 0.0, deepest = 0.0, last = 1.0;
    int impacts = 0;
    for (uint32_t tick = 0; tick < 4000 && impacts < 4; tick++) {
        (void)iso_plant_tick(plant, tick);
        const double v = (double)plant->y[PLANT_Y_SPEED], x = (double)plant->y[PLANT_Y_PLACE];
        deepest = fmax(deepest, fmax(x - 0.15, -0.1 - x));
        /* Free again, with the other sign of the speed. */
        if (v * last < 0.0 && x < 0.15 && x > -0.1) {
            impacts++;
            const double expected = speed_after(fabs(last), damping_of(0.8));
            most = fmax(most, (double)plant->y[PLANT_Y_ENERGY]);
            worst = fmax(worst, fabs(fabs(v) - expected) / expected);
            last = v;
        }
    }
    report_ok(impacts == 4 && worst <= TOLERANCE,
              "four impacts leave what the law says: %.2g off, at most %.2g; %.2g m deep", worst, TOLERANCE, deepest);
    report_ok(most < first, "no impact gives energy: %.2g of it is left", most / first);
    return report_done();
}
