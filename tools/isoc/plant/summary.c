#include "tools/isoc/plant/plant.h"

static void count_line(text *out, const char *what, operations n)
{
    text_add(out, "%s add %d mul %d div %d sincos %d\n", what, n.add, n.mul, n.div, n.sincos);
}

static void formulation_lines(const plant *p, text *out)
{
    for (formulation f = 0; f < FORMULATIONS; f++) {
        if (p->formulations.tried[f]) {
            const char *verdict = f == p->formulations.kept ? "kept" : "left";
            count_line(out, arena_format(out->memory, "formulation %s %s", formulation_names[f], verdict),
                       p->formulations.costs[f]);
        }
    }
}

/* The assembled starts of coordinates without one in the scene, and those that could move on in two ways from there. */
static void assembled_lines(const mechanism *m, text *out)
{
    const char *meeting = "";
    FOR_ALL (const segment, l, m->segments, m->segment_count) {
        const char *word = slides(l) ? "m" : "rad";
        if (l->kind == JOINT_SPHERICAL && l->origin.start_found) {
            const double *q = l->start;
            text_add(out, "assembled %s quaternion %.9g %.9g %.9g %.9g\n", l->name, q[0], q[1], q[2], q[3]);
        } else if (l->origin.start_found) {
            text_add(out, "assembled %s %.9g %s\n", l->name, l->start[0], word);
        }
        if (l->kind == JOINT_SPHERICAL && l->origin.speed_found) {
            const double *w = l->speed;
            text_add(out, "assembled %s_spin %.9g %.9g %.9g rad/s\n", l->name, w[0], w[1], w[2]);
        } else if (l->origin.speed_found) {
            text_add(out, "assembled %s_speed %.9g %s/s\n", l->name, l->speed[0], word);
        }
        meeting = l->origin.start_meets ? arena_format(out->memory, "%s %s", meeting, l->name) : meeting;
    }
    text_add(out, meeting[0] == '\0' ? "%s" : "dead_position%s\n", meeting);
}

/* Values of effects that follow from the step, the method and the inertia at the start. */
static void derived_lines(const mechanism *m, const graph *g, text *out)
{
    if (m->effects.derived.count == 0) {
        return;
    }
    const double *numbers = numbers_at_start(g, m);
    FOR_EACH (const effect_quantity, e, m->effects.derived) {
        text_add(out, "stable %s %.9g %s\n", e->about.name, numbers[e->next], e->about.unit);
    }
}

/* What is computed at each rate behind the step, and the row with the most of it. */
static void slow_lines(const plant *p, const graph *g, text *out)
{
    const rate_costs all = rate_costs_of(p, g, out->memory);
    const dearest_row dearest = dearest_row_of(&all);
    FOR_EACH (const rate_cost, c, all) {
        count_line(out, arena_format(out->memory, "rows_%s", rate_words(out->memory, c->rate)), c->in_a_row);
    }
    count_line(out, arena_format(out->memory, "dearest_row %.0f", dearest.row), dearest.in_it);
}

/* The outputs of each rate; an output that reads an acceleration evaluates the derivative. */
static void rate_lines(const plant *p, const graph *g, text *out)
{
    const output_rates rates = output_rates_of(p, out->memory);
    FOR_EACH (const output_rate, o, rates) {
        const size_t count = (size_t)o->count;
        const operations derivative = count_operations(g, p->derivatives, (size_t)state_count(p->m));
        count_line(out, arena_format(out->memory, "outputs_%s", rate_words(out->memory, o->rate)),
                   operations_plus(count_operations(g, o->roots, count),
                                   uses_operation(g, o->roots, count, OP_DERIVATIVE), derivative));
    }
}

/* A step, and those of the rungs of a ladder. */
static void step_lines(const plant *p, const graph *g, text *out)
{
    const mechanism *m = p->m;
    const operations settle = cost_of_settling(p, g);
    const int settles = m->drift.projections > 1 ? m->drift.projections : 1;
    const operations part = operations_plus(cost_of_step(p, g), settles, settle);
    const operations shares = cost_of_shares(p, g), all = operations_plus(shares, 1, part);
    count_line(out, "step", operations_plus(all, m->method.parts - 1, part));
    for (int i = 0; i < m->policies.rung_count; i++) {
        if (m->policies.rungs[i] == ISO_METHODS || m->policies.dropped[i] > p->reduced_plant_count) {
            continue;
        }
        const reduced_plant *left = reduced_plant_on_rung(p, i);
        mechanism by = *m;
        plant with = left == NULL ? *p : *left->p;
        by.method.recipe = rung_recipe(p, i);
        with.m = &by;
        const graph *reduced = left == NULL ? g : left->g;
        const operations rung = operations_plus(cost_of_step(&with, reduced), settles, settle);
        count_line(
            out, arena_format(out->memory, "step%s", rung_suffix(p, i, out->memory)),
            operations_plus(operations_plus(cost_of_shares(&with, reduced), 1, rung), m->method.parts - 1, rung));
    }
}

void write_summary(const plant *p, const graph *g, text *out)
{
    const mechanism *m = p->m;
    const int n = state_count(m), real_bytes = p->is_double ? 8 : 4;
    text_add(out, "scene %s\nmethod %s\nstep %g s\nreal %s\n", m->name, method_names[ISO_METHOD_OF(m->method.recipe)],
             m->method.step, p->is_double ? "double" : "float");
    text_add(out, "states %d\ninputs %d\nparameters %d\noutputs %d\n", n, m->inputs.count, m->parameters.count,
             p->outputs.count);
    if (m->effects.memory_count > 0) {
        text_add(out, "memories %d\n", m->effects.memory_count);
    }
    assembled_lines(m, out);
    derived_lines(m, g, out);
    formulation_lines(p, out);
    count_line(out, "derivative", count_operations(g, p->derivatives, (size_t)n));
    if (ISO_IS_IMPLICIT(m->method.recipe)) {
        const implicit_cost cost = cost_of_solving(p, g);
        count_line(out, "factor", cost.factor);
        count_line(out, "solve", cost.solve);
        text_add(out, "factors %d %s\n", p->j.factor_count, factoring_names[p->j.kind]);
    }
    if (has_events(m)) {
        text_add(out, "events %d slots %d rest %s\n", m->events.count, m->events.slots,
                 method_names[ISO_METHOD_OF(m->events.rest)]);
        if (m->events.hold_count > 0) {
            text_add(out, "holds %d\n", m->events.hold_count);
        }
        count_line(out, "events_in_step", cost_of_events(p, g));
    }
    if (!ISO_IS_VARYING(m->method.recipe)) { /* whose sub-steps are as many as it needs */
        step_lines(p, g, out);
    }
    if (has_slow_outputs(m)) {
        rate_lines(p, g, out);
    }
    if (has_slow_memories(m)) {
        slow_lines(p, g, out);
    }
    text_add(out, "state_bytes %d\nkept_bytes %d\n", n * real_bytes,
             ISO_VECTORS_KEPT(m->method.recipe) * n * real_bytes);
}

void write_methods(text *out)
{
    text_add(out, "| method | order | evaluations | Jacobians | solutions | vectors kept | with a check |\n");
    text_add(out, "|---|---|---|---|---|---|---|\n");
    for (unsigned method = 0; method < ISO_METHODS; method++) {
        const bool varies = ISO_IS_VARYING(method);
        text_add(out, "| %s | %s%d | %d%s | %d | %d | %d | %d |\n", method_names[method], varies ? "1 to " : "",
                 ISO_ORDER_OF(method), ISO_EVALUATIONS_OF(method), varies ? " a sub-step" : "", ISO_IS_IMPLICIT(method),
                 ISO_SOLUTIONS_OF(method), ISO_VECTORS_KEPT(method), ISO_VECTORS_KEPT(method | ISO_CHECKED));
    }
}
