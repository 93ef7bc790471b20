/* Runs a plant for some seconds of the machine, and prints its steps per second: alone, or with ISO_LANES side by side;
 * and a hash of lane 0, which is that of the plant alone. The folder of plant.c is one for includes in quotes. */
#include "plant.c"

#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "core/runtime/hash.h"

#ifdef ISO_LANES
enum { LANES = ISO_LANES };
#else
enum { LANES = 1 };
#endif

/* So many ticks from the start; returns the hash of the states at the end. Where the guard ends a run, another one
 * begins. */
static uint64_t run(const uint64_t ticks)
{
#ifdef ISO_LANES
    static plant_memory parked, spare, other;
    iso_lanes all = {.plant = iso_the_plant, .parked = &parked};
    all.plant.spare = &spare;
    all.plant.before = all.plant.before == NULL ? NULL : &other;
    (void)iso_lanes_start(&all);
    for (uint64_t tick = 0; tick < ticks; tick++) {
        if (!iso_lanes_tick(&all)) {
            (void)iso_lanes_start(&all);
        }
    }
    return iso_hash_lane(ISO_HASH_START, all.plant.x, all.plant.model->states, 0);
#else
    const iso_plant *const plant = &iso_the_plant;
    (void)iso_plant_start(plant);
    uint64_t from = 0;
    for (uint64_t tick = 0; tick < ticks; tick++) {
        if (iso_plant_tick(plant, tick - from) != plant->model->states) {
            (void)iso_plant_start(plant);
            from = tick + 1;
        }
    }
    return iso_hash_reals(ISO_HASH_START, plant->x, plant->model->states);
#endif
}

int main(const int count, char **const arguments)
{
    enum { FEW = 1000 };
    const double seconds = count > 1 ? strtod(arguments[1], NULL) : 1.0;
    const uint64_t hash = run(FEW);
    double took = 0.0;
    uint64_t ticks = FEW;
    while (took < seconds) {
        ticks *= 2;
        const clock_t begin = clock();
        (void)run(ticks);
        took = (double)(clock() - begin) / CLOCKS_PER_SEC;
    }
    printf("%d %.4g %016llx\n", LANES, (double)ticks * LANES / took, (unsigned long long)hash);
    return 0;
}
