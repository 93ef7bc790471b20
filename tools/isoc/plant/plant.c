#include "tools/isoc/plant/plant.h"

#include "tools/isoc/plant/cost.h"
#include "tools/isoc/plant/outputs.h"

/* The derivative of the states, and what an implicit method solves with. */
static void build_derivatives(plant *p, graph *g, formulation chosen)
{
    const mechanism *m = p->m;
    p->derivatives = arena_take(g->memory, (size_t)state_count(m), sizeof *p->derivatives);
    p->d = dynamics_build(g, m, chosen);
    graph_section(g, "Rates of the positions");
    for (int i = 0; i < m->link_count; i++) {
        position_rates(&p->d->k, i, p->derivatives + m->links[i].position);
    }
    for (int i = 0; i < m->clocks.count; i++) {
        p->derivatives[m->clocks.first + i] = constant(g, m->clocks.all[i].rate);
    }
    for (int f = 0; f < m->dof_count; f++) {
        p->derivatives[m->position_count + f] = p->d->acceleration[f];
    }
    if (ISO_IS(m->recipe, ISO_SEMI_IMPLICIT) && m->position_count != m->dof_count) {
        p->rate_count = m->position_count;
    }
    if (ISO_IS_IMPLICIT(m->recipe)) {
        p->j = jacobian_build(g, p->d, p->derivatives);
    }
}

/* Builds every formulation that fits, each in a copy of the graph, and keeps the one that is wanted, or else the
 * cheapest one. */
static void build_cheapest(plant *p, graph *g, formulation wanted)
{
    const graph before = *g;
    const plant bare = *p;
    choice made = {.kept = FORMULATIONS};
    graph kept = before;
    int least = 0;
    for (formulation f = 0; f < FORMULATIONS; f++) {
        if (!formulation_fits(p->m, f)) {
            continue;
        }
        plant tried = bare;
        *g = graph_copy(&before);
        build_derivatives(&tried, g, f);
        made.of[f] = count_operations(g, tried.derivatives, (size_t)state_count(p->m));
        const int cost = cycles_of(cost_of_step(&tried, g));
        if (f == wanted || (wanted == FORMULATIONS && (made.kept == FORMULATIONS || cost < least))) {
            *p = tried;
            made.kept = f;
            kept = *g;
            least = cost;
        }
    }
    *g = kept;
    p->formulations = made;
}

plant plant_build(graph *g, const mechanism *m, bool is_double, formulation wanted)
{
    plant p = {.m = m, .input_count = m->input_count, .is_double = is_double};
    for (int i = 0; i < m->link_count; i++) {
        p.turn_count += m->links[i].continuous;
    }
    build_cheapest(&p, g, wanted);
    p.after = settled_build(g, p.d);
    outputs_build(&p, g);
    p.violation = m->violation_limit > 0.0 && p.d->loops.held.count > 0
                      ? largest_violation(&p.d->k, &p.d->loops.held, false)
                      : -1;
    return p;
}
