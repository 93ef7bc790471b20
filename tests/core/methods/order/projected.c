/* The projection ends where the closures hold to the first order, in positions and in speeds: of a state that is off by
 * d it leaves an error of the order d^2, which a second projection shows. In double.
 *
 *     projected
 */
#include <math.h>
#include <string.h>

#include "tests/core/methods/order/settled.h"
#include "tests/host/report.h"

enum { STATES_MAX = 40, HALVINGS = 3 };

static const double order_tolerance = 0.1;

/* What a second projection moves after a first one, where all states are off by about d. */
static double left_of(const double d)
{
    const iso_model *const model = iso_the_plant.model;
    real x[STATES_MAX], first[STATES_MAX];
    double square = 0.0;
    for (uint16_t s = 0; s < model->states; s++) {
        x[s] = model->start[s] + (real)(d * cos(1.0 + 2.7 * s));
    }
    the_settle(x);
    memcpy(first, x, sizeof first);
    the_settle(x);
    for (uint16_t s = 0; s < model->states; s++) {
        square += (double)((x[s] - first[s]) * (x[s] - first[s]));
    }
    return sqrt(square);
}

int main(void)
{
    double left = 0.0, order = 0.0;
    bool passed = report_ok(iso_the_plant.model->states <= STATES_MAX, "the plant fits");
    for (int i = 0; i <= HALVINGS && passed; i++) {
        const double coarse = left;
        left = left_of(ldexp(1.0, -10 - i));
        order = log2(coarse / left);
    }
    report_ok(fabs(order - 2.0) <= order_tolerance, "the projection leaves %.2e, order %.3f", left, order);
    return report_done();
}
