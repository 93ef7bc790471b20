/* The ticks in which a plant restarts its method. */
#include <stdio.h>

#include PLANT
#include "core/runtime/tick.h"

int main(void)
{
    const iso_plant *const plant = &iso_the_plant;
    iso_plant_start(plant);
    for (uint64_t tick = 0; tick < 1000; tick++) {
        iso_plant_drive(plant, tick);
        if (iso_plant_step(plant)) {
            printf("%u ", (unsigned)tick);
        }
    }
    return 0;
}
