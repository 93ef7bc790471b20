/* Prints the nanoseconds of a step of a generated plant, those of plain C, and how many times as long that takes:
 * both in turns, the least of each. Fails where they do not end at the same states. */
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <time.h>

#include "core/runtime/plant.h"
#include "tests/promises/cost/plain/plain.h"

enum { STATES_MAX = 64, STEPS = 400, ROUNDS = 60 };

static double seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

int main(void)
{
    const iso_plant *const plant = &iso_the_plant;
    const size_t n = plant->model->states;
    double x[STATES_MAX], least[2] = {1.0, 1.0}, off = 0.0;
    if (n != plain_states) {
        return 1;
    }
    for (int round = 0; round < ROUNDS; round++) {
        iso_plant_start(plant);
        memset(plant->u, 0, plant->model->inputs * sizeof *plant->u);
        memcpy(x, plain_start, n * sizeof *x);
        const double begin = seconds();
        for (int i = 0; i < STEPS; i++) {
            plant->model->step(plant->memory);
        }
        const double between = seconds();
        for (int i = 0; i < STEPS; i++) {
            plain_step(x);
        }
        const double end = seconds();
        least[0] = fmin(least[0], between - begin);
        least[1] = fmin(least[1], end - between);
    }
    for (size_t i = 0; i < n; i++) {
        off = fmax(off, fabs(remainder(x[i] - plant->x[i], 6.283185307179586)));
    }
    printf("%.0f %.0f %.2f\n", 1e9 * least[0] / STEPS, 1e9 * least[1] / STEPS, least[1] / least[0]);
    return off < 1e-6 ? 0 : 1;
}
