/* A loop that passes singular positions themselves, from many speeds of its start.
 *
 *     starts SECONDS COUNT
 *
 * prints how many of the COUNT runs stay finite; the speeds of the start grow from theirs to 1.6 times theirs. */
#include <stdio.h>
#include <stdlib.h>

#include "core/runtime/tick.h"
#include "tests/host/faster.h"

/* Whether all states stay finite. */
static bool stays(const iso_plant *const plant, const uint64_t ticks, const real faster)
{
    const uint16_t states = plant->model->states;
    uint16_t guard = states;
    start_faster(plant, faster);
    for (uint64_t tick = 0; tick < ticks && guard == states; tick++) {
        guard = iso_plant_tick(plant, tick);
    }
    return guard == states;
}

int main(const int count, char **const arguments)
{
    const iso_plant *const plant = &iso_the_plant;
    const double seconds = count == 3 ? strtod(arguments[1], NULL) : 0.0;
    const long starts = count == 3 ? strtol(arguments[2], NULL, 10) : 0;
    const uint64_t ticks = (uint64_t)(seconds * 1e9) / plant->model->period_ns;
    long finite = 0;
    for (long k = 0; k < starts; k++) {
        finite += stays(plant, ticks, R(1.0) + R(0.6) * (real)k / (real)starts);
    }
    printf("%ld\n", finite);
    return 0;
}
