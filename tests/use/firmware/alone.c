/* Firmware around one plant, or two instances of it by turns: prints the hash of each after so many ticks, as make run
 * has it of the same scene. With -DNAMED the plant of --name swing, else that of the program. */
#ifdef NAMED
#include "swing.h"
#else
#include "plant.h"
#endif
#include "core/runtime/tick.h"
#include "hash.h"

#include <stdio.h>

enum { TICKS = 1000 };

int main(void)
{
#ifdef NAMED
    static swing_memory memory[2];
    const iso_plant plants[] = {swing_plant(&memory[0]), swing_plant(&memory[1])};
#else
    const iso_plant plants[] = {iso_the_plant};
#endif
    enum { PLANTS = sizeof plants / sizeof plants[0] };
    uint64_t hash[PLANTS];
    for (int i = 0; i < PLANTS; i++) {
        hash[i] = ISO_HASH_START;
        iso_plant_start(&plants[i]);
        (void)iso_plant_output(&plants[i]);
    }
    for (uint32_t tick = 0; tick < TICKS; tick++) {
        for (int i = 0; i < PLANTS; i++) {
            if (iso_plant_tick(&plants[i], tick) < plants[i].model->states) {
                return 1;
            }
            hash[i] = iso_hash_reals(hash[i], plants[i].x, plants[i].model->states);
        }
    }
    for (int i = 0; i < PLANTS; i++) {
        printf("%016llx\n", (unsigned long long)hash[i]);
    }
    return 0;
}
