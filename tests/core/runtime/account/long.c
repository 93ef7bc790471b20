/* The simulated port and the functions of time of a generated plant beyond tick 2^32. The port under test is compiled
 * into this file, to begin close to it. */
#include <math.h>

#include <stdio.h>
#include <stdlib.h>

#include "port/host/sim.c"

#include "core/runtime/loop.h"

int main(const int argc, char **const argv)
{
    enum { TICKS = 40 };
    (void)argc;
    const uint64_t first = (UINT64_C(1) << 32) - 10;
    const iso_plant *const plant = &iso_the_plant;
    const double h = 0.001;
    static iso_loop loop;
    sim_script_read(argv[1]);
    iso_loop_start(&loop, plant);
    loop.tick = loop.reported = reported = step = first;
    loop.due = now = first * period;
    double worst[2] = {0};
    for (int i = 0; i < TICKS; i++) {
        const double t = (double)loop.tick * h;
        if (!iso_loop_tick(&loop)) {
            return EXIT_FAILURE;
        }
        /* wave: 2 N at 0.3 Hz and 0.1 turns; in float its angle has 2^-23 of pi. climb: 1 N/s from 1 s on, four
         * roundings. */
        const double turns = fmod(0.3 * t + 0.1, 1.0);
        worst[0] = fmax(worst[0], fabs((double)plant->u[0] - 2.0 * sin(turns * 6.283185307179586)));
        worst[1] = fmax(worst[1], fabs((double)plant->u[2] / (t - 1.0) - 1.0));
    }
    plant->model->drive(plant->memory, 1);
    const real grain = plant->u[1];
    plant->model->drive(plant->memory, (UINT64_C(1) << 32) + 1);
    const bool is_new = plant->u[1] != grain;
    const iso_statistics *const s = &loop.statistics;
    printf("late %d lost %d overruns %d margin %lld wave %d climb %d grain %d\n", (int)s->late, (int)s->lost,
           (int)s->overruns, (long long)s->margin, worst[0] < 1e-6, worst[1] < 4.0 * (double)ISO_REAL_EPSILON, is_new);
    printf("# wave %.3g climb %.3g\n", worst[0], worst[1]);
    return EXIT_SUCCESS;
}
