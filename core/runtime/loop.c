#include "core/runtime/loop.h"

#include "core/runtime/tick.h"

#include "core/methods/method.h"

#include "port/port.h"

/* Signed time from a to b on the clock, which wraps: right while they are less than 2^31 counts apart. */
static int32_t elapsed(const uint32_t a, const uint32_t b)
{
    return (int32_t)(b - a);
}

/* The time between two readings of the clock, the least of a few: the part of a measured time that measuring adds. */
static uint32_t clock_overhead(void)
{
    enum { READINGS = 4 };
    uint32_t least = UINT32_MAX;
    for (int i = 0; i < READINGS; i++) {
        const uint32_t begin = iso_port_clock();
        const uint32_t counts = iso_port_clock() - begin;
        least = counts < least ? counts : least;
    }
    return least;
}

void iso_loop_start(iso_loop *const loop, const iso_plant *const plant)
{
    iso_plant_start(plant);
    *loop = (iso_loop){
        .plant = plant,
        .guard = plant->model->states,
        .statistics = {.margin = INT32_MAX, .execution_min = UINT32_MAX},
    };
    plant->model->output(plant->memory);
    iso_port_publish(plant->y, plant->model->outputs);
    loop->period = iso_port_start(plant->model->period_ns);
    loop->overhead = clock_overhead();
}

/* Updates the statistics of the violation. */
static void book_violation(const iso_plant *const plant, iso_statistics *const statistics)
{
    const real off = plant->model->violation(plant->memory);
    statistics->violated += (uint32_t)(iso_less(plant->model->violation_limit, off) & 1);
    statistics->violation = iso_max(statistics->violation, off);
}

/* Updates the statistics with a tick that began at `begin`, needed `counts` for its step, with or without a restart, and
 * ended at `end`. */
static void book(iso_loop *const loop, const uint32_t begin, const bool restarted, const uint32_t counts,
                 const uint32_t end)
{
    iso_statistics *const statistics = &loop->statistics;
    const int32_t margin = elapsed(end, loop->due + loop->period);

    statistics->ticks++;
    statistics->lost += loop->tick != loop->reported;
    statistics->late += elapsed(loop->due, begin) > (int32_t)(loop->period >> ISO_LATE_SHIFT);
    statistics->overruns += margin < 0;
    statistics->margin = margin < statistics->margin ? margin : statistics->margin;
    if (restarted) {
        statistics->restart_max = counts > statistics->restart_max ? counts : statistics->restart_max;
    } else {
        statistics->execution_min = counts < statistics->execution_min ? counts : statistics->execution_min;
        statistics->execution_max = counts > statistics->execution_max ? counts : statistics->execution_max;
        statistics->execution_sum += counts;
    }
    if (loop->plant->progress != NULL) {
        statistics->local_error = iso_max(statistics->local_error, loop->plant->progress->local_error);
    }
}

bool iso_loop_tick(iso_loop *const loop)
{
    const iso_plant *const plant = loop->plant;

    if (loop->tick == loop->reported) {
        loop->reported = iso_port_wait();
    }
    const uint32_t begin = iso_port_clock();
    iso_plant_drive(plant, loop->tick);
    iso_port_read(plant->u, plant->model->inputs);
    loop->tick++;
    loop->due += loop->period;

    iso_plant_keep(plant);
    const uint32_t restarts = loop->statistics.restarts;
    const uint32_t before = iso_port_clock();
    iso_plant_step(plant, &loop->statistics.restarts);
    uint32_t after = iso_port_clock();
    if (iso_plant_step_again(plant, loop->statistics.restarts != restarts)) {
        loop->statistics.restarts++;
        after = iso_port_clock();
    }

    loop->guard = iso_plant_guard(plant);
    if (loop->guard < plant->model->states) {
        loop->statistics.restarts = restarts;
        return false;
    }
    iso_plant_output(plant);
    iso_port_publish(plant->y, plant->model->outputs);
    if (plant->model->violation != NULL) {
        book_violation(plant, &loop->statistics);
    }
    book(loop, begin, loop->statistics.restarts != restarts, after - before - loop->overhead, iso_port_clock());
    return true;
}
