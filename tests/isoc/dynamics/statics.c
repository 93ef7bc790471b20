/* The reactions of statics.scene at its start, by hand, in the order of its outputs. Linked with its plant. */
#include <math.h>

#include "core/runtime/plant.h"
#include "tests/host/report.h"

/* Sums of some ten products of numbers up to 40. */
#define TOLERANCE (16.0 * 40.0 * (double)ISO_REAL_EPSILON)

static const struct {
    const char *what;
    int count;
    double value[3];
} expected[] = {
    {"a weight of 2 kg hangs", 3, {0.0, 0.0, 20.0}},
    {"a wall bears a beam of 3 kg with a lamp of 1 kg", 3, {0.0, 0.0, 40.0}},
    {"their moment, 0.5 m and 1 m out", 3, {0.0, -25.0, 0.0}},
    {"the lamp alone", 3, {0.0, 0.0, 10.0}},
    {"the lamp has no lever", 3, {0.0, 0.0, 0.0}},
    {"a stone is whirled along x: m r omega^2 inwards", 3, {10.0, 0.0, 5.0}},
    {"the stone's weight at its lever", 3, {0.0, 1.0, 0.0}},
    {"a driven rotor's weight", 1, {10.0}},
    {"the torque that drives it", 1, {3.0}},
    {"a bridge of 4 kg on two supports, three quarters on the nearer", 3, {0.0, 0.0, 30.0}},
    {"and a quarter on the other", 3, {0.0, 0.0, 10.0}},
    {"a gear lifts 2 kg evenly", 1, {20.0}},
    {"its motor, at a lever of 0.1 m, turns at 2 rad/s against 0.5 N m s/rad", 1, {3.0}},
    {"the motor less the damping and the gear: nothing is sped up", 1, {0.0}},
};

int main(void)
{
    iso_plant_start(&iso_the_plant);
    iso_the_plant.model->output(iso_the_plant.memory);
    const real *y = iso_the_plant.y;
    for (size_t i = 0; i < sizeof expected / sizeof expected[0]; i++) {
        double worst = 0.0;
        for (int n = 0; n < expected[i].count; n++) {
            worst = fmax(worst, fabs((double)*y++ - expected[i].value[n]));
        }
        report_ok(worst <= TOLERANCE, "%s: off by %.1e N or N m", expected[i].what, worst);
    }
    report_ok(y == iso_the_plant.y + iso_the_plant.model->outputs, "these are all outputs");
    return report_done();
}
