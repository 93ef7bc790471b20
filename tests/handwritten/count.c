/* Steps a plant from its start as many times as the argument says, or evaluates its derivative there if a second
 * argument says so, for an instrument to count. */
#include <stdlib.h>
#include <string.h>

#include "core/runtime/plant.h"

enum { COUNT_STATES_MAX = 16 };

int main(const int count, char **const arguments)
{
    const iso_plant *const plant = &iso_the_plant;
    const long steps = count > 1 ? strtol(arguments[1], NULL, 10) : 0;
    const bool evaluate = count > 2 && strcmp(arguments[2], "derivative") == 0;
    real dx[COUNT_STATES_MAX];
    memcpy(plant->x, plant->model->start, plant->model->states * sizeof(real));
    memcpy(plant->p, plant->model->defaults, plant->model->parameters * sizeof(real));
    for (long n = 0; n < steps; n++) {
        if (evaluate) {
            plant->model->derivative(dx, plant->x, plant->u, plant->p);
        } else {
            plant->model->step(plant->memory);
        }
    }
    return steps > 0 && plant->model->states <= COUNT_STATES_MAX ? 0 : 1;
}
