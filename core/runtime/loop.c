#include "core/runtime/loop.h"

#include "core/runtime/policy.h"
#include "core/runtime/tick.h"

#include "core/numbers/unroll.h"

#include "port/port.h"

/* The times of a tick, on the clock. */
typedef struct times {
    uint64_t before, after; /* its step */
    uint64_t end;
} times;

/* Ticks that were reported and are not done. They are fewer than 2^32, whose low words are all that a port keeps of
 * them. */
ISO_INLINE uint32_t behind(const iso_loop *const loop)
{
    return (uint32_t)loop->reported - (uint32_t)loop->tick;
}

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

/* Sets the plant to its start, with no ticks counted, and publishes its outputs. */
ISO_RARE static void start_plant(iso_loop *const loop)
{
    const iso_plant *const plant = loop->plant;
    iso_plant_start(plant);
    const iso_policy *const policy = plant->model->policy;
    loop->guard = plant->model->states;
    loop->at_once = policy != NULL && policy->delays ? 0 : plant->model->outputs;
    loop->used = 0;
    loop->execution_min = UINT32_MAX;
    loop->statistics = (iso_statistics){.margin = INT64_MAX, .execution_min = UINT64_MAX};
    loop->statistics.outputs_held = iso_plant_output(plant);
    iso_port_publish(plant->y, plant->model->outputs);
}

ISO_RARE void iso_loop_start(iso_loop *const loop, const iso_plant *const plant)
{
    *loop = (iso_loop){.plant = plant};
    start_plant(loop);
    loop->period = iso_port_start(plant->model->period_ns);
    loop->overhead = clock_overhead();
}

/* Books a tick of any times, and the times up to which the next ticks have no news. Returns whether the run goes on. */
ISO_APART ISO_RARE static bool book_times(iso_loop *const loop, const times *const t, const bool restarted)
{
    iso_statistics *const statistics = &loop->statistics;
    const iso_policy *const policy = loop->plant->model->policy;
    const int64_t margin = elapsed(t->end, loop->due + loop->period);
    const iso_news news = {
        .counts = larger(t->after - t->before, loop->overhead) - loop->overhead,
        .late = elapsed(loop->due, t->before) > (int64_t)(loop->period >> ISO_LATE_SHIFT),
        .overran = margin < 0,
    };

    statistics->lost += behind(loop) != 0;
    statistics->late += news.late;
    statistics->overruns += news.overran;
    if (margin < statistics->margin) {
        statistics->margin = margin;
        loop->used = margin < 0 ? loop->period : loop->period - (uint32_t)margin;
    }
    if (restarted) {
        statistics->restarts++;
        statistics->restart_max = larger(statistics->restart_max, news.counts);
    } else {
        statistics->execution_min = smaller(statistics->execution_min, news.counts);
        statistics->execution_max = larger(statistics->execution_max, news.counts);
        statistics->execution_sum += news.counts;
        loop->execution_min = (uint32_t)smaller(statistics->execution_min, UINT32_MAX);
        loop->execution_max = (uint32_t)smaller(statistics->execution_max, UINT32_MAX);
    }
    const bool goes_on = policy == NULL || policy->account(loop, &news);
    if (!goes_on) {
        iso_port_safe();
    }
    return goes_on;
}

/* Updates the statistics with a tick. Most have no news: a margin and an execution like those before. They add to two
 * sums alone; and as they end less than a period after they were due, their times have 32 bits. Returns whether the run
 * goes on.
 */
ISO_INLINE bool book(iso_loop *const loop, const times *const t, const bool restarted)
{
    iso_statistics *const statistics = &loop->statistics;
    const uint64_t used = t->end - loop->due;
    const uint32_t late = (uint32_t)t->before - (uint32_t)loop->due;
    const uint32_t counts = (uint32_t)t->after - (uint32_t)t->before - loop->overhead;

    statistics->ticks++;
    if (used >> 32 != 0 || (uint32_t)used > loop->used || late > loop->period >> ISO_LATE_SHIFT || behind(loop) != 0 ||
        restarted || counts < loop->execution_min || counts > loop->execution_max) {
        return book_times(loop, t, restarted);
    }
    statistics->execution_sum += counts;
    return true;
}

/* Counts inputs and parameters that were refused. */
ISO_APART ISO_RARE static void book_refused(iso_statistics *const statistics, const iso_refused refused)
{
    iso_count_refused(&statistics->inputs, (uint32_t)refused);
    iso_count_refused(&statistics->parameters, (uint32_t)(refused >> 32));
}

/* A tick with a bad state or a bad output. Returns whether the run goes on. */
ISO_APART ISO_RARE static bool accept(iso_loop *const loop, const uint32_t finished)
{
    loop->guard = iso_plant_guard(loop->plant, finished);
    const bool good = finished == ISO_HELD;
    if (good) {
        loop->statistics.outputs_held++;
    } else {
        if (loop->plant->nearness != NULL) {
            iso_plant_tell_nearness(loop->plant, loop->tick, &loop->statistics);
        }
        iso_port_safe();
    }
    return good;
}

ISO_INLINE void begin_tick(iso_loop *const loop, const iso_plant *const plant)
{
    while (behind(loop) == 0) { /* a port that wakes up without a tick is asked again */
        loop->reported = iso_port_wait() - loop->rested;
    }
    if (loop->at_once == 0) {
        iso_port_publish(plant->y, plant->model->outputs);
    }
    iso_plant_drive(plant, loop->tick);
}

ISO_INLINE bool end_tick(iso_loop *const loop, const iso_plant *const plant)
{
    const iso_model *const model = plant->model;
    bool (*const attempt)(const iso_plant *) = model->attempt;

    const iso_refused refused = iso_plant_admit(plant);
    if (refused != 0) {
        book_refused(&loop->statistics, refused);
    }
    loop->tick++;
    loop->due += loop->period;

    times t;
    bool restarted = false;
    t.before = iso_port_clock();
    if (attempt == NULL) {
        model->step(plant->memory);
    } else {
        restarted = attempt(plant);
    }
    t.after = iso_port_clock();

    const uint32_t finished = model->finish(plant->memory);
    if (finished != ISO_WELL && !accept(loop, finished)) {
        return false;
    }
    iso_port_publish(plant->y, loop->at_once);
    if (model->tell != NULL) {
        model->tell(plant, loop->tick, &loop->statistics);
    }
    t.end = iso_port_clock();
    return book(loop, &t, restarted);
}

void iso_loop_begin(iso_loop *const loop)
{
    begin_tick(loop, loop->plant);
}

bool iso_loop_end(iso_loop *const loop)
{
    return end_tick(loop, loop->plant);
}

bool iso_loop_tick(iso_loop *const loop)
{
    const iso_plant *const plant = loop->plant;
    begin_tick(loop, plant);
    iso_port_read(plant->u, plant->model->inputs);
    return end_tick(loop, plant);
}

void iso_loop_pass(iso_loop *const loop, const uint64_t ticks)
{
    loop->rested += ticks;
    loop->due += ticks * loop->period;
}

void iso_loop_rest(iso_loop *const loop)
{
    const uint64_t passed = iso_port_wait() - loop->rested - loop->tick;
    iso_loop_pass(loop, passed);
    loop->reported = loop->tick;
}

void iso_loop_restart(iso_loop *const loop)
{
    iso_loop_rest(loop);
    loop->rested += loop->tick;
    loop->tick = loop->reported = 0;
    if (loop->plant->model->policy != NULL) {
        iso_policy_reset(loop->plant->model->policy);
    }
    start_plant(loop);
}

void iso_loop_jump(iso_loop *const loop, const uint64_t tick)
{
    const iso_plant *const plant = loop->plant;
    loop->rested += loop->tick - tick; /* modulo 2^64, as their sum is */
    loop->reported += tick - loop->tick;
    loop->tick = tick;
    loop->guard = plant->model->states;
    loop->execution_min = UINT32_MAX; /* the next tick is one with news, as each on a lower rung is */
    iso_port_publish(plant->y, plant->model->outputs);
}
