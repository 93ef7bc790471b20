/* The states that a plant says move steadily, on the way of a run: their derivative keeps its bits, and they are where
 * it takes them from their start. */
#include PLANT

#include "tests/host/report.h"
#include <math.h>

int main(void)
{
    enum { TICKS = 2000 };
    const iso_plant *const plant = &iso_the_plant;
    real first[PLANT_STATES], now[PLANT_STATES];
    int count = 0, changed = 0;
    double off = 0.0;
    iso_plant_start(plant);
    iso_the_derivative(first, plant->x, plant->u, plant->p);
    for (uint32_t tick = 0; tick < TICKS; tick++) {
        plant->model->step(plant->memory);
        iso_the_derivative(now, plant->x, plant->u, plant->p);
        for (int s = 0; s < PLANT_STATES; s++) {
            changed += steady[s] && now[s] != first[s];
        }
    }
    /* A step rounds its product and its sum, each of at most the largest size on the way. */
    for (int s = 0; s < PLANT_STATES; s++) {
        const double moved = TICKS * (double)plant->model->step_size * (double)first[s],
                     begin = (double)plant->model->start[s];
        count += steady[s];
        off = fmax(off, steady[s] ? fabs((double)plant->x[s] - begin - moved) / (fabs(begin) + fabs(moved)) : 0.0);
    }
    report_ok(count > 0, "%d states move steadily", count);
    report_ok(changed == 0, "their derivatives keep their bits: %d have others", changed);
    report_ok(off <= TICKS * (double)ISO_REAL_EPSILON, "they are where these take them, to %.2g of their size", off);
    return report_done();
}
