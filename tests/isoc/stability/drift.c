/* drift TIME FREQUENCY: runs a plant of one oscillator for five of these times, in s, in which isoc says that its swing
 * grows by e, and compares: it is the slope of the logarithm of the amplitude over the last four. What a period leaves
 * in that slope is a part of 1 / (frequency time); the time is told to three digits. */
#include <math.h>
#include <stdlib.h>

#include "core/runtime/tick.h"
#include "tests/host/report.h"

static const double digits = 0.005, swing = 0.005;

int main(int count, char **words)
{
    const iso_plant *const plant = &iso_the_plant;
    const double told = count == 3 ? atof(words[1]) : 0.0, frequency = count == 3 ? atof(words[2]) : 0.0;
    const double h = (double)plant->model->step_size;
    const long steps = (long)(5.0 * told / h);
    double sum = 0.0, sum_t = 0.0, sum_y = 0.0, sum_tt = 0.0, sum_ty = 0.0;
    iso_plant_start(plant);
    for (long i = 0; i < steps; i++) {
        plant->model->step(plant->memory);
        if (i >= steps / 5) {
            const double t = (double)i * h, y = log(hypot(frequency * (double)plant->x[0], (double)plant->x[1]));
            sum += 1.0;
            sum_t += t;
            sum_y += y;
            sum_tt += t * t;
            sum_ty += t * y;
        }
    }
    const double measured = (sum * sum_tt - sum_t * sum_t) / (sum * sum_ty - sum_t * sum_y);
    report_ok(fabs(measured - told) <= (digits + swing) * told, "%s: the swing grows by e in %.5g s, told %.5g s",
              plant->model->method, measured, told);
    return report_done();
}
