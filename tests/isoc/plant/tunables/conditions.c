/* A change of a tunable that breaks a condition of the scene is refused, with all changes of its tick, and counted
 * once; the plant goes on with what it had. Random values, some of which break one, some of which do not. */
#include <stdlib.h>

#include PLANT
#include "core/runtime/tick.h"
#include "tests/host/report.h"

enum { TICKS = 4000 };

static double between(const double least, const double most)
{
    return least + (most - least) * rand() / RAND_MAX;
}

/* The conditions as they are written. */
static bool keeps(const real *const p)
{
    return p[PLANT_P_HARD] > 0 && p[PLANT_P_BOUNCE] >= R(0.01) && p[PLANT_P_BOUNCE] <= 1 && p[PLANT_P_TOP] >= 0 &&
           p[PLANT_P_TOP] >= p[PLANT_P_BOUNCE] && p[PLANT_P_FREE] > 0;
}

int main(void)
{
    const iso_plant *const plant = &iso_the_plant;
    iso_tick_counts counts = {.restarts = 0};
    real kept[PLANT_PARAMETERS];
    uint64_t refused = 0, good = 0;
    bool is_same = true, is_finite = true;
    iso_plant_start(plant);
    memcpy(kept, plant->p, sizeof kept);
    is_same = plant->p[PLANT_P_HARD] == R(20000.0);
    srand(1);
    for (uint32_t tick = 0; tick < TICKS; tick++) {
        plant->p[PLANT_P_HARD] = (real)between(-2e3, 2e4);
        plant->p[PLANT_P_BOUNCE] = (real)between(-0.1, 1.1);
        plant->p[PLANT_P_TOP] = (real)between(0.0, 5.0);
        plant->p[PLANT_P_FREE] = tick % 7 == 0 ? R(0.0) : (real)between(0.1, 2.0);
        if (keeps(plant->p)) {
            memcpy(kept, plant->p, sizeof kept);
            good++;
        } else {
            refused++;
        }
        is_finite = is_finite && iso_plant_tick_counted(plant, tick, &counts) == plant->model->states;
        is_same = is_same && memcmp(kept, plant->p, sizeof kept) == 0;
    }
    report_ok(good > 100 && refused > 100 && is_same, "%u changes are taken, %u are refused, as the conditions say",
              (unsigned)good, (unsigned)refused);
    report_ok(counts.parameters.held == refused && counts.parameters.clamped == 0 && counts.outputs_held == 0,
              "each is counted once: %u", (unsigned)counts.parameters.held);
    report_ok(is_finite, "the plant goes on");
    return report_done();
}
