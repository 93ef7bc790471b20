#include "core/runtime/loop.h"

#include "core/runtime/tick.h"

#include "core/methods/method.h"
#include "core/numbers/unroll.h"

#include "port/port.h"

/* Signed time from a to b on the clock. */
static int64_t elapsed(const uint64_t a, const uint64_t b)
{
    return (int64_t)(b - a);
}

static uint64_t smaller(const uint64_t a, const uint64_t b)
{
    return a < b ? a : b;
}

static uint64_t larger(const uint64_t a, const uint64_t b)
{
    return a < b ? b : a;
}

/* The time between two readings of the clock, the least of a few: the part of a measured time that measuring adds. */
static uint32_t clock_overhead(void)
{
    enum { READINGS = 4 };
    uint64_t least = UINT32_MAX;
    for (int i = 0; i < READINGS; i++) {
        const uint64_t begin = iso_port_clock();
        least = smaller(least, iso_port_clock() - begin);
    }
    return (uint32_t)least;
}

/* Hands the outputs to the port; where one is not finite, the last good ones. */
ISO_APART static void publish(iso_loop *const loop)
{
    const iso_plant *const plant = loop->plant;
    loop->statistics.outputs_held += iso_plant_output(plant);
    iso_port_publish(plant->y, plant->model->outputs);
}

ISO_RARE void iso_loop_start(iso_loop *const loop, const iso_plant *const plant)
{
    iso_plant_start(plant);
    *loop = (iso_loop){
        .plant = plant,
        .guard = plant->model->states,
        .statistics = {.margin = INT64_MAX, .execution_min = UINT64_MAX},
    };
    publish(loop);
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
static void book(iso_loop *const loop, const uint64_t begin, const bool restarted, const uint64_t counts,
                 const uint64_t end)
{
    iso_statistics *const statistics = &loop->statistics;
    const int64_t margin = elapsed(end, loop->due + loop->period);

    statistics->ticks++;
    statistics->lost += loop->tick != loop->reported;
    statistics->late += elapsed(loop->due, begin) > (int64_t)(loop->period >> ISO_LATE_SHIFT);
    statistics->overruns += margin < 0;
    statistics->margin = margin < statistics->margin ? margin : statistics->margin;
    if (restarted) {
        statistics->restart_max = larger(statistics->restart_max, counts);
    } else {
        statistics->execution_min = smaller(statistics->execution_min, counts);
        statistics->execution_max = larger(statistics->execution_max, counts);
        statistics->execution_sum += counts;
    }
    if (loop->plant->progress != NULL) {
        statistics->local_error = iso_max(statistics->local_error, loop->plant->progress->local_error);
    }
}

bool iso_loop_tick(iso_loop *const loop)
{
    const iso_plant *const plant = loop->plant;

    while (loop->tick >= loop->reported) { /* a port that wakes up without a tick is asked again */
        loop->reported = iso_port_wait();
    }
    const uint64_t begin = iso_port_clock();
    iso_plant_drive(plant, loop->tick);
    iso_port_read(plant->u, plant->model->inputs);
    iso_plant_admit(plant, &loop->statistics.inputs, &loop->statistics.parameters);
    loop->tick++;
    loop->due += loop->period;

    iso_plant_keep(plant);
    const uint64_t restarts = loop->statistics.restarts;
    const uint64_t before = iso_port_clock();
    iso_plant_step(plant, &loop->statistics.restarts);
    uint64_t after = iso_port_clock();
    if (iso_plant_step_again(plant, loop->statistics.restarts != restarts)) {
        loop->statistics.restarts++;
        after = iso_port_clock();
    }

    loop->guard = iso_plant_guard(plant);
    if (loop->guard < plant->model->states) {
        loop->statistics.restarts = restarts;
        iso_port_safe();
        return false;
    }
    iso_plant_advance(plant);
    publish(loop);
    if (plant->model->violation != NULL) {
        book_violation(plant, &loop->statistics);
    }
    book(loop, begin, loop->statistics.restarts != restarts, larger(after - before, loop->overhead) - loop->overhead,
         iso_port_clock());
    return true;
}
