/* A fault and a tunable that the scene sets at ticks (other) are what the program sets in those rows (old). */
#include <stdio.h>
#include <string.h>

#include "core/runtime/tick.h"
#include "old.h"
#include "other.h"

int main(void)
{
    enum { TICKS = 400 };
    static old_memory of_old;
    static other_memory of_other;
    const iso_plant old = old_plant(&of_old), other = other_plant(&of_other);
    iso_plant_start(&old);
    iso_plant_start(&other);
    for (uint32_t tick = 0; tick < TICKS; tick++) {
        old.p[OLD_P_DRIVE_OPEN] = tick == 100 ? R(1.0) : tick == 200 ? R(0.0) : old.p[OLD_P_DRIVE_OPEN];
        old.p[OLD_P_LOAD] = tick == 300 ? R(0.02) : old.p[OLD_P_LOAD];
        const bool is_set = memcmp(old.p, other.p, OLD_PARAMETERS * sizeof *old.p) == 0;
        (void)iso_plant_tick(&old, tick);
        (void)iso_plant_tick(&other, tick);
        if (memcmp(old.x, other.x, OLD_STATES * sizeof *old.x) != 0 || !is_set) {
            printf("# other bits at tick %u\n", (unsigned)tick);
            return 1;
        }
    }
    return 0;
}
