/* Whether PLANT, motors on 6 V, stays where it belongs: no current above 6 A within half a second. Status 0: it does.
 */
#include PLANT
#include "core/runtime/tick.h"

int main(void)
{
    const iso_plant *const plant = &iso_the_plant;
    bool holds = true;
    iso_plant_start(plant);
    for (uint64_t tick = 0; tick < 500 && holds; tick++) {
        plant->u[PLANT_U_VOLTS] = R(6.0);
        (void)iso_plant_tick(plant, tick);
        holds = iso_abs(plant->y[PLANT_Y_CURRENT]) < R(6.0);
    }
    return holds ? 0 : 1;
}
