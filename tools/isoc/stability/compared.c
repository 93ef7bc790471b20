#include "tools/isoc/stability/stability.h"

#include <math.h>

/* Steps that both sides are near each other, and near as a part of the largest difference so far. */
enum { STEPS_TOGETHER = 100 };
static const double near_each_other = 1e-6;

static bool *flag_of(const compared *c, const course *w, int number, int memory)
{
    return &c->acts[number * w->m->effects.memory_count + memory];
}

/* Marks the states that the comparisons in the formula of a memory read. */
static void mark_compared(const course *w, int memory, bool *states)
{
    const graph *g = &w->nexts.g;
    for (reached r = reach(g, &w->nexts.roots[memory], 1); reach_next(&r);) {
        if (w->nexts.switches[r.at]) {
            mark_leaves(g, &r.at, 1, OP_STATE, states);
        }
    }
}

compared compared_of(const course *w, arena *memory)
{
    const mechanism *m = w->m;
    const size_t count = (size_t)m->effects.memory_count, nodes = w->nexts.g.count + 1;
    compared c = {.acts = arena_take(memory, w->states * count + 1, sizeof *c.acts)};
    c.largest = arena_take(memory, nodes, sizeof *c.largest);
    c.since = arena_take(memory, nodes, sizeof *c.since);
    c.near = arena_take(memory, nodes, sizeof *c.near);
    c.longest = arena_take(memory, nodes, sizeof *c.longest);
    for (int i = 0; i < m->effects.memory_count; i++) {
        bool *states = arena_take(memory, w->states + 1, sizeof *states);
        mark_compared(w, i, states);
        for (int s = 0; s < (int)w->states; s++) {
            bool *read = arena_take(memory, (size_t)held_count(m) + 1, sizeof *read);
            if (states[s]) {
                mark_leaves(&w->plant.g, &w->plant.roots[s], 1, OP_INPUT, read);
            }
            *flag_of(&c, w, s, i) = states[s] && read[m->inputs.count + i];
        }
    }
    return c;
}

/* Whether a comparison in the formula of a memory is another one than in the row before, and with it the memory. */
static bool has_changed(const course *w, int memory)
{
    const functions *f = &w->nexts;
    const int at = w->m->inputs.count + memory;
    bool any = false;
    if (w->u[at] == w->u_before[at] || w->m->effects.memories[memory].kept != KEPT_NEXT) {
        return false;
    }
    for (reached r = reach(&f->g, &f->roots[memory], 1); reach_next(&r);) {
        any = any || (f->switches[r.at] && f->now[r.at] != f->before[r.at]);
    }
    return any;
}

bool compared_has(const compared *c, const course *w, int number)
{
    bool any = false;
    for (int i = 0; i < w->m->effects.memory_count; i++) {
        any = any || (*flag_of(c, w, number, i) && has_changed(w, i));
    }
    return any;
}

bool compared_put_back(const compared *c, const course *w, double *u)
{
    bool any = false;
    for (int i = 0; i < w->m->effects.memory_count; i++) {
        bool acts = false;
        for (int s = 0; s < (int)w->states; s++) {
            acts = acts || *flag_of(c, w, s, i);
        }
        if (acts && has_changed(w, i)) {
            u[w->m->inputs.count + i] = w->u_before[w->m->inputs.count + i];
            any = true;
        }
    }
    return any;
}

void compared_watch(compared *c, const course *w)
{
    const functions *f = &w->nexts;
    for (size_t i = 0; i < f->g.count; i++) {
        const graph_node *n = &f->g.nodes[i];
        if (!f->switches[i]) {
            continue;
        }
        const double apart = fabs(f->now[n->a] - (operators[n->op].operands == 2 ? f->now[n->b] : 0.0));
        const bool is_near = apart < near_each_other * c->largest[i] && f->now[i] == f->before[i];
        c->largest[i] = fmax(c->largest[i], apart);
        c->near[i] = is_near ? c->near[i] + 1 : 0;
        if (c->near[i] > c->longest[i]) {
            c->longest[i] = c->near[i];
            c->since[i] = (double)(w->tick + 1 - (uint64_t)c->near[i]) * w->m->method.step;
        }
    }
}

void compared_warn(const compared *c, const source *s, const course *w)
{
    const mechanism *m = w->m;
    const functions *f = &w->nexts;
    for (int i = 0; i < m->effects.memory_count; i++) {
        bool acts = false;
        double since = -1.0;
        for (int number = 0; number < (int)w->states; number++) {
            acts = acts || *flag_of(c, w, number, i);
        }
        for (reached r = reach(&f->g, &f->roots[i], 1); reach_next(&r);) {
            since = f->switches[r.at] && c->longest[r.at] >= STEPS_TOGETHER ? c->since[r.at] : since;
        }
        if (acts && since >= 0.0) {
            source_warn(s, m->effects.memories[i].at,
                        "the sides of a comparison in the next of '%s' come together, to 1e-6 of their largest "
                        "difference at %.4g s, and do not pass each other: what decays to a value does not reach it; "
                        "compare with one before it, or let a `when` set a mode where it would pass",
                        m->effects.memories[i].about.name, since);
        }
    }
}
