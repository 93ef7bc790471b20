/* Runs a plant, PLANT: with ISO_LANES in lanes, else alone. Both are compiled from this text, so that a plant gets the
 * same. */
#ifdef ISO_LANES
#define plant_model plant_model_of_lanes
#define plant_derivative plant_derivative_of_lanes
#endif
#include PLANT

#include "core/runtime/hash.h"
#include "tests/isoc/emit/lanes/lanes.h"

#ifdef ISO_LANES
#define RUN run_lanes
#define OF(array, i, lane) (array)[i][lane]
#else
#define RUN run_alone
#define OF(array, i, lane) (array)[i]
#endif

/* A number from -1 to 1. */
static iso_scalar unit_of(const uint64_t number)
{
    return (iso_scalar)(int32_t)(uint32_t)(number >> 32) * ISO_SCALAR(4.656612873077393e-10);
}

/* Inputs that change in some ticks, among them no numbers; tunables and faults that change now and then; and the end of
 * some plants, at a state that is none. */
static void act(const iso_plant *const plant, const uint64_t tick, const unsigned number, const unsigned lane)
{
    const iso_model *const model = plant->model;
    const iso_scalar none = ISO_SCALAR(0.0) / (iso_scalar)(tick >> 63); /* a NaN */
    (void)lane;
    for (uint16_t i = 0; i < model->inputs; i++) {
        const uint64_t chosen = number_at(i, tick, number);
        if (chosen % 3 == 0) {
            OF(plant->u, i, lane) = chosen % 101 == 0 ? none : ISO_SCALAR(0.3) * unit_of(chosen);
        }
    }
    for (uint16_t i = 0; i < model->parameters; i++) {
        const uint64_t chosen = number_at(100U + i, tick, number);
        if (chosen % 61 == 0 || tick == 0) {
            const iso_scalar usual = model->defaults[i];
            const iso_scalar other = usual * (ISO_SCALAR(1.0) + ISO_SCALAR(0.1) * unit_of(chosen));
            OF(plant->p, i, lane) = usual != ISO_SCALAR(0.0) ? other : (iso_scalar)(chosen >> 40 & 1);
        }
    }
    for (uint16_t i = 0; i < model->states && tick == 0; i++) {
        OF(plant->x, i, lane) += ISO_SCALAR(1e-3) * unit_of(number_at(200U + i, 0, number));
    }
    if (number % 5 == 3 && tick == 50U + 7U * number) {
        OF(plant->x, 0, lane) = none;
    }
}

/* Of what is no number the bits are no promise. */
static uint64_t hash_of(uint64_t hash, const real *const x, const unsigned n, const unsigned lane)
{
    (void)lane;
    for (unsigned i = 0; i < n; i++) {
        const iso_scalar one = OF(x, i, lane);
        iso_word bits = 1;
        if (one - one == ISO_SCALAR(0.0)) {
            memcpy(&bits, &one, sizeof bits);
        }
        hash = iso_hash_word(hash, bits);
    }
    return hash;
}

static uint64_t hash_of_plant(const iso_plant *const plant, const uint64_t hash, const unsigned lane)
{
    const iso_model *const model = plant->model;
    const uint64_t of_states = hash_of(hash, plant->x, model->states, lane);
    const uint64_t of_held = hash_of(of_states, plant->u, model->inputs + model->memories, lane);
    const uint64_t of_tunables = hash_of(of_held, plant->p, model->parameters, lane);
    return hash_of(of_tunables, plant->y, model->outputs, lane);
}

#ifdef ISO_LANES

static plant_memory parked, spare, other;

/* What there is to tell of a lane; of one that was stopped, the ticks near a singular position since then: none. */
static void tell(const iso_lanes *const all, const unsigned lane, const uint64_t near_until_stop, outcome *const o)
{
    const iso_statistics *const s = &all->statistics;
    o->last = hash_of_plant(&all->plant, ISO_HASH_START, lane);
    o->stopped_at = all->stopped_at[lane];
    o->restarts = s->restarts[lane];
    o->outputs_held = s->outputs_held[lane];
    o->near_singular = s->near_singular[lane] - near_until_stop;
    o->violated = s->violated[lane];
    o->held[0] = s->inputs[lane].held;
    o->held[1] = s->parameters[lane].held;
    o->clamped[0] = s->inputs[lane].clamped;
    o->clamped[1] = s->parameters[lane].clamped;
    o->local_error = (double)s->local_error[lane];
    o->violation = (double)s->violation[lane];
}

void RUN(const uint64_t ticks, const unsigned lanes, outcome *const out)
{
    static iso_lanes all;
    uint64_t near_until_stop[ISO_LANES] = {0};
    (void)lanes;
    all = (iso_lanes){.plant = iso_the_plant, .parked = &parked};
    all.plant.spare = &spare;
    if (all.plant.before != NULL) {
        all.plant.before = &other;
    }
    (void)iso_lanes_start(&all);
    for (unsigned lane = 0; lane < ISO_LANES; lane++) {
        out[lane] = (outcome){.hash = hash_of_plant(&all.plant, ISO_HASH_START, lane)};
    }
    for (uint64_t tick = 0; tick < ticks; tick++) {
        for (unsigned lane = 0; lane < ISO_LANES; lane++) {
            if (all.statistics.stopped[lane] == 0) {
                act(&all.plant, tick, lane, lane);
            }
        }
        (void)iso_lanes_tick(&all);
        for (unsigned lane = 0; lane < ISO_LANES; lane++) {
            near_until_stop[lane] =
                all.stopped_at[lane] == tick + 1 ? all.statistics.near_singular[lane] : near_until_stop[lane];
            if (all.statistics.stopped[lane] == 0) {
                out[lane].hash = hash_of_plant(&all.plant, out[lane].hash, lane);
            }
        }
    }
    for (unsigned lane = 0; lane < ISO_LANES; lane++) {
        tell(&all, lane, near_until_stop[lane], &out[lane]);
    }
}

#else

static void run_one(const uint64_t ticks, const unsigned number, outcome *const o)
{
    const iso_plant *const plant = &iso_the_plant;
    iso_tick_counts counts = {{0, 0}, {0, 0}, 0, 0, 0, 0, 0};
    iso_statistics statistics;
    memset(&statistics, 0, sizeof statistics);
    (void)iso_plant_start(plant);
    (void)iso_plant_output(plant);
    *o = (outcome){.hash = hash_of_plant(plant, ISO_HASH_START, 0)};
    for (uint64_t tick = 0; tick < ticks && o->stopped_at == 0; tick++) {
        act(plant, tick, number, 0);
        if (iso_plant_tick_counted(plant, tick, &counts) != plant->model->states) {
            o->stopped_at = tick + 1;
        } else {
            if (plant->model->tell != NULL) {
                iso_plant_tell(plant, tick + 1, &statistics);
            }
            o->hash = hash_of_plant(plant, o->hash, 0);
        }
    }
    o->last = hash_of_plant(plant, ISO_HASH_START, 0);
    o->restarts = counts.restarts;
    o->outputs_held = counts.outputs_held;
    o->near_singular = o->stopped_at > 0 ? 0 : counts.near_singular; /* the sign of a NaN is no promise */
    o->violated = statistics.violated;
    o->held[0] = counts.inputs.held;
    o->held[1] = counts.parameters.held;
    o->clamped[0] = counts.inputs.clamped;
    o->clamped[1] = counts.parameters.clamped;
    o->local_error = (double)statistics.local_error;
    o->violation = (double)statistics.violation;
}

void RUN(const uint64_t ticks, const unsigned lanes, outcome *const out)
{
    for (unsigned number = 0; number < lanes; number++) {
        run_one(ticks, number, &out[number]);
    }
}

#endif
