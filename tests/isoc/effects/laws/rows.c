/* The outputs of a plant in rows 0 to N, one row on a line. usage: rows N */
#include <stdio.h>
#include <stdlib.h>

#include "plant.h"

#include "core/runtime/tick.h"

static void show(const iso_plant *const p)
{
    for (int i = 0; i < PLANT_OUTPUTS; i++) {
        printf("%.17g ", (double)p->y[i]);
    }
    printf("\n");
}

int main(const int argc, char **const argv)
{
    static iso_plant p;
    const uint64_t rows = argc > 1 ? strtoull(argv[1], NULL, 10) : 0;
    p = iso_the_plant;
    iso_plant_start(&p);
    p.model->output(p.memory);
    show(&p);
    for (uint64_t tick = 0; tick < rows; tick++) {
        (void)iso_plant_tick(&p, tick);
        show(&p);
    }
    return 0;
}
