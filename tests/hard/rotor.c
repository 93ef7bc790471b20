/* A rotor at 30,000 rpm for 24 hours at 1 kHz: 86.4 million steps of rk4, every one of them taken, half a turn each.
 * The plant is generated from rotor.scene, which keeps the angle in [-pi, pi) and counts the turns beside it
 * (core/numbers/turns.h).
 *
 * What must hold, against the product of the plant's own step and speed in long double:
 *   the angle is that of 43.2 million turns to one epsilon of the whole way, 2.7e8 rad: the way of a step is rounded
 *   once for h / 6, once for the sum of the derivatives and once for their product, always to the same side; the sum
 * with the angle is rounded by half an epsilon of pi at most. That is 32 rad in float and 6e-8 rad in double after a
 * day. The drift is even: compensation, which returns what the sum loses and nothing of what the way lost, makes it
 *   smaller and not zero.
 *   within a second the angle is right to 4e-4 rad in float, in the last second of the day as in the first.
 * Control: the same way summed up in one real without turns. In float it comes to rest where the way of a step is less
 * than half an ulp of the sum.
 */
#include <math.h>

#include "core/runtime/plant.h"
#include "tests/hard/hard.h"

#define DAY 86400
#define TWO_PI 6.283185307179586476925286766559L

enum { RATE = 1000 };

/* The angle since the start, turns and all; the turns stand behind the outputs in the plant's memory. */
static long double angle(const iso_plant *const plant)
{
    int32_t turns = 0;
    memcpy(&turns, plant->y + plant->model->outputs, sizeof turns);
    return TWO_PI * (long double)turns + (long double)plant->x[0];
}

int main(void)
{
    const iso_plant *const plant = &iso_the_plant;
    const real step = plant->model->step_size * plant->model->start[1];
    const long double way = (long double)plant->model->step_size * (long double)plant->model->start[1];
    const long double epsilon = (long double)ISO_REAL_EPSILON;
    long double error[3] = {0.0L, 0.0L, 0.0L}; /* after a second, a second before the end, at the end */
    real sum = R(0.0);
    bool inside = true;

    memcpy(plant->x, plant->model->start, plant->model->states * sizeof *plant->x);
    for (long i = 1; i <= (long)DAY * RATE; i++) {
        plant->model->step(plant->memory);
        sum += step;
        inside = inside && fabs((double)plant->x[0]) < 3.1415930;
        if (i == RATE || i == (long)(DAY - 1) * RATE || i == (long)DAY * RATE) {
            error[i == RATE ? 0 : (i == (long)DAY * RATE ? 2 : 1)] = angle(plant) - (long double)i * way;
        }
    }
    report_ok(inside, "the angle stays in [-pi, pi)");
    report_ok(fabsl(error[2]) <= epsilon * way * RATE * DAY, "after %d s the angle is %.2Le rad off", DAY, error[2]);
    const long double second = fabsl(error[2] - error[1]);
    report_ok(fabsl(error[0]) <= epsilon * way * RATE && second <= epsilon * way * RATE,
              "within the first second it goes %.2Le rad astray, within the last %.2Le", fabsl(error[0]), second);
    const long double lost = fabsl((long double)sum - way * RATE * DAY);
    report_ok(lost > 10.0L * fabsl(error[2]), "control: a plain sum is %.2Le rad off", lost);
    return report_done();
}
