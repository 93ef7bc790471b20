/* A block of 2 kg with dry friction, 3 N while it slides and 4 N at rest, with the creep that isoc chooses by method
 * and step. It slides to rest and never gains energy; held against 2 N it creeps at the speed of the closed form and no
 * faster; 5 N tear it off. */
#include <math.h>
#include <string.h>

#include PLANT
#include "core/runtime/tick.h"
#include "tests/host/report.h"

static const double mass = 2.0, sliding = 3.0, static_effort = 4.0;

static void run(const iso_plant *const plant, const double push, const int ticks)
{
    plant->u[PLANT_U_PUSH] = (real)push;
    for (int tick = 0; tick < ticks; tick++) {
        (void)iso_plant_tick(plant, (uint32_t)tick);
    }
}

/* static w (3 - w^2) / 2 = push, w = v / creep, by bisection. */
static double creep_speed(const double push)
{
    double low = 0.0, high = 1.0;
    for (int i = 0; i < 60; i++) {
        const double w = 0.5 * (low + high);
        *(static_effort * w * (3.0 - w * w) / 2.0 < push ? &low : &high) = w;
    }
    return low * CREEP;
}

int main(void)
{
    const iso_plant *const plant = &iso_the_plant;
    const double epsilon = (double)ISO_REAL_EPSILON;
    iso_plant_start(plant);
    plant->model->output(plant->memory);
    double energy = (double)plant->y[PLANT_Y_ENERGY], rise = 0.0;
    const double before = energy;
    for (int tick = 0; tick < 1000; tick++) {
        run(plant, 0.0, 1);
        rise = fmax(rise, (double)plant->y[PLANT_Y_ENERGY] - energy);
        energy = (double)plant->y[PLANT_Y_ENERGY];
    }
    /* bdf4 passes zero a little where it comes to rest: by less than a tenth of the energy at the speed of creep. */
    const double passing = strcmp(plant->model->method, "bdf4") == 0 ? 0.05 * mass * CREEP * CREEP : 0.0;
    report_ok(rise <= 4.0 * epsilon * before + passing, "friction gives no energy: %.2g J in a tick", rise);
    report_ok(fabs((double)plant->y[PLANT_Y_SPEED]) < 1e-3 * CREEP, "the block comes to rest: %.2g m/s",
              (double)plant->y[PLANT_Y_SPEED]);
    report_ok(fabs((double)plant->y[PLANT_Y_LOSS]) <= 4.0 * epsilon * before, "what it loses is its power");

    run(plant, 2.0, 1000);
    const double creeps = (double)plant->y[PLANT_Y_SPEED], expected = creep_speed(2.0);
    /* The effort at rest is known to a few roundings of 4 N; the speed to as many of creep, which
     * isoc prints with nine digits. */
    report_ok(fabs(creeps - expected) <= 32.0 * epsilon * CREEP + 1e-8 * CREEP, "it creeps with %.6g m/s: %.6g", creeps,
              expected);

    /* Beyond the fall of the curve the force on the block is push - sliding. */
    run(plant, 5.0, 1000);
    const double first = (double)plant->y[PLANT_Y_SPEED];
    run(plant, 5.0, 1000);
    const double gained = (double)plant->y[PLANT_Y_SPEED] - first, part = first / (10.0 * CREEP);
    const double most = (5.0 - sliding) / mass, least = most - (static_effort - sliding) / mass / (1.0 + part * part);
    report_ok(gained <= most * (1.0 + 1e-3) && gained >= least * (1.0 - 1e-3), "5 N tear it off: %.4g m/s in a second",
              gained);
    return report_done();
}
