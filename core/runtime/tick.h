/* A tick of a plant, without a port: iso_plant_tick, and the parts of it between which a loop reads inputs and clock.
 *
 *     iso_plant_drive    sets the inputs that are functions of time (core/runtime/plant.h)
 *     iso_plant_admit    checks inputs and parameters, once the platform has set its own (there too)
 *     iso_plant_step     makes the step, with a new history where there is a discontinuity
 *     model->finish      checks the states; if all are good, sets the memories and the outputs, and checks these
 *     iso_plant_tell     adds the facts about the tick to the statistics
 * Who writes states between ticks calls iso_plant_output: outputs find the sines that the next step begins with.
 */
#ifndef ISO_CORE_RUNTIME_TICK_H
#define ISO_CORE_RUNTIME_TICK_H

#include "core/numbers/unroll.h"
#include "core/runtime/plant.h"

/* What model->finish returns. It is a function of the model so that its sizes are constants there. */
enum {
    ISO_WELL = 0,
    ISO_HELD = 1, /* an output is not finite: the last good ones stand in the place of all */
    ISO_BAD = 2,  /* a state is not finite or out of its range: memories and outputs stay as they were */
    ISO_NEAR = 3  /* likewise, after a step near a singular position, where the scene says `near stop` */
};

/* Not zero if one of x[n] is not finite, or beyond its range; without a branch on them. range is NULL where there is
 * none. */
ISO_INLINE iso_bits iso_any_beyond(const real *const x, const iso_scalar *const range, const uint32_t n)
{
    iso_bits bad = ISO_NOTHING;
    ISO_UNROLL_LONG
    for (uint32_t i = 0; i < n; i++) {
        bad |= range == NULL ? iso_not_finite(x[i]) : iso_beyond(x[i], iso_all(range[i]));
    }
    return bad;
}

/* Copies n reals in pieces of 64 bytes, which compilers do without a call. */
ISO_INLINE void iso_copy(real *const to, const real *const from, const uint32_t n)
{
    const uint32_t piece = sizeof(real) < 64 ? 64 / sizeof(real) : 1;
    ISO_UNROLL_LONG
    for (uint32_t i = 0; i < n; i += piece) {
        memcpy(to + i, from + i, (n - i < piece ? n - i : piece) * sizeof *to);
    }
}

/* x[n] are the states, with their range. `advance` sets the memories (NULL: there are none), `output` the outputs
 * y[outputs]. good[] has the last good ones. */
ISO_INLINE iso_count iso_finish(void *const memory, const real *const x, const iso_scalar *const range,
                                const uint32_t n, void (*const advance)(void *), void (*const output)(void *),
                                real *const y, real *const good, const uint32_t outputs)
{
    if (iso_any(iso_any_beyond(x, range, n))) {
        return ISO_COUNT(ISO_BAD);
    }
    if (advance != NULL) {
        advance(memory);
    }
    output(memory);
    const iso_bits held = iso_any_beyond(y, NULL, outputs);
    if (iso_any(held)) {
        iso_hold(y, good, outputs, held);
        return iso_count_where(held, ISO_HELD);
    }
    iso_copy(good, y, outputs);
    return ISO_COUNT(ISO_WELL);
}

#ifdef ISO_LANES
#include "core/runtime/lanes.h"
#else

#include "core/runtime/statistics.h"

/* Makes the step; with a new history, if an input or a parameter has a discontinuity. Where one is detected within
 * the step, puts all memory back to where it began, and makes it again with a new history. After a restart the same
 * step would come out again. Its error stays known, so that a plant with a discontinuity in every step does not restart
 * in every tick. Returns whether there is a new history. */
static inline iso_flag iso_plant_attempt(const iso_plant *const plant)
{
    const iso_model *const model = plant->model;
    if (plant->before != NULL) {
        memcpy(plant->before, plant->memory, model->memory_bytes);
    }
    const bool restarts = model->discontinuity != NULL && model->discontinuity(plant->memory);
    if (restarts) {
        model->prime(plant->memory);
    }
    model->step(plant->memory);
    const bool again = plant->before != NULL && plant->progress->discontinuity && !restarts;
    if (again) {
        const iso_progress progress = *plant->progress;
        memcpy(plant->memory, plant->before, model->memory_bytes);
        *plant->progress = progress;
        model->prime(plant->memory);
        model->step(plant->memory);
    }
    return restarts || again;
}

static inline bool iso_plant_step(const iso_plant *const plant)
{
    if (plant->model->attempt != NULL) {
        return plant->model->attempt(plant);
    }
    plant->model->step(plant->memory);
    return false;
}

/* Counts a tick, number `tick` from 1 on, if its step came near a singular position, and clears that flag. No branch
 * depends on it. */
static inline void iso_plant_tell_nearness(const iso_plant *const plant, const uint64_t tick,
                                           iso_statistics *const statistics)
{
    const uint32_t closure = plant->nearness->closure;
    const uint64_t near = (closure | (0 - closure)) >> 31;
    const uint64_t before = statistics->near_singular;
    const uint64_t first = (0 - near) & (((before | (0 - before)) >> 63) - 1);
    statistics->near_singular += near;
    statistics->near_singular_first |= first & tick;
    statistics->near_singular_closure |= first & (closure - 1);
    plant->nearness->closure = 0;
}

/* Adds the events of a tick, and sets their counts to 0. */
static inline void iso_plant_tell_events(const iso_plant *const plant, iso_statistics *const statistics)
{
    statistics->events += plant->event_counts->fired;
    statistics->late_events += plant->event_counts->late;
    memset(plant->event_counts, 0, sizeof *plant->event_counts);
}

/* The facts about a tick: the violation of the plant's closures, their nearness to a singular position, and the
 * local error of its steps. */
static inline void iso_plant_tell(const iso_plant *const plant, const uint64_t tick, iso_statistics *const statistics)
{
    const iso_model *const model = plant->model;
    if (plant->nearness != NULL) {
        iso_plant_tell_nearness(plant, tick, statistics);
    }
    if (plant->event_counts != NULL) {
        iso_plant_tell_events(plant, statistics);
    }
    if (model->violation != NULL) {
        const real off = model->violation(plant->memory);
        statistics->violated += (uint32_t)(iso_less(model->violation_limit, off) & 1);
        statistics->violation = iso_max(statistics->violation, off);
    }
    if (plant->progress != NULL) {
        statistics->local_error = iso_max(statistics->local_error, plant->progress->local_error);
    }
}

/* The guard, from the result of model->finish: the first state that is not finite or out of its range; model->states if
 * there is none; model->states + 1 near a singular position that stops the plant. */
static inline uint16_t iso_plant_guard(const iso_plant *const plant, const uint32_t finished)
{
    const iso_scalar *const range = plant->model->range;
    if (finished == ISO_NEAR) {
        return (uint16_t)(plant->model->states + 1);
    }
    uint16_t i = finished == ISO_BAD ? 0 : plant->model->states;
    while (i < plant->model->states && iso_beyond(plant->x[i], range == NULL ? ISO_REAL_MAX : range[i]) == 0) {
        i++;
    }
    return i;
}

/* The outputs without a step, at the start: where one is not finite, all are the last good ones, or 0 if there are
 * none. Returns whether one was not. */
static inline bool iso_plant_output(const iso_plant *const plant)
{
    const iso_model *const model = plant->model;
    real *const good = plant->good + model->inputs + model->parameters;
    model->output(plant->memory);
    const bool held = iso_any_beyond(plant->y, NULL, model->outputs) != 0;
    memcpy(held ? plant->y : good, held ? good : plant->y, model->outputs * sizeof *good);
    return held;
}

/* Refusals and restarts of the plant. */
typedef struct iso_tick_counts {
    iso_refusals inputs;
    iso_refusals parameters;
    uint64_t outputs_held;  /* ticks in which an output was not finite: the last good ones stand */
    uint64_t restarts;      /* with a new history of the method, after a discontinuity */
    uint64_t near_singular; /* ticks with a step near a singular position of closures */
    uint64_t events;        /* that fired, */
    uint64_t late_events;   /* and that waited for the next step, as another came first */
} iso_tick_counts;

/* A whole tick, from `tick` (0 after iso_plant_start) to the next; inputs that are no functions of time are those in
 * plant->u. A value that is not finite or beyond its limits is corrected, and counted. Returns the guard: model->states
 * if all is well; else the outputs stay as they were. */
static inline uint16_t iso_plant_tick_counted(const iso_plant *const plant, const uint64_t tick,
                                              iso_tick_counts *const counts)
{
    iso_plant_drive(plant, tick);
    const iso_refused refused = iso_plant_admit(plant);
    iso_count_refused(&counts->inputs, (uint32_t)refused);
    iso_count_refused(&counts->parameters, (uint32_t)(refused >> 32));
    counts->restarts += iso_plant_step(plant);
    const uint32_t finished = plant->model->finish(plant->memory);
    counts->outputs_held += finished == ISO_HELD;
    if (plant->nearness != NULL) {
        counts->near_singular += plant->nearness->closure != 0;
        plant->nearness->closure = 0;
    }
    if (plant->event_counts != NULL) {
        counts->events += plant->event_counts->fired;
        counts->late_events += plant->event_counts->late;
        memset(plant->event_counts, 0, sizeof *plant->event_counts);
    }
    return iso_plant_guard(plant, finished);
}

/* The same, without the counts. */
static inline uint16_t iso_plant_tick(const iso_plant *const plant, const uint64_t tick)
{
    iso_tick_counts unused = {{0, 0}, {0, 0}, 0, 0, 0, 0, 0};
    return iso_plant_tick_counted(plant, tick, &unused);
}

#endif

#endif
