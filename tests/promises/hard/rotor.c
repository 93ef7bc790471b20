/* A rotor that turns freely: rotor.scene, whose angle is kept in [-pi, pi) with its whole turns beside it
 * (core/numbers/turns.h), for as many ticks as the argument says, at the speed of the scene and at others.
 *
 * The angle must be that of the exact product of time and speed, to what a real of this size can say (half an ulp of pi
 * is an epsilon), and to what the parts of a turn and of the step leave: half an epsilon of the last part of pi/2, and
 * of h_rest, which is half an epsilon of h. Both are below epsilon^2 of the way. In double, what this test computes in
 * long double has the larger error.
 *
 * Control: what a plain sum of the steps' ways is off.
 */
#include <float.h>
#include <math.h>
#include <stdlib.h>

#include "core/runtime/tick.h"
#include "plant.h"
#include "tests/host/report.h"

#define TWO_PI 6.283185307179586476925286766559L

/* The angle since the start, turns and all. The output of turns is a real, which does not hold those of a day. */
static long double angle(const iso_plant *const plant)
{
    const plant_memory *const memory = plant->memory;
    return TWO_PI * (long double)memory->turns[0] + (long double)plant->x[0];
}

/* *plain: how many limits a plain sum is off. */
static void turn(const real speed, const long ticks, long double *const plain)
{
    const iso_plant *const plant = &iso_the_plant;
    const long double period = (long double)plant->model->period_ns / 1e9L, way = period * (long double)speed;
    const long double epsilon = (long double)ISO_REAL_EPSILON;
    long double most = 0.0L;
    real sum = R(0.0);
    iso_plant_start(plant);
    plant->x[1] = speed;
    if (plant->model->prime != NULL) {
        plant->model->prime(plant->memory);
    }
    for (long i = 1; i <= ticks; i++) {
        plant->model->step(plant->memory);
        sum += plant->model->step_size * speed;
        if (i % 1000 == 0 || i == ticks) {
            most = fmaxl(most, fabsl(angle(plant) - (long double)i * way));
        }
    }
    const long double gone = fabsl(way) * (long double)ticks;
    const long double limit = epsilon + (epsilon * epsilon + 2.0L * LDBL_EPSILON) * gone;
    report_ok(most <= limit, "%g rad/s: at most %.2Le rad off in %ld ticks, of %.2Le", (double)speed, most, ticks,
              limit);
    *plain = fabsl((long double)sum - way * (long double)ticks) / limit;
}

/* A speed that varies, by a constant damping: each coefficient of a method is rounded by half an epsilon, so that the
 * way is off by an epsilon of itself. The way, by the trapezoidal rule, is exact to h^2 / 12 times the change of the
 * acceleration, 2e-6 of the speed; so far below. */
static void slow_down(const long ticks)
{
    const iso_plant *const plant = &iso_the_plant;
    const long double half = (long double)plant->model->period_ns / 2e9L;
    long double way = 0.0L;
    iso_plant_start(plant);
    for (long i = 1; i <= ticks; i++) {
        way += half * (long double)plant->x[1];
        plant->model->step(plant->memory);
        way += half * (long double)plant->x[1];
    }
    const long double off = fabsl(angle(plant) - way) / way, limit = (long double)ISO_REAL_EPSILON;
    report_ok(off <= limit, "from %g to %g rad/s: %.2Le of the way off, of %.2Le", (double)plant->model->start[1],
              (double)plant->x[1], off, limit);
}

/* rotor TICKS [more]: at the speed of the scene, and more speeds. rotor TICKS slows: where a damping acts. */
int main(const int count, char **const arguments)
{
    const long ticks = count > 1 ? atol(arguments[1]) : 0;
    if (count > 2 && strcmp(arguments[2], "slows") == 0) {
        slow_down(ticks);
        return report_done();
    }
    long double plain = 0.0L;
    if (count > 2) {
        turn(R(500.0), ticks, &plain);
        turn(R(-77.77777), ticks, &plain);
        turn(R(0.001234567), ticks, &plain);
    }
    turn(iso_the_plant.model->start[1], ticks, &plain);
    report_ok(plain > 1000.0L, "control: a plain sum is off by %.1Le times as much", plain);
    return report_done();
}
