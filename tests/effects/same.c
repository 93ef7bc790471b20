/* Whether two plants, old and new, end every tick with the same bits of state. */
#include <stdio.h>
#include <string.h>

#include "core/runtime/tick.h"
#include "new.h"
#include "old.h"

int main(void)
{
    enum { TICKS = 2000 };
    static old_memory of_old;
    static new_memory of_new;
    const iso_plant old = old_plant(&of_old), new = new_plant(&of_new);
    iso_plant_start(&old);
    iso_plant_start(&new);
    for (uint32_t tick = 0; tick < TICKS; tick++) {
        (void)iso_plant_tick(&old, tick);
        (void)iso_plant_tick(&new, tick);
        if (memcmp(old.x, new.x, OLD_STATES * sizeof *old.x) != 0) {
            printf("# other bits from tick %u on\n", (unsigned)tick);
            return 1;
        }
    }
    return 0;
}
