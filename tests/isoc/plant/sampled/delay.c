/* x'' = -w^2 x(t - tau) from x = 1 at rest, where x was 1 before: by steps (Bellman and Cooke 1963,
 * Differential-Difference Equations, ch. 3) x is a sum over all k with t > (k - 1) tau of (-w^2)^k (t - (k - 1) tau)^(2
 * k) / (2 k)!, and 1 for k = 0. Prints the error of the plant at the end, over the largest x. */
#include <math.h>
#include <stdio.h>

#include PLANT
#include "core/runtime/tick.h"

static long double solution(const long double t, const long double tau, const long double w)
{
    long double sum = 1.0L;
    for (int k = 1; t > (k - 1) * tau; k++) {
        long double term = 1.0L;
        for (int i = 1; i <= 2 * k; i++) {
            term *= (t - (k - 1) * tau) / i;
        }
        sum += term * powl(-w * w, k);
    }
    return sum;
}

int main(void)
{
    const iso_plant *const plant = &iso_the_plant;
    const long double h = (long double)plant->model->step_size;
    const uint64_t ticks = (uint64_t)(1.6L / h + 0.5L);
    iso_plant_start(plant);
    for (uint64_t tick = 0; tick < ticks; tick++) {
        (void)iso_plant_tick(plant, tick);
    }
    printf("%.6Le\n", fabsl((long double)plant->x[PLANT_X_J] - solution(ticks * h, TAU, 5.0L)));
    return 0;
}
