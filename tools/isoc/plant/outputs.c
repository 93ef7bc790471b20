#include "tools/isoc/plant/plant.h"

#include <string.h>

/* Whether one rate comes before another: the faster one, and of equal ones that of the lesser phase. */
static bool is_before(row_rate a, row_rate b)
{
    return a.every < b.every || (!(b.every < a.every) && a.phase < b.phase);
}

/* The first rate behind another; one of no rows where there is none. */
static row_rate next_rate(const plant *p, row_rate behind)
{
    row_rate first = {0.0, 0.0};
    for (int i = 0; i < p->outputs.count; i++) {
        const row_rate rate = p->outputs.shows[i]->rate;
        first = is_before(behind, rate) && (first.every < 1.0 || is_before(rate, first)) ? rate : first;
    }
    return first;
}

output_rates output_rates_of(const plant *p, arena *memory)
{
    const size_t room = (size_t)p->outputs.count + 1;
    output_rates result = {.all = arena_take(memory, room, sizeof *result.all)};
    for (row_rate rate = next_rate(p, (row_rate){0.0, 0.0}); rate.every >= 1.0; rate = next_rate(p, rate)) {
        output_rate *to = &result.all[result.count++];
        *to = (output_rate){.rate = rate,
                            .which = arena_take(memory, room, sizeof *to->which),
                            .roots = arena_take(memory, room, sizeof *to->roots)};
        for (int i = 0; i < p->outputs.count; i++) {
            if (is_same_rate(p->outputs.shows[i]->rate, rate)) {
                to->which[to->count] = i;
                to->roots[to->count++] = p->outputs.roots[i];
            }
        }
    }
    return result;
}

bool has_slow_outputs(const mechanism *m)
{
    bool any = false;
    for (size_t i = 0; i < m->output_count; i++) {
        any = any || is_slow(m->outputs[i].rate);
    }
    return any;
}

static void show(plant *p, const shown *o, const char *label, node n)
{
    p->outputs.names[p->outputs.count] = label;
    p->outputs.units[p->outputs.count] = shows_formula(o) ? o->unit : query_unit(p->m, &o->content);
    p->outputs.shows[p->outputs.count] = o;
    p->outputs.roots[p->outputs.count++] = n;
}

/* A number, or a vector, whole or along one axis. */
static void show_parts(plant *p, graph *g, const shown *o, const char *components, const node *parts)
{
    if (components[0] == '\0' || o->along >= 0) {
        show(p, o, o->name.text, parts[o->along < 0 ? 0 : o->along]);
        return;
    }
    for (int i = 0; components[i] != '\0'; i++) {
        show(p, o, arena_format(g->memory, "%s_%c", o->name.text, components[i]), parts[i]);
    }
}

void outputs_build(plant *p, graph *g)
{
    const mechanism *m = p->m;
    const size_t room = QUERY_PARTS * m->output_count + 1;
    p->outputs.names = arena_take(g->memory, room, sizeof *p->outputs.names);
    p->outputs.units = arena_take(g->memory, room, sizeof *p->outputs.units);
    p->outputs.shows = arena_take(g->memory, room, sizeof *p->outputs.shows);
    p->outputs.roots = arena_take(g->memory, room, sizeof *p->outputs.roots);
    kinematics_velocities(&p->d->k);
    p->energy = p->energy < 0 ? account_energy(p->d) : p->energy;
    graph_section(g, "Points in the ground's frame");
    FOR_ALL (const shown, o, m->outputs, m->output_count) {
        if (shows_formula(o)) {
            show_parts(p, g, o, formula_components(&o->formula), o->formula.parts);
        } else {
            node parts[QUERY_PARTS];
            quantity_nodes(p, g, &o->content, parts);
            show_parts(p, g, o, quantity_rows[o->content.kind].components, parts);
        }
    }
}

void list_roots(graph *g, const plant *p, const node *derivatives, int outputs, node *roots)
{
    const size_t states = (size_t)state_count(p->m), count = (size_t)outputs;
    memcpy(roots, derivatives, states * sizeof *roots);
    if (count > 0) {
        memcpy(roots + states, p->outputs.roots, count * sizeof *roots);
        replace_leaves(g, roots + states, count, OP_DERIVATIVE, derivatives);
    }
}
