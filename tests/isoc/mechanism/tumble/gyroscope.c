/* The gyroscope of models/gyroscope.scene over 20 s: the rate at which it precesses. */
#include <math.h>

#include "core/runtime/plant.h"
#include "tests/host/report.h"

/* Outputs and a state of the scene. */
enum { AZIMUTH = 0, TURNS = 1, INNER = 1 };

int main(void)
{
    const double pi = 3.14159265358979323846, steady = 0.1962, seconds = 20.0;
    double elevation = 0.0;
    iso_plant_start(&iso_the_plant);
    for (int n = 0; n < 20000; n++) {
        iso_the_plant.model->step(iso_the_plant.memory);
        elevation = fmax(elevation, fabs((double)iso_the_plant.x[INNER]));
    }
    iso_the_plant.model->output(iso_the_plant.memory);
    const double angle = (double)iso_the_plant.y[AZIMUTH] + 2.0 * pi * (double)iso_the_plant.y[TURNS];
    const double rate = angle / seconds;
    report_ok(fabs(rate / steady - 1.0) <= 1e-3, "it precesses at %.6f rad/s: %.6f within 1e-3", rate, steady);
    report_ok(elevation <= 1e-3, "its axle stays level within %.2e rad, at most 1e-3", elevation);
    return report_done();
}
