/* A force and its opposite on two bodies in space, by a spring between two of their points. Linear momentum is
 * constant, and without damping the energy, to what rk4 leaves out; with damping the energy only falls. */
#include <float.h>
#include <math.h>

#include PLANT
#include "core/runtime/tick.h"
#include "tests/host/report.h"

enum { TICKS = 2000 };

static const double mass[2] = {1.0, 2.0}, inertia[2] = {0.02, 0.03}, stiffness = 100.0;
static const int speeds[2] = {PLANT_X_FIRST_X_SPEED, PLANT_X_SECOND_X_SPEED};
static const int spins[2] = {PLANT_X_FIRST_TURN_X_SPEED, PLANT_X_SECOND_TURN_X_SPEED};

static double energy(const iso_plant *const plant)
{
    double sum = 0.0;
    for (int i = 0; i < 3; i++) {
        const double gap = (double)(plant->y[PLANT_Y_OTHER_X + i] - plant->y[PLANT_Y_THIS_X + i]);
        sum += 0.5 * stiffness * gap * gap;
        for (int b = 0; b < 2; b++) {
            const double v = (double)plant->x[speeds[b] + i], w = (double)plant->x[spins[b] + i];
            sum += 0.5 * mass[b] * v * v + 0.5 * inertia[b] * w * w;
        }
    }
    return sum;
}

/* The functions of vectors, against the same from the two points. */
static bool agrees(const iso_plant *const plant)
{
    double square = 0.0;
    for (int i = 0; i < 3; i++) {
        const double gap = (double)(plant->y[PLANT_Y_OTHER_X + i] - plant->y[PLANT_Y_THIS_X + i]);
        square += gap * gap;
    }
    return fabs((double)plant->y[PLANT_Y_LENGTH] - sqrt(square)) <= 8.0 * DBL_EPSILON * sqrt(square) &&
           fabs((double)plant->y[PLANT_Y_ACROSS]) <= 64.0 * DBL_EPSILON * square &&
           fabs((double)plant->y[PLANT_Y_ENERGY] - energy(plant)) <= 16.0 * DBL_EPSILON * energy(plant);
}

static double momentum(const iso_plant *const plant, const int i)
{
    return mass[0] * (double)plant->x[speeds[0] + i] + mass[1] * (double)plant->x[speeds[1] + i];
}

int main(void)
{
    const iso_plant *const plant = &iso_the_plant;
    for (int damped = 0; damped < 2; damped++) {
        iso_plant_start(plant);
        plant->p[PLANT_P_DAMPING] = damped ? R(2.0) : R(0.0);
        plant->model->output(plant->memory);
        const double before = energy(plant);
        double first[3], drift = 0.0, change = 0.0, rise = 0.0, last = before;
        for (int i = 0; i < 3; i++) {
            first[i] = momentum(plant, i);
        }
        for (uint32_t tick = 0; tick < TICKS; tick++) {
            (void)iso_plant_tick(plant, tick);
            for (int i = 0; i < 3; i++) {
                drift = fmax(drift, fabs(momentum(plant, i) - first[i]));
            }
            const double now = energy(plant);
            change = fmax(change, fabs(now - before) / before);
            rise = fmax(rise, (now - last) / before);
            last = now;
        }
        /* The fastest motion is below sqrt(k r^2 / J + k / m) = 20 rad/s: of it rk4 leaves out (20 h)^5 / 120 in a
         * step. Of the momentum as well, as the quaternions within a step have not quite the length one. */
        const double left_out = 2.0 * pow(20e-3, 5.0) / 120.0;
        const double largest = sqrt(2.0 * before * (mass[0] + mass[1]));
        report_ok(drift <= left_out * TICKS * largest, "the momentum stays: %.2g kg*m/s of at most %.2g", drift,
                  largest);
        report_ok(agrees(plant), "dot, cross and norm, and the stored energy");
        if (damped) {
            report_ok(rise <= left_out && last < 0.9 * before, "damping takes energy in every tick, %.3g of it in all",
                      1.0 - last / before);
        } else {
            report_ok(change <= left_out * TICKS, "the energy stays: %.2g of it changes", change);
        }
    }
    return report_done();
}
