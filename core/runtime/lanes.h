/* A tick of plants side by side: core/runtime/tick.h of a build with lanes. Steps, memories and outputs are computed in
 * all lanes at once. An action of some lanes only (a restart, a repeated step, the end at the guard) is computed in
 * all, and its result is copied into these lanes. A branch tests whether there is such a lane; no branch tests which.
 *
 *     static plant_memory memory, parked, spare;
 *     iso_lanes lanes = {.plant = plant_plant(&memory), .parked = &parked};
 *     lanes.plant.spare = &spare;
 *     iso_lanes_start(&lanes);
 *     lanes.plant.p[PLANT_P_MASS][3] = 0.2f;    in lane 3
 *     while (iso_lanes_tick(&lanes)) { ... lanes.plant.y[PLANT_Y_ANGLE][3] ... }
 */
#ifndef ISO_CORE_RUNTIME_LANES_H
#define ISO_CORE_RUNTIME_LANES_H

#include "core/runtime/hash.h"
#include "core/runtime/plant.h"

/* Statistics of the ticks of each lane. */
typedef struct iso_statistics {
    iso_flag stopped; /* by the guard: these lanes stand still, and nothing is counted of them */
    iso_refusals inputs[ISO_LANES];
    iso_refusals parameters[ISO_LANES];
    uint64_t restarts[ISO_LANES];     /* with a new history of the method, after a discontinuity */
    uint64_t outputs_held[ISO_LANES]; /* in which an output was not finite: the last good ones stand */
    uint64_t violated[ISO_LANES];     /* that ended with a violation above the limit of the plant */
    uint64_t near_singular[ISO_LANES];
    uint64_t events[ISO_LANES];
    uint64_t late_events[ISO_LANES];
    real local_error; /* the largest of all steps, where steps are checked */
    real violation;   /* the largest of all ticks */
} iso_statistics;

typedef struct iso_lanes {
    iso_plant plant;
    void *parked;                   /* [memory_bytes] the state of lanes that the guard has stopped */
    uint64_t tick;                  /* that are done */
    uint64_t stopped_at[ISO_LANES]; /* the tick that ended so, from 1 on */
    iso_flag stopped_near;          /* of them, near a singular position */
    iso_statistics statistics;
} iso_lanes;

/* Rows of a memory, one word of each lane in each: to[row] = from[row] in the lanes of a mask. */
static inline void iso_lanes_take(void *const to, const void *const from, const size_t bytes, const iso_bits mask)
{
    for (size_t at = 0; at + sizeof(iso_bits) <= bytes; at += sizeof(iso_bits)) {
        iso_bits mine, other;
        memcpy(&mine, (char *)to + at, sizeof mine);
        memcpy(&other, (const char *)from + at, sizeof other);
        mine = (other & mask) | (mine & ~mask);
        memcpy((char *)to + at, &mine, sizeof mine);
    }
}

/* Each lane of a mask gets the state of one lane. */
static inline void iso_lanes_follow(void *const memory, const size_t bytes, const unsigned lane, const iso_bits mask)
{
    for (size_t at = 0; at + sizeof(iso_bits) <= bytes; at += sizeof(iso_bits)) {
        iso_bits row;
        memcpy(&row, (char *)memory + at, sizeof row);
        const iso_word word = row[lane];
        row = ((iso_bits){ISO_REPEAT(ISO_LANES, word)} & mask) | (row & ~mask);
        memcpy((char *)memory + at, &row, sizeof row);
    }
}

/* A new history in the lanes of a mask. */
static inline void iso_lanes_prime(const iso_plant *const plant, const iso_flag restarts)
{
    const size_t bytes = plant->model->memory_bytes;
    memcpy(plant->spare, plant->memory, bytes);
    plant->model->prime(plant->memory);
    iso_lanes_take(plant->memory, plant->spare, plant->lane_bytes, ~restarts);
}

/* Makes the step: in each lane iso_plant_attempt of a single plant. Returns the lanes with a new history. */
static inline iso_flag iso_plant_attempt(const iso_plant *const plant)
{
    const iso_model *const model = plant->model;
    const size_t bytes = model->memory_bytes;
    if (plant->before != NULL) {
        memcpy(plant->before, plant->memory, bytes);
    }
    const iso_flag restarts = model->discontinuity != NULL ? model->discontinuity(plant->memory) : ISO_NOTHING;
    if (iso_any(restarts)) {
        iso_lanes_prime(plant, restarts);
    }
    model->step(plant->memory);
    const iso_flag again = plant->before != NULL ? plant->progress->discontinuity & ~restarts : ISO_NOTHING;
    if (iso_any(again)) {
        const iso_progress progress = *plant->progress;
        memcpy(plant->spare, plant->memory, bytes);
        memcpy(plant->memory, plant->before, bytes);
        *plant->progress = progress;
        model->prime(plant->memory);
        model->step(plant->memory);
        iso_lanes_take(plant->memory, plant->spare, plant->lane_bytes, ~again);
    }
    return restarts | again;
}

/* Adds 1 to the counts of the lanes of a mask. */
static inline void iso_lanes_count(uint64_t *const counts, const iso_flag mask)
{
    for (unsigned lane = 0; lane < ISO_LANES && iso_any(mask); lane++) {
        counts[lane] += mask[lane] & 1;
    }
}

/* Adds the count of each lane. */
static inline void iso_lanes_sum(uint64_t *const counts, const iso_count more)
{
    for (unsigned lane = 0; lane < ISO_LANES && iso_any(more); lane++) {
        counts[lane] += more[lane];
    }
}

static inline void iso_lanes_count_refused(iso_refusals *const counts, const iso_count refused)
{
    for (unsigned lane = 0; lane < ISO_LANES && iso_any(refused); lane++) {
        iso_count_refused(&counts[lane], (uint32_t)refused[lane]);
    }
}

/* Adds the events of a step, of each lane, and sets their counts to 0. */
static inline void iso_lanes_tell_events(const iso_plant *const plant, iso_statistics *const statistics)
{
    iso_lanes_sum(statistics->events, plant->event_counts->fired & ~statistics->stopped);
    iso_lanes_sum(statistics->late_events, plant->event_counts->late & ~statistics->stopped);
    memset(plant->event_counts, 0, sizeof *plant->event_counts);
}

/* The statistics of a tick, of each lane. */
static inline void iso_plant_tell(const iso_plant *const plant, const uint64_t tick, iso_statistics *const statistics)
{
    const iso_model *const model = plant->model;
    (void)tick;
    if (plant->nearness != NULL) {
        iso_lanes_count(statistics->near_singular, iso_is_set(plant->nearness->closure) & ~statistics->stopped);
        plant->nearness->closure = ISO_NOTHING;
    }
    if (model->violation != NULL) {
        const real off = iso_select(statistics->stopped, R(0.0), model->violation(plant->memory));
        iso_lanes_count(statistics->violated, iso_less(iso_all(model->violation_limit), off));
        statistics->violation = iso_max(statistics->violation, off);
    }
    if (plant->progress != NULL) {
        const real error = iso_select(statistics->stopped, R(0.0), plant->progress->local_error);
        statistics->local_error = iso_max(statistics->local_error, error);
    }
}

/* The lanes whose last step was near a singular position that stops them, or else whose states are out of their ranges.
 */
static inline iso_flag iso_lanes_bad(const iso_plant *const plant, const bool near)
{
    const iso_model *const model = plant->model;
    return near ? iso_is_set(plant->nearness->closure) : iso_any_beyond(plant->x, model->range, model->states);
}

/* In the memory, lanes that the guard has stopped get the state of the first one that runs, so that no bad number
 * enters a computation. Returns whether a lane runs. */
static inline bool iso_lanes_lead(const iso_lanes *const lanes)
{
    const iso_flag stopped = lanes->statistics.stopped;
    unsigned leader = 0;
    while (leader < ISO_LANES && stopped[leader] != 0) {
        leader++;
    }
    if (leader < ISO_LANES) {
        iso_lanes_follow(lanes->plant.memory, lanes->plant.lane_bytes, leader, stopped);
    }
    return leader < ISO_LANES;
}

/* Stops the lanes of a mask: their state is copied to `parked`. Returns whether a lane still runs. */
static inline bool iso_lanes_stop(iso_lanes *const lanes, const iso_flag bad)
{
    const size_t bytes = lanes->plant.lane_bytes;
    iso_lanes_take(lanes->parked, lanes->plant.memory, bytes, bad & ~lanes->statistics.stopped);
    if (lanes->plant.nearness != NULL) {
        iso_lanes_count(lanes->statistics.near_singular,
                        iso_is_set(lanes->plant.nearness->closure) & bad & ~lanes->statistics.stopped);
    }
    for (unsigned lane = 0; lane < ISO_LANES; lane++) {
        if (bad[lane] != 0 && lanes->statistics.stopped[lane] == 0) {
            lanes->stopped_at[lane] = lanes->tick + 1;
        }
    }
    lanes->statistics.stopped |= bad;
    return iso_lanes_lead(lanes);
}

/* Checks the states, and sets memories and outputs, of the lanes that run. Returns whether one does. */
static inline bool iso_lanes_finish(iso_lanes *const lanes)
{
    const iso_model *const model = lanes->plant.model;
    iso_count finished = model->finish(lanes->plant.memory);
    while (iso_any(finished & ISO_BAD)) {
        const bool near = iso_any((iso_flag)(finished == ISO_NEAR));
        const iso_flag bad = iso_lanes_bad(&lanes->plant, near);
        lanes->stopped_near |= near ? bad : ISO_NOTHING;
        if (!iso_lanes_stop(lanes, bad)) {
            return false;
        }
        finished = model->finish(lanes->plant.memory);
    }
    iso_lanes_count(lanes->statistics.outputs_held, finished & ~lanes->statistics.stopped);
    return true;
}

/* The outputs without a step, at the start: core/runtime/tick.h. */
static inline void iso_plant_output(const iso_plant *const plant)
{
    const iso_model *const model = plant->model;
    real *const good = plant->good + model->inputs + model->parameters;
    model->output(plant->memory);
    iso_hold(plant->y, good, model->outputs, iso_any_beyond(plant->y, NULL, model->outputs));
}

/* The second part of a start, where a caller has set lanes behind iso_plant_reset. Returns what iso_lanes_start does.
 */
static inline bool iso_lanes_begin(iso_lanes *const lanes)
{
    const bool good = iso_plant_begin(&lanes->plant);
    lanes->tick = 0;
    lanes->stopped_near = ISO_NOTHING;
    memset(&lanes->statistics, 0, sizeof lanes->statistics);
    iso_plant_output(&lanes->plant);
    return good;
}

/* Puts all lanes to tick 0. Returns false where this build computes with other bits: iso_plant_start. */
static inline bool iso_lanes_start(iso_lanes *const lanes)
{
    iso_plant_reset(&lanes->plant);
    return iso_lanes_begin(lanes);
}

/* One tick of all lanes that run; those that the guard has stopped keep their state. Returns whether a lane runs. */
static inline bool iso_lanes_tick(iso_lanes *const lanes)
{
    const iso_plant *const plant = &lanes->plant;
    const iso_model *const model = plant->model;
    const size_t bytes = plant->lane_bytes;
    const bool some_stopped = iso_any(lanes->statistics.stopped);
    if (some_stopped && !iso_lanes_lead(lanes)) {
        return false;
    }
    iso_plant_drive(plant, lanes->tick);
    if (model->admit != NULL) {
        const iso_refused refused = iso_plant_admit(plant);
        iso_lanes_count_refused(lanes->statistics.inputs, refused.first & ~lanes->statistics.stopped);
        iso_lanes_count_refused(lanes->statistics.parameters, refused.second & ~lanes->statistics.stopped);
    }
    if (model->attempt != NULL) {
        const iso_flag restarts = model->attempt(plant);
        iso_lanes_count(lanes->statistics.restarts, restarts & ~lanes->statistics.stopped);
    } else {
        model->step(plant->memory);
    }
    if (plant->event_counts != NULL) {
        iso_lanes_tell_events(plant, &lanes->statistics);
    }
    const bool runs = iso_lanes_finish(lanes);
    if (runs && model->tell != NULL) {
        model->tell(plant, lanes->tick + 1, &lanes->statistics);
    }
    if (some_stopped || !runs || iso_any(lanes->statistics.stopped)) {
        iso_lanes_take(plant->memory, lanes->parked, bytes, lanes->statistics.stopped);
    }
    lanes->tick++;
    return runs;
}

/* Over x[n] of a lane. */
static inline uint64_t iso_hash_lane(uint64_t hash, const real *const x, const size_t n, const unsigned lane)
{
    for (size_t i = 0; i < n; i++) {
        hash = iso_hash_word(hash, iso_bits_of(x[i])[lane]);
    }
    return hash;
}

/* The hashes of all lanes, each over its x[n]. */
typedef uint64_t iso_hashes __attribute__((vector_size(ISO_LANES * sizeof(uint64_t))));

static inline iso_hashes iso_hash_lanes(iso_hashes hashes, const real *const x, const size_t n)
{
    for (size_t i = 0; i < n; i++) {
        iso_hashes bits = __builtin_convertvector(iso_bits_of(x[i]), iso_hashes);
        for (size_t byte = 0; byte < sizeof(iso_word); byte++) {
            hashes = (hashes ^ (bits & 0xFF)) * ISO_HASH_PRIME;
            bits >>= 8;
        }
    }
    return hashes;
}

#endif
