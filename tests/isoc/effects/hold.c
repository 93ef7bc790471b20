/* Dry friction: the largest effort over all speeds is `static`, that just below `creep`, for the values of hold.py.
 * Each factor of the formula is rounded once: three ulp. */
#include <float.h>
#include <math.h>

#include PLANT
#include "tests/host/report.h"

#ifdef ISO_REAL_DOUBLE
#define ULP DBL_EPSILON
#else
#define ULP ((double)FLT_EPSILON)
#endif

typedef struct rubbing {
    double most, creep;
    int speed, effort;
} rubbing;

#include "table.h"

enum { COUNT = sizeof all / sizeof all[0], SPEEDS = 4000 };

int main(void)
{
    const iso_plant *const plant = &iso_the_plant;
    iso_plant_start(plant);
    for (int i = 0; i < COUNT; i++) {
        double found = 0.0, wrong = 0.0;
        for (int n = -SPEEDS; n <= SPEEDS; n++) {
            const double part = 1e-6 * pow(1e12, fabs((double)n) / SPEEDS), v = n == 0  ? 1.0 - 8.0 * ULP
                                                                                : n < 0 ? -part
                                                                                        : part;
            plant->x[all[i].speed] = (real)(v * all[i].creep);
            plant->model->output(plant->memory);
            const double effort = (double)plant->y[all[i].effort];
            found = fmax(found, fabs(effort));
            wrong = fmax(wrong, v * effort);
        }
        report_ok(fabs(found - all[i].most) <= 3.0 * ULP * all[i].most && wrong <= 0.0,
                  "it holds %.9g N of %.9g N and no more, against every speed", found, all[i].most);
    }
    return report_done();
}
