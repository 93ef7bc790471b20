#include "tools/isoc/plant/plant.h"

#include <string.h>

const dynamics *derivatives_build(graph *g, const mechanism *m, formulation chosen, node *derivatives)
{
    const dynamics *d = dynamics_build(g, m, chosen);
    graph_section(g, "Rates of the positions");
    for (int i = 0; i < m->segment_count; i++) {
        position_rates(&d->k, i, derivatives + m->segments[i].position);
    }
    for (int i = 0; i < m->clocks.count; i++) {
        derivatives[m->clocks.first + i] = constant(g, m->clocks.all[i].rate);
    }
    for (int i = 0; i < m->effects.state_count; i++) {
        derivatives[m->effects.first_state + i] = m->effects.states[i].next;
    }
    for (int f = 0; f < m->dof_count; f++) {
        derivatives[m->position_count + f] = d->acceleration[f];
    }
    return d;
}

/* The derivative of the states, and the matrix of an implicit method. */
static void build_derivatives(plant *p, graph *g, formulation chosen)
{
    const mechanism *m = p->m;
    p->derivatives = arena_take(g->memory, (size_t)state_count(m), sizeof *p->derivatives);
    p->d = derivatives_build(g, m, chosen, p->derivatives);
    if (ISO_IS(m->method.recipe, ISO_SEMI_IMPLICIT) && m->position_count != m->dof_count) {
        p->rate_count = m->position_count;
    }
    if (ISO_IS_IMPLICIT(m->method.recipe)) {
        p->j = jacobian_build(g, p->d, p->derivatives, p->factors);
    }
}

/* Composite bodies of a long chain need not be tried: the cost of their factorisation, which grows with the cube of the
 * length, is more than twice that of articulated bodies. */
static bool is_hopeless(const formulation_costs *so_far, const graph *g, const mechanism *m)
{
    enum { MULTIPLE = 2 };
    const int most = MULTIPLE * cycles_of(so_far->costs[FORMULATION_ARTICULATED]);
    return so_far->tried[FORMULATION_ARTICULATED] && composite_products(g, m, most) > most;
}

/* Whether the compiler is asked to inline all calls of a step: up to so many operations in its evaluations, where a
 * sine and cosine count as 25, and a sub-step that varies counts once. In float on a Cortex-M4F a small plant takes up
 * to 1.7 times the instructions with calls, a chain of three 1.2 times, since evaluations then share nothing. In a
 * large step calls cost nothing, and copies need much memory. */
static bool is_flat(const plant *p, const graph *g)
{
    enum { MOST_FLOAT = 600, MOST_DOUBLE = 400, OF_SINCOS = 25 };
    const mechanism *m = p->m;
    const int most = p->is_double ? MOST_DOUBLE : MOST_FLOAT;
    const operations n = count_operations(g, p->derivatives, (size_t)state_count(m));
    const int of_method = ISO_IS_VARYING(m->method.recipe) ? 1 : ISO_EVALUATIONS_OF(m->method.recipe);
    const int evaluations = of_method + evaluations_of_events(m);
    const fast_part fast = fast_build(g, m, p->derivatives);
    const operations part = count_operations(g, fast.derivatives, (size_t)fast.count);
    const int copies = evaluations > 1 ? evaluations * (evaluations - 1) : 1; /* in the sub-steps of each later stage */
    return evaluations * (n.add + n.mul + n.div + OF_SINCOS * n.sincos) +
               copies * (part.add + part.mul + part.div + OF_SINCOS * part.sincos) <=
           most;
}

/* The derivatives, and the factors of an implicit method, as functions of held values. Where all calls are inlined, the
 * compiler itself shares equal values of the evaluations, as if there were one. */
static void hold(plant *p, graph *g)
{
    const mechanism *m = p->m;
    const size_t states = (size_t)state_count(m), factors = (size_t)p->j.factor_count;
    const size_t kept = (size_t)p->after.kept_count;
    node *roots = arena_take(g->memory, states + factors + kept, sizeof *roots);
    memcpy(roots, p->derivatives, states * sizeof *roots);
    if (kept > 0) {
        memcpy(roots + states, p->after.kept, kept * sizeof *roots);
        p->after.kept = roots + states;
    }
    p->held_derivatives = roots;
    p->is_flat = is_flat(p, g);
    if ((p->is_flat && m->parameters.count == 0) || p->j.looped != NULL) {
        return;
    }
    if (factors > 0) {
        memcpy(roots + states + kept, p->j.factors, factors * sizeof *roots);
    }
    p->held = held_build(g, m, roots, states + kept + factors, p->is_flat ? 1 : ISO_EVALUATIONS_OF(m->method.recipe));
    if (p->held.count > 0 && factors > 0) {
        memcpy(p->j.factors, roots + states + kept, factors * sizeof *roots);
    }
}

/* Cycles of a step, without values that follow from tunables alone. */
static int cost_of_tried(const plant *tried, const graph *g)
{
    if (tried->m->parameters.count == 0) {
        return cycles_of(cost_of_step(tried, g));
    }
    plant p = *tried;
    graph on_trial = graph_copy(g);
    if (p.j.factor_count > 0) {
        p.j.factors = list_copy(g->memory, tried->j.factors, (size_t)p.j.factor_count, sizeof *p.j.factors);
    }
    hold(&p, &on_trial);
    const int cost = cycles_of(cost_of_step(&p, &on_trial));
    graph_free(&on_trial);
    return cost;
}

/* Builds every formulation that fits, each in a copy of the graph, and keeps the one that is wanted, or else the
 * cheapest one. */
static void build_cheapest(plant *p, graph *g, formulation wanted)
{
    static const formulation order[] = {
        FORMULATION_ARTICULATED, FORMULATION_COMPOSITE,           FORMULATION_PARENT_AXES,       FORMULATION_CHILD_AXES,
        FORMULATION_LEGS,        FORMULATION_LEGS_IN_PARENT_AXES, FORMULATION_LEGS_IN_CHILD_AXES};
    graph before = *g;
    const plant bare = *p;
    formulation_costs result = {.kept = FORMULATIONS};
    graph kept = {.memory = g->memory};
    int least = 0;
    bool has_legs = false;
    for (int i = 0; i < FORMULATIONS; i++) {
        const formulation f = order[i];
        const bool is_free = wanted == FORMULATIONS;
        if (!formulation_fits(p->m, f) || (is_free && formulation_is_by_legs(f) && !has_legs) ||
            (is_free && f == FORMULATION_COMPOSITE && is_hopeless(&result, &before, p->m))) {
            continue;
        }
        plant tried = bare;
        *g = graph_copy(&before);
        build_derivatives(&tried, g, f);
        has_legs = has_legs || (f == FORMULATION_COMPOSITE && formulation_fits(p->m, FORMULATION_LEGS) &&
                                find_shared(&tried.d->mass, &tried.d->loops.phi) != NULL);
        result.tried[f] = true;
        result.costs[f] = count_operations(g, tried.derivatives, (size_t)state_count(p->m));
        const int cost = cost_of_tried(&tried, g);
        const bool is_cheaper = result.kept == FORMULATIONS || cost < least || (cost == least && f < result.kept);
        if (f == wanted || (is_free && is_cheaper)) {
            graph_free(&kept);
            *p = tried;
            result.kept = f;
            kept = *g;
            least = cost;
        } else {
            graph_free(g);
        }
    }
    graph_free(&before);
    *g = kept;
    p->formulations = result;
}

/* Whether a second derivative by smooth inputs is not zero. */
static bool is_curved(const graph *original, const plant *p)
{
    const mechanism *m = p->m;
    const size_t states = (size_t)state_count(m);
    graph g = graph_copy(original);
    node *slopes = arena_take(g.memory, states, sizeof *slopes);
    bool curved = false;
    for (int i = 0; i < m->inputs.sampled_count; i++) {
        if (m->inputs.smooth[i]) {
            differentiate(&g, p->derivatives, states, leaf(&g, OP_INPUT, i), slopes);
            for (int j = 0; j < m->inputs.sampled_count; j++) {
                curved = curved || (m->inputs.smooth[j] && uses_leaf(&g, slopes, states, leaf(&g, OP_INPUT, j)));
            }
        }
    }
    graph_free(&g);
    return curved;
}

/* The number of conditions that the tunables break; -1 where there are no conditions. */
static node count_broken(graph *g, const mechanism *m)
{
    node count = constant(g, 0.0);
    graph_section(g, "Conditions on tunables: how many are broken");
    FOR_ALL (const condition, c, m->parameters.conditions, m->parameters.condition_count) {
        const node is_ordered = c->is_strict ? above(g, c->most, c->least) : above(g, c->least, c->most);
        count = add(g, count, c->is_strict ? sub(g, constant(g, 1.0), is_ordered) : is_ordered);
    }
    return m->parameters.condition_count > 0 ? count : -1;
}

plant plant_build(graph *g, const mechanism *m, bool is_double, build_options wanted)
{
    plant p = {.m = m, .is_double = is_double, .factors = wanted.factors, .energy = -1};
    build_cheapest(&p, g, wanted.formulation);
    p.is_curved = ISO_IS(m->method.recipe, ISO_ROSENBROCK) && ISO_IS_SMOOTH(m->method.recipe) && is_curved(g, &p);
    p.after = settled_build(g, p.d);
    shares_build(&p, g);
    event_plan_build(&p, g);
    p.rests = rests_find(g, m, &p.after);
    late_queries_resolve(&p, g);
    outputs_build(&p, g);
    p.angles = angles_build(g, m, p.derivatives);
    keep_factors(&p, g);
    hold(&p, g);
    p.fast = fast_build(g, m, p.held_derivatives);
    p.violation = m->drift.violation_limit > 0.0 && p.d->loops.phi.count > 0
                      ? largest_violation(&p.d->k, &p.d->loops.phi, false)
                      : -1;
    p.broken = count_broken(g, m);
    return p;
}
