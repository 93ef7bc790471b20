/* Steps a plant from its start as many times as the argument says, for an instrument to count. */
#include <stdlib.h>
#include <string.h>

#include "core/plant.h"

int main(const int count, char **const arguments)
{
    const iso_plant *const plant = &iso_the_plant;
    const long steps = count == 2 ? strtol(arguments[1], NULL, 10) : 0;
    memcpy(plant->x, plant->start, plant->states * sizeof(real));
    memcpy(plant->p, plant->defaults, plant->parameters * sizeof(real));
    for (long n = 0; n < steps; n++) {
        plant->step();
    }
    return steps > 0 ? 0 : 1;
}
