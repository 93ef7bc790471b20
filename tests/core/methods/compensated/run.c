/* A plant of a program from several starts, in its own steps:
 *
 *     run SECONDS
 *
 * prints for each start and for POINTS times the outputs, a line each. The speeds of a start are those of the scene
 * times 1 + k/64. */
#include <stdio.h>
#include <stdlib.h>

#include "core/runtime/tick.h"
#include "tests/host/faster.h"

enum { STARTS = 16, POINTS = 16 };

static void print_outputs(const iso_plant *const plant)
{
    for (int i = 0; i < plant->model->outputs; i++) {
        printf("%.17g ", (double)plant->y[i]);
    }
    printf("\n");
}

/* Whether all states stay finite for the TICKS. */
static bool run_points(const iso_plant *const plant, const uint64_t ticks)
{
    uint64_t tick = 0;
    for (uint64_t point = 1; point <= POINTS; point++) {
        while (tick < point * ticks / POINTS) {
            if (iso_plant_tick(plant, tick++) != plant->model->states) {
                return false;
            }
        }
        print_outputs(plant);
    }
    return true;
}

int main(const int count, char **const arguments)
{
    const iso_plant *const plant = &iso_the_plant;
    const uint64_t seconds = count == 2 ? strtoull(arguments[1], NULL, 10) : 0;
    const uint64_t ticks = seconds * UINT64_C(1000000000) / plant->model->period_ns;
    bool finite = true;
    for (int k = 0; k < STARTS && finite; k++) {
        start_faster(plant, R(1.0) + (real)k / R(64.0));
        finite = run_points(plant, ticks);
    }
    return !finite;
}
