/* A plant of a program for SECONDS, in its own steps:
 *
 *     run SECONDS
 *
 * prints for POINTS times the outputs, a line each. */
#include <stdio.h>
#include <stdlib.h>

#include "core/runtime/tick.h"

enum { POINTS = 64 };

int main(const int count, char **const arguments)
{
    const iso_plant *const plant = &iso_the_plant;
    const uint64_t seconds = count == 2 ? strtoull(arguments[1], NULL, 10) : 0;
    const uint64_t ticks = seconds * UINT64_C(1000000000) / plant->model->period_ns;
    uint64_t tick = 0;
    iso_plant_start(plant);
    for (uint64_t point = 1; point <= POINTS; point++) {
        while (tick < point * ticks / POINTS) {
            if (iso_plant_tick(plant, tick++) != plant->model->states) {
                return 1;
            }
        }
        for (int i = 0; i < plant->model->outputs; i++) {
            printf("%.17g ", (double)plant->y[i]);
        }
        printf("\n");
    }
    return 0;
}
