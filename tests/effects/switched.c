/* A fault and a tunable that the scene sets at ticks (new) are what the program sets in those rows (old). */
#include <stdio.h>
#include <string.h>

#include "core/runtime/tick.h"
#include "new.h"
#include "old.h"

int main(void)
{
    enum { TICKS = 400 };
    static old_memory of_old;
    static new_memory of_new;
    const iso_plant old = old_plant(&of_old), new = new_plant(&of_new);
    iso_plant_start(&old);
    iso_plant_start(&new);
    for (uint32_t tick = 0; tick < TICKS; tick++) {
        old.p[OLD_P_DRIVE_OPEN] = tick == 100 ? R(1.0) : tick == 200 ? R(0.0) : old.p[OLD_P_DRIVE_OPEN];
        old.p[OLD_P_LOAD] = tick == 300 ? R(0.02) : old.p[OLD_P_LOAD];
        const bool is_set = memcmp(old.p, new.p, OLD_PARAMETERS * sizeof *old.p) == 0;
        (void)iso_plant_tick(&old, tick);
        (void)iso_plant_tick(&new, tick);
        if (memcmp(old.x, new.x, OLD_STATES * sizeof *old.x) != 0 || !is_set) {
            printf("# other bits at tick %u\n", (unsigned)tick);
            return 1;
        }
    }
    return 0;
}
