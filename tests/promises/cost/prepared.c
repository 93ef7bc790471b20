/* Prints the states of a plant after ticks; after more, from states that are written between two of them; and with an
 * argument without telling the plant of these. */
#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "core/runtime/tick.h"

enum { TICKS = 200 };

static uint64_t ticks;

static void run(const iso_plant *const plant)
{
    for (int i = 0; i < TICKS; i++) {
        (void)iso_plant_tick(plant, ticks++);
    }
    for (int i = 0; i < plant->model->states; i++) {
        uint64_t bits = 0;
        memcpy(&bits, &plant->x[i], sizeof plant->x[i]);
        printf("%016" PRIX64 "\n", bits);
    }
}

int main(const int count, char **const arguments)
{
    const iso_plant *const plant = &iso_the_plant;
    (void)arguments;
    iso_plant_start(plant);
    run(plant);
    for (int i = 0; i < plant->model->states; i++) {
        plant->x[i] += R(0.125);
    }
    if (count == 1) {
        plant->model->output(plant->memory);
    }
    run(plant);
    return 0;
}
