#include "core/numbers/self_check.h"
#include "core/runtime/hash.h"
#include "core/runtime/tick.h"
#include "tools/sweep/steps.h"

const unsigned steps_width = 1;

bool steps_keep_bits(void)
{
    return iso_bits_are_kept();
}

plant_facts steps_facts(const iso_plant *const plant)
{
    const iso_model *const m = plant->model;
    return (plant_facts){m->name, m->state_names, m->output_names, m->outputs, m->parameters, m->defaults};
}

static void see(account *const a, const iso_plant *const plant, const shown *const what, const bool first)
{
    for (uint16_t i = 0; i < plant->model->outputs; i++) {
        seen *const s = &a->outputs[i];
        const real y = plant->y[i];
        if ((what->of_output[i] & SHOWS_EXTREMES) != 0) {
            s->least = first || y < s->least ? y : s->least;
            s->most = first || y > s->most ? y : s->most;
        }
        if ((what->of_output[i] & SHOWS_SUMS) != 0) {
            s->sum += (double)y;
            s->squares += (double)y * (double)y;
        }
    }
}

static void note_guard(account *const a, const iso_plant *const plant, const uint16_t guard)
{
    a->state = guard;
    a->ending = guard > plant->model->states           ? ENDS_NEAR
                : iso_not_finite(plant->x[guard]) != 0 ? ENDS_NOT_FINITE
                                                       : ENDS_OUT_OF_RANGE;
}

/* The same ticks as of the loop of a program (core/runtime/loop.h) in virtual time, where no tick is late. */
static void go(const iso_plant *const plant, account *const a, const shown *const what)
{
    const iso_model *const m = plant->model;
    iso_tick_counts counts = {.restarts = 0};
    (void)iso_plant_output(plant);
    see(a, plant, what, true);
    for (uint64_t time = 0; time < sweep_duration_ns && a->ending == ENDS_WELL; time += m->period_ns) {
        const uint16_t guard = iso_plant_tick_counted(plant, a->ticks, &counts);
        if (guard != m->states) {
            note_guard(a, plant, guard);
        } else {
            a->ticks++;
            a->hash = what->hash ? iso_hash_reals(a->hash, plant->x, m->states) : a->hash;
            see(a, plant, what, false);
        }
    }
    a->restarts = counts.restarts;
    for (uint16_t i = 0; i < m->outputs; i++) {
        a->outputs[i].last = plant->y[i];
    }
}

void steps_make(const iso_plant *const plant, account *const *const runs, const uint64_t count, const shown *const what)
{
    const iso_model *const m = plant->model;
    for (uint64_t i = 0; i < count; i++) {
        account *const a = runs[i];
        const size_t bytes = m->parameters * sizeof *a->values;
        iso_plant_reset(plant);
        if (bytes > 0) {
            memcpy(plant->p, a->values, bytes);
        }
        if (a->variant->start != NULL) {
            memcpy(plant->x, a->variant->start, m->states * sizeof *plant->x);
        }
        /* A start puts a tunable right that is beyond its limits, or breaks a condition. */
        if (iso_plant_begin(plant) && (bytes == 0 || memcmp(plant->p, a->values, bytes) == 0)) {
            go(plant, a, what);
        } else {
            a->ending = ENDS_REFUSED;
        }
    }
}
