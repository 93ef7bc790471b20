/* winding LEAST MOST: the current of a winding whose voltage is reversed by an angle, against its exact solution, which
 * is an exponential between two jumps. What a jump adds to the error is the jump of the rate times the time by which
 * the method misplaces it: the largest of these times lies between so many steps. */
#include <math.h>
#include <stdlib.h>

#include "core/runtime/tick.h"
#include "tests/host/report.h"

/* Of winding.scene: A, 1/s; s between two jumps. The voltage begins with its positive half. */
static const double most = 6.0, decay = 10.0;
static const double between = 3.14159265358979323846 / 1325.0;

int main(int count, char **words)
{
    const iso_plant *const plant = &iso_the_plant;
    const double least_steps = count == 3 ? atof(words[1]) : 1.0, most_steps = count == 3 ? atof(words[2]) : 0.0;
    const double h = (double)plant->model->step_size, jump = 2.0 * most * decay;
    double exact = 0.0, error = 0.0, largest = 0.0;
    long k = 0;
    iso_plant_start(plant);
    /* In the middle between two jumps, on a tick, where a method with a history has settled. */
    for (long i = 1; i <= 400; i++) {
        const double sign = i % 2 == 1 ? 1.0 : -1.0, begins = (double)(i - 1) * between;
        const long middle = (long)((begins + 0.5 * between) / h);
        const double since = (double)middle * h - begins;
        while (k < middle) {
            plant->model->step(plant->memory);
            k++;
        }
        const double here = sign * most + (exact - sign * most) * exp(-decay * since);
        const double found = (double)plant->x[1] - here;
        const double added = fabs(found - error * exp(-decay * between)) / (jump * h);
        largest = i > 1 && added > largest ? added : largest;
        error = found;
        exact = sign * most + (exact - sign * most) * exp(-decay * between);
    }
    report_ok(largest >= least_steps && largest <= most_steps, "%s: a jump is misplaced by up to %.4f steps",
              plant->model->method, largest);
    return report_done();
}
