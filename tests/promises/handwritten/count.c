/* Steps a plant from its start, or evaluates its derivative there if an argument says so, for an instrument to count: a
 * thousand times, two thousand, three and four, each by a call of `count_steps`. */
#include <stdlib.h>
#include <string.h>

#include "core/runtime/plant.h"

enum { COUNT_STATES_MAX = 16 };

extern void count_steps(const iso_plant *plant, long steps, bool evaluate);

void __attribute__((noinline)) count_steps(const iso_plant *const plant, const long steps, const bool evaluate)
{
    const iso_model *const model = plant->model;
    real dx[COUNT_STATES_MAX];
    for (long n = steps; n > 0 && !evaluate; n--) {
        model->step(plant->memory);
    }
    for (long n = steps; n > 0 && evaluate; n--) {
        iso_the_derivative(dx, plant->x, plant->u, plant->p);
    }
}

int main(const int count, char **const arguments)
{
    const iso_plant *const plant = &iso_the_plant;
    const bool evaluate = count > 1 && strcmp(arguments[1], "derivative") == 0;
    iso_plant_reset(plant);
    plant->model->output(plant->memory);
    for (long steps = 1000; steps <= 4000; steps += 1000) {
        count_steps(plant, steps, evaluate);
    }
    return !evaluate || plant->model->states <= COUNT_STATES_MAX ? EXIT_SUCCESS : EXIT_FAILURE;
}
