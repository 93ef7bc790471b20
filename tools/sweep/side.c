/* A group of runs is side by side: run i of it in lane i. Lanes behind the last run, and those of runs that the guard
 * has ended, are copies of another one; nobody looks at them. */
#include <stdlib.h>

#include "core/numbers/self_check.h"
#include "core/runtime/hash.h"
#include "core/runtime/tick.h"
#include "tools/file/file.h"
#include "tools/sweep/steps.h"

const unsigned steps_width = ISO_LANES;

bool steps_keep_bits(void)
{
    return iso_bits_are_kept();
}

plant_facts steps_facts(const iso_plant *const plant)
{
    const iso_model *const m = plant->model;
    return (plant_facts){m->name, m->state_names, m->output_names, m->outputs, m->parameters, m->defaults};
}

typedef double doubles __attribute__((vector_size(ISO_LANES * sizeof(double))));

/* An output of all lanes that the table shows. */
typedef struct lanes_seen {
    real least, most;
    doubles sum, squares;
    uint16_t output;
    uint8_t shows;
} lanes_seen;

/* A group of runs. */
typedef struct group {
    iso_lanes lanes;
    account *runs[ISO_LANES]; /* NULL: the lane has none, or none that goes on */
    unsigned count;
    lanes_seen *outputs;
    uint16_t output_count;
    bool has_hash;
    iso_hashes hashes;
} group;

/* Memory for vectors, of zeros. */
static void *rows_for(const size_t bytes)
{
    const size_t row = sizeof(doubles), whole = (bytes + row) / row * row;
    void *const memory = aligned_alloc(row, whole);
    if (memory == NULL) {
        quit("sweep: memory is missing");
    }
    return memset(memory, 0, whole);
}

/* Puts the runs to tick 0, and says which are refused: a start puts a tunable right that is beyond its limits, or
 * breaks a condition. */
static iso_flag begin(group *const g)
{
    const iso_plant *const plant = &g->lanes.plant;
    const iso_model *const m = plant->model;
    iso_flag refused;
    iso_plant_reset(plant);
    for (unsigned lane = 0; lane < ISO_LANES; lane++) {
        const account *const a = g->runs[lane < g->count ? lane : 0];
        for (uint16_t i = 0; i < m->parameters; i++) {
            plant->p[i][lane] = a->values[i];
        }
        for (uint16_t i = 0; i < m->states && a->variant->start != NULL; i++) {
            plant->x[i][lane] = a->variant->start[i];
        }
    }
    (void)iso_lanes_begin(&g->lanes);
    refused = iso_not_finite(plant->x[0]);
    for (unsigned lane = 0; lane < g->count; lane++) {
        for (uint16_t i = 0; i < m->parameters; i++) {
            const iso_scalar now = plant->p[i][lane];
            refused[lane] |= memcmp(&now, &g->runs[lane]->values[i], sizeof now) != 0;
        }
    }
    return refused;
}

static void see(group *const g, const bool first)
{
    for (uint16_t i = 0; i < g->output_count; i++) {
        lanes_seen *const s = &g->outputs[i];
        const real y = g->lanes.plant.y[s->output];
        if ((s->shows & SHOWS_EXTREMES) != 0) {
            s->least = first ? y : iso_select((iso_bits)(y < s->least), y, s->least);
            s->most = first ? y : iso_select((iso_bits)(y > s->most), y, s->most);
        }
        if ((s->shows & SHOWS_SUMS) != 0) {
            const doubles wide = __builtin_convertvector(y, doubles);
            s->sum = first ? wide : s->sum + wide;
            s->squares = first ? wide * wide : s->squares + wide * wide;
        }
    }
}

/* The account of a run that has made so many ticks. */
static void note(group *const g, const unsigned lane, const uint64_t ticks)
{
    account *const a = g->runs[lane];
    a->ticks = ticks;
    a->restarts = g->lanes.statistics.restarts[lane];
    a->hash = g->hashes[lane];
    for (uint16_t i = 0; i < g->output_count; i++) {
        const lanes_seen *const s = &g->outputs[i];
        a->outputs[s->output] = (seen){.last = g->lanes.plant.y[s->output][lane],
                                       .least = s->least[lane],
                                       .most = s->most[lane],
                                       .sum = s->sum[lane],
                                       .squares = s->squares[lane]};
    }
    g->runs[lane] = NULL;
}

/* How the guard ended the run of a lane. */
static void note_guard(const group *const g, const unsigned lane, account *const a)
{
    const iso_plant *const plant = &g->lanes.plant;
    const iso_model *const m = plant->model;
    a->ending = ENDS_NEAR;
    for (uint16_t i = 0; i < m->states && g->lanes.stopped_near[lane] == 0; i++) {
        if (iso_beyond(plant->x[i], iso_all(m->range == NULL ? ISO_REAL_MAX : m->range[i]))[lane] != 0) {
            a->state = i;
            a->ending = iso_not_finite(plant->x[i])[lane] != 0 ? ENDS_NOT_FINITE : ENDS_OUT_OF_RANGE;
            return;
        }
    }
}

/* Ends the runs of the lanes that the guard has stopped in the last tick; these go on as copies of one that runs. */
static void end_stopped(group *const g)
{
    iso_lanes *const lanes = &g->lanes;
    for (unsigned lane = 0; lane < ISO_LANES; lane++) {
        if (lanes->statistics.stopped[lane] != 0 && g->runs[lane] != NULL) {
            note_guard(g, lane, g->runs[lane]);
            note(g, lane, lanes->tick - 1);
        }
    }
    (void)iso_lanes_lead(lanes);
    lanes->statistics.stopped = lanes->stopped_near = ISO_NOTHING;
}

/* The ticks of a group from its start: in each lane those of alone.c. */
static void go(group *const g)
{
    const iso_plant *const plant = &g->lanes.plant;
    const iso_model *const m = plant->model;
    bool runs = true;
    g->hashes = (iso_hashes){0} + ISO_HASH_START;
    see(g, true);
    for (uint64_t time = 0; time < sweep_duration_ns && runs; time += m->period_ns) {
        runs = iso_lanes_tick(&g->lanes);
        if (iso_any(g->lanes.statistics.stopped)) {
            end_stopped(g);
        }
        g->hashes = g->has_hash ? iso_hash_lanes(g->hashes, plant->x, m->states) : g->hashes;
        see(g, false);
    }
    for (unsigned lane = 0; lane < g->count; lane++) {
        if (g->runs[lane] != NULL) {
            note(g, lane, g->lanes.tick);
        }
    }
}

/* A group without runs, with memory of its own. Nobody looks at the violation and the errors of ticks, so that they are
 * not computed; whoever tells of nearness also forgets it. */
static group group_of(const iso_plant *const plant, iso_model *const m, const shown *const what)
{
    const size_t bytes = plant->model->memory_bytes;
    group g = {.lanes = {.plant = *plant, .parked = rows_for(bytes)}, .has_hash = what->hash};
    *m = *plant->model;
    m->tell = plant->nearness == NULL ? NULL : m->tell;
    g.lanes.plant.model = m;
    g.lanes.plant.spare = rows_for(bytes);
    g.lanes.plant.before = plant->before == NULL ? NULL : rows_for(bytes);
    g.outputs = rows_for(m->outputs * sizeof *g.outputs);
    for (uint16_t i = 0; i < m->outputs; i++) {
        if (what->of_output[i] != 0) {
            g.outputs[g.output_count++] = (lanes_seen){.output = i, .shows = what->of_output[i]};
        }
    }
    return g;
}

/* The next runs that are not refused, as many as there are lanes; so that the others take none. Returns where the next
 * group begins. */
static uint64_t gather(group *const g, account *const *const runs, const uint64_t count, uint64_t next)
{
    g->count = 0;
    memset(g->runs, 0, sizeof g->runs);
    while (next < count && g->count < ISO_LANES) {
        if (runs[next]->ending == ENDS_WELL) {
            g->runs[g->count++] = runs[next];
        }
        next++;
    }
    return next;
}

void steps_make(const iso_plant *const plant, account *const *const runs, const uint64_t count, const shown *const what)
{
    iso_model model;
    group g = group_of(plant, &model, what);
    for (uint64_t next = 0; next < count;) {
        next = gather(&g, runs, count, next);
        const iso_flag refused = begin(&g);
        for (unsigned lane = 0; lane < g.count; lane++) {
            g.runs[lane]->ending = refused[lane] != 0 ? ENDS_REFUSED : ENDS_WELL;
        }
    }
    for (uint64_t next = 0; next < count;) {
        next = gather(&g, runs, count, next);
        if (g.count > 0) {
            (void)begin(&g);
            go(&g);
        }
    }
    free(g.outputs);
    free(g.lanes.plant.before);
    free(g.lanes.plant.spare);
    free(g.lanes.parked);
}
