/* The same loop without a wire, for so many ticks: plant and controller in one program. */
#include <stdio.h>
#include <stdlib.h>

#include "core/runtime/hash.h"
#include "core/runtime/tick.h"
#include "tests/core/link/controllers/law.h"

int main(int count, char **arguments)
{
    const iso_plant *const plant = &iso_the_plant;
    uint64_t hash = ISO_HASH_START;
    iso_plant_start(plant);
    (void)iso_plant_output(plant);
    for (uint64_t tick = 0; tick < (count > 1 ? (uint64_t)atol(arguments[1]) : 0); tick++) {
        plant->u[0] = LAW(plant->y);
        if (iso_plant_tick(plant, tick) < plant->model->states) {
            return 1;
        }
        hash = iso_hash_reals(hash, plant->x, plant->model->states);
    }
    printf("hash %016llx pole %.6g\n", (unsigned long long)hash, (double)plant->y[2]);
    return 0;
}
