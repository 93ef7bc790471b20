/* The features of a plant, and the names of its parts in C. These call no other part of its source. */
#include <math.h>

#include "tools/isoc/emit/parts.h"

/* Whether something that follows from tunables alone is kept. */
static bool is_tuned(const plant *p)
{
    bool any = p->held.tuned > 0;
    for (int i = 0; i < p->reduced_plant_count; i++) {
        any = any || p->reduced_plants[i].p->held.tuned > 0;
    }
    return any;
}

bool is_primed(const plant *p)
{
    return ISO_IS_PRIMED(p->m->method.recipe) || ISO_DEGREE(p->m->method.recipe) > 0 || is_tuned(p);
}

bool watches_parameters(const plant *p)
{
    return p->m->parameters.count > 0 && (ISO_IS_PRIMED(p->m->method.recipe) || is_tuned(p));
}

bool watches_edges(const mechanism *m)
{
    return m->inputs.edge_count > 0 && ISO_IS_PRIMED(m->method.recipe);
}

bool watches_inputs(const mechanism *m)
{
    bool jumps = false;
    for (int i = 0; i < m->inputs.count; i++) {
        jumps = jumps || m->inputs.jumps[i] > 0.0;
    }
    return jumps && (ISO_IS_PRIMED(m->method.recipe) || ISO_DEGREE(m->method.recipe) > 0);
}

bool can_restart(const plant *p)
{
    return watches_parameters(p) || watches_edges(p->m) || watches_inputs(p->m);
}

long period_of(const plant *p)
{
    return lround(p->m->method.step * 1e9);
}

const char *progress_of(const mechanism *m)
{
    return !ISO_HAS_PROGRESS(m->method.recipe) ? "NULL"
           : ISO_IS_VARYING(m->method.recipe)  ? "&memory->adams.progress"
                                               : "&memory->progress";
}

const char *recipe_symbol(arena *memory, unsigned recipe)
{
    const char *method = capitals_of(memory, method_names[ISO_METHOD_OF(recipe)]);
    const unsigned count = (recipe & ~(unsigned)ISO_PREPARED) >> 8;
    const char *iterations = count == 0 ? "" : arena_format(memory, " | ISO_ITERATIONS(%u)", count);
    return arena_format(memory, "ISO_%s%s%s%s%s%s%s", method, ISO_IS_COMPENSATED(recipe) ? " | ISO_COMPENSATED" : "",
                        ISO_IS_CHECKED(recipe) ? " | ISO_CHECKED" : "", ISO_IS_SMOOTH(recipe) ? " | ISO_SMOOTH" : "",
                        ISO_IS_SETTLED(recipe) ? " | ISO_SETTLED" : "",
                        ISO_IS_PREPARED(recipe) ? " | ISO_PREPARED" : "", iterations);
}

bool settles_by(const plant *p, const graph *g, operation array)
{
    return uses_operation(g, p->after.values, (size_t)p->after.count, array);
}

bool keeps_rows(const plant *p)
{
    bool any = counts_rows(p);
    FOR_ALL (const effect_quantity, e, p->m->effects.memories, p->m->effects.memory_count) {
        any = any || e->kept == KEPT_SAMPLE || (e->kept == KEPT_DELAY && e->ticks > 1.0);
    }
    return any;
}

bool counts_rows(const plant *p)
{
    return p->rows.any || has_slow_outputs(p->m) || has_slow_memories(p->m);
}

bool sets_rows(const plant *p)
{
    return p->m->effects.memory_count > count_shares(p->m) || counts_rows(p);
}

bool is_driven(const plant *p)
{
    bool any = p->m->clocks.count > 0 || keeps_rows(p);
    for (int i = 0; i < p->m->inputs.count; i++) {
        any = any || p->m->inputs.driven[i];
    }
    return any;
}

unsigned long last_of_ring(const effect_quantity *e)
{
    unsigned long places = 1;
    while ((double)places < e->ticks) {
        places *= 2;
    }
    return places - 1;
}

bool begins(const emission *e, const effect_quantity *q)
{
    return !is_zero(e->g, q->begin);
}

bool has_value(const emission *e, int input)
{
    const input_set *all = &e->p->m->inputs;
    return !e->names->is_fmu && !all->driven[input] && is_constant(e->g, all->drives[input]) &&
           !is_zero(e->g, all->drives[input]);
}

bool has_begin(const emission *e)
{
    const mechanism *m = e->p->m;
    bool any = e->names->is_checked || e->p->rows.starts.count > 0 || e->p->rows.any || has_events(m);
    for (int i = 0; i < m->inputs.count; i++) {
        any = any || has_value(e, i);
    }
    for (int i = 0; i < m->effects.memory_count; i++) {
        any = any || begins(e, &m->effects.memories[i]) || is_late(&m->effects.memories[i]);
    }
    return any;
}

const char *held_size(const emission *e)
{
    return form(e, "$C_%s", e->p->m->effects.memory_count > 0 ? "HELD" : "INPUTS");
}

const char *sampled_size(const emission *e)
{
    const bool is_all = e->p->m->inputs.sampled_count > e->p->m->inputs.count;
    return is_all ? held_size(e) : form(e, "$C_INPUTS");
}

bool has_limits(const quantities *content)
{
    bool any = false;
    FOR_ALL (const variable, v, content->all, content->count) {
        any = any || !isinf(v->least) || !isinf(v->most);
    }
    return any;
}
