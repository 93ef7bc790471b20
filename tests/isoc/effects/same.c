/* Whether two plants, old and other, end every tick with the same bits of state. */
#include <stdio.h>
#include <string.h>

#include "core/runtime/tick.h"
#include "old.h"
#include "other.h"

int main(void)
{
    enum { TICKS = 2000 };
    static old_memory of_old;
    static other_memory of_other;
    const iso_plant old = old_plant(&of_old), other = other_plant(&of_other);
    iso_plant_start(&old);
    iso_plant_start(&other);
    for (uint32_t tick = 0; tick < TICKS; tick++) {
        (void)iso_plant_tick(&old, tick);
        (void)iso_plant_tick(&other, tick);
        if (memcmp(old.x, other.x, OLD_STATES * sizeof *old.x) != 0) {
            printf("# other bits from tick %u on\n", (unsigned)tick);
            return 1;
        }
    }
    return 0;
}
