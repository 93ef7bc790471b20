#include "core/runtime/loop.h"

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

/* Repeats the last step from its start, with a new history. Its error is kept, so that a motion with a discontinuity in
 * every tick does not need a restart in every tick. */
static void step_again(const iso_plant *const plant)
{
    const iso_progress progress = *plant->progress;
    memcpy(plant->memory, plant->before, plant->model->memory_bytes);
    *plant->progress = progress;
    plant->model->prime(plant->memory);
    plant->model->step(plant->memory);
}

/* All ones if state i is not finite or out of its range, else zero; without a branch on it. */
static iso_bits is_bad(const iso_plant *const plant, const uint16_t i)
{
    return iso_beyond(plant->x[i], plant->model->range == NULL ? ISO_REAL_MAX : plant->model->range[i]);
}

/* The first bad state. The test of all is without a branch; the search is for the report only. */
static uint16_t guard(const iso_plant *const plant)
{
    iso_bits bad = 0;
    for (uint16_t i = 0; i < plant->model->states; i++) {
        bad |= is_bad(plant, i);
    }
    uint16_t first = plant->model->states;
    if (bad != 0) {
        for (first = 0; is_bad(plant, first) == 0; first++) {
        }
    }
    return first;
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
    if (plant->model->drive != NULL) {
        plant->model->drive(plant->memory, loop->tick);
    }
    iso_port_read(plant->u, plant->model->inputs);
    loop->tick++;
    loop->due += loop->period;

    if (plant->before != NULL) {
        memcpy(plant->before, plant->memory, plant->model->memory_bytes);
    }
    const uint32_t restarts = loop->statistics.restarts;
    const uint32_t before = iso_port_clock();
    if (plant->model->jumped != NULL && plant->model->jumped(plant->memory)) {
        plant->model->prime(plant->memory);
        loop->statistics.restarts++;
    }
    plant->model->step(plant->memory);
    uint32_t after = iso_port_clock();
    /* After a restart a second one would give the same step. */
    if (plant->before != NULL && plant->progress->jumped && loop->statistics.restarts == restarts) {
        step_again(plant);
        loop->statistics.restarts++;
        after = iso_port_clock();
    }

    loop->guard = guard(plant);
    if (loop->guard < plant->model->states) {
        loop->statistics.restarts = restarts;
        return false;
    }
    plant->model->output(plant->memory);
    iso_port_publish(plant->y, plant->model->outputs);
    if (plant->model->violation != NULL) {
        book_violation(plant, &loop->statistics);
    }
    book(loop, begin, loop->statistics.restarts != restarts, after - before - loop->overhead, iso_port_clock());
    return true;
}
