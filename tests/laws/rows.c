/* The outputs of a plant in rows 0 to ROWS, one row on a line. */
#include <stdio.h>

#include "plant.h"

#include "core/runtime/tick.h"

enum { ROWS = 24 };

static void show(const iso_plant *const p)
{
    for (int i = 0; i < PLANT_OUTPUTS; i++) {
        printf("%.17g ", (double)p->y[i]);
    }
    printf("\n");
}

int main(void)
{
    static iso_plant p;
    p = iso_the_plant;
    iso_plant_start(&p);
    p.model->output(p.memory);
    show(&p);
    for (uint64_t tick = 0; tick < ROWS; tick++) {
        (void)iso_plant_tick(&p, tick);
        show(&p);
    }
    return 0;
}
