/* The outputs of rows 0 to 7, a line for each. */
#include <stdio.h>

#include PLANT
#include "core/runtime/tick.h"

int main(void)
{
    const iso_plant *const plant = &iso_the_plant;
    iso_plant_start(plant);
    (void)iso_plant_output(plant);
    for (uint64_t row = 0; row < 8; row++) {
        for (int i = 0; i < PLANT_OUTPUTS; i++) {
            printf("%s%.9g", i == 0 ? "" : " ", (double)plant->y[i]);
        }
        printf("\n");
        (void)iso_plant_tick(plant, row);
    }
    return 0;
}
