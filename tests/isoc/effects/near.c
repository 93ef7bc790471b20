/* Two plants, old and other, that differ only in rounding: the largest difference of their derivatives, at the start
 * and along the way of the first, over the largest derivative. */
#include <float.h>
#include <math.h>

#include "core/runtime/tick.h"
#include "old.h"
#include "other.h"
#include "tests/host/report.h"

int main(void)
{
    enum { TICKS = 500 };
    static old_memory of_old;
    static other_memory of_other;
    const iso_plant old = old_plant(&of_old), other = other_plant(&of_other);
    double off = 0.0, largest = 0.0;
    iso_plant_start(&old);
    iso_plant_start(&other);
    for (uint32_t tick = 0; tick < TICKS; tick++) {
        real a[OLD_STATES], b[OLD_STATES];
        (void)iso_plant_tick(&old, tick);
        old_derivative(a, old.x, old.u, old.p);
        other_derivative(b, old.x, old.u, other.p);
        for (int i = 0; i < OLD_STATES; i++) {
            off = fmax(off, fabs((double)(a[i] - b[i])));
            largest = fmax(largest, fabs((double)a[i]));
        }
    }
    /* From body to ground and back: two products of matrices whose rows have length one, and the lever. */
    report_ok(off <= 40.0 * DBL_EPSILON * largest, "%.2g of %.2g off", off, largest);
    return report_done();
}
