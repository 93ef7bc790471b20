/* A plant whose tick has four sub-steps against the same one with a quarter of the step, four ticks for one: the same
 * bits after every tick. Prints the hash of the first; status 1 where they differ. */
#include <inttypes.h>
#include <stdio.h>

#include "core/runtime/hash.h"
#include "fine.h"
#include "parted.h"

#include "core/runtime/tick.h"

int main(void)
{
    enum { TICKS = 500, PARTS = 4 };
    static parted_memory of_parted;
    static fine_memory of_fine;
    const iso_plant parted = parted_plant(&of_parted), fine = fine_plant(&of_fine);
    uint64_t hash = ISO_HASH_START, other = ISO_HASH_START;
    int differ = 0;
    iso_plant_start(&parted);
    iso_plant_start(&fine);
    for (uint64_t tick = 0; tick < TICKS; tick++) {
        bool good = iso_plant_tick(&parted, tick) == PARTED_STATES;
        for (uint64_t part = 0; part < PARTS; part++) {
            good = good && iso_plant_tick(&fine, PARTS * tick + part) == FINE_STATES;
        }
        hash = iso_hash_reals(hash, parted.x, PARTED_STATES);
        other = iso_hash_reals(other, fine.x, FINE_STATES);
        differ += !good || hash != other;
    }
    printf("%016" PRIx64 "\n", hash);
    return differ == 0 ? 0 : 1;
}
