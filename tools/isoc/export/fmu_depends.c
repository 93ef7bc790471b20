/* The dependencies of an unknown of an FMU, by the graphs of its formula and of those that it reads in a row. */
#include "tools/isoc/export/fmu.h"

/* The leaves that the formulas read so far. */
typedef struct search {
    const fmu *f;
    bool at_start, time;
    bool *states, *held, *parameters; /* held: inputs, then memories */
    bool *rates;                      /* derivatives of states */
} search;

/* The leaves whose formulas have been read. */
typedef struct done_flags {
    bool *states, *held, *rates;
} done_flags;

static bool *flags_for(const fmu *f, int count)
{
    return arena_take(f->memory, (size_t)count + 1, sizeof(bool));
}

static void read_formula(search *s, node root)
{
    const graph *g = s->f->g;
    mark_leaves(g, &root, 1, OP_STATE, s->states);
    mark_leaves(g, &root, 1, OP_INPUT, s->held);
    mark_leaves(g, &root, 1, OP_PARAMETER, s->parameters);
    mark_leaves(g, &root, 1, OP_DERIVATIVE, s->rates);
    s->time = s->time || uses_time(g, &root, 1);
}

/* A memory in this row. Values of earlier rows depend on nothing that is known now; nor do the memories that `next`
 * reads, which are those of before, but for samples. */
static void read_memory(search *s, int which)
{
    const mechanism *m = s->f->p->m;
    const effect_quantity *e = &m->effects.memories[which];
    if (s->at_start) {
        read_formula(s, e->begin);
        return;
    }
    if (is_late(e)) {
        return;
    }
    search inner = *s;
    inner.held = flags_for(s->f, held_count(m));
    read_formula(&inner, e->next);
    s->time = inner.time;
    for (int i = 0; i < held_count(m); i++) {
        const int memory = i - m->inputs.count;
        const bool is_before = memory >= 0 && e->kept == KEPT_NEXT && m->effects.memories[memory].kept != KEPT_SAMPLE;
        s->held[i] = s->held[i] || (inner.held[i] && !is_before);
    }
}

/* An input that is a function of time. */
static void read_input(search *s, int which)
{
    const plant *p = s->f->p;
    if (p->m->inputs.driven[which]) {
        s->time = true;
        read_formula(s, p->m->inputs.drives[which]);
    }
}

/* At the start a state follows from its formula, and a clock of a motion from the time, whatever value was set. */
static void read_state(search *s, int which)
{
    const mechanism *m = s->f->p->m;
    const int effect = which - m->effects.first_state, timer = which - m->clocks.first;
    if (s->at_start && effect >= 0 && effect < m->effects.state_count) {
        read_formula(s, m->effects.states[effect].begin);
    }
    s->time = s->time || (s->at_start && timer >= 0 && timer < m->clocks.count);
}

/* Reads the formulas of the leaves that were found and are not done yet; false where there are none. */
static bool read_found(search *s, done_flags *done)
{
    const mechanism *m = s->f->p->m;
    bool any = false;
    for (int i = 0; i < held_count(m); i++) {
        if (s->held[i] && !done->held[i]) {
            any = done->held[i] = true;
            if (i < m->inputs.count) {
                read_input(s, i);
            } else {
                read_memory(s, i - m->inputs.count);
            }
        }
    }
    for (int i = 0; i < state_count(m); i++) {
        if (s->rates[i] && !done->rates[i]) {
            any = done->rates[i] = true;
            read_formula(s, s->f->p->derivatives[i]);
        }
        if (s->states[i] && !done->states[i]) {
            any = done->states[i] = true;
            read_state(s, i);
        }
    }
    return any;
}

fmu_readings fmu_depends(const fmu *f, node root, bool at_start)
{
    const mechanism *m = f->p->m;
    const int states = state_count(m), inputs_and_memories = held_count(m);
    search s = {.f = f,
                .at_start = at_start,
                .states = flags_for(f, states),
                .held = flags_for(f, inputs_and_memories),
                .parameters = flags_for(f, m->parameters.count),
                .rates = flags_for(f, states)};
    done_flags done = {flags_for(f, states), flags_for(f, inputs_and_memories), flags_for(f, states)};
    read_formula(&s, root);
    while (read_found(&s, &done)) {
    }
    for (int i = 0; at_start && i < m->clocks.count; i++) {
        s.states[m->clocks.first + i] = false;
    }
    return (fmu_readings){s.time, s.held, s.parameters, s.states};
}
