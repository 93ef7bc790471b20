#include "tools/isoc/plant/cost.h"

#include "tools/isoc/plant/rates.h"
#include "tools/isoc/plant/reduced_plant.h"

/* a + times * b */
static operations plus(operations a, int times, operations b)
{
    return (operations){a.add + times * b.add, a.mul + times * b.mul, a.div + times * b.div,
                        a.sincos + times * b.sincos};
}

/* The cost of solving with 1 - hb J. */
typedef struct implicit_cost {
    operations factor, solve;
} implicit_cost;

/* What smooth inputs add: their differences in a tick, and polynomials in Horner's form at the places where the method
 * evaluates; at the end of a step all weights are one. */
static operations smooth_operations(const mechanism *m)
{
    const int degree = ISO_DEGREE(m->recipe);
    operations one = {.add = degree, .mul = 1};
    if (ISO_IS(m->recipe, ISO_ROSENBROCK)) {
        one = plus(one, 1, (operations){.add = 2 * degree, .mul = degree + 1});
    } else {
        one = plus(one, ISO_IS(m->recipe, ISO_RK4) ? 2 : 1, (operations){.add = degree});
        one.mul += ISO_IS(m->recipe, ISO_RK4) ? degree : 0;
    }
    operations all = {0};
    for (int i = 0; i < m->sampled_count && degree > 0; i++) {
        all = plus(all, m->smooth[i], one);
    }
    return all;
}

/* x += dx, or with what rounding took away. */
static int sums_of_addition(unsigned recipe)
{
    return ISO_IS_COMPENSATED(recipe) ? 7 : 1;
}

/* A step of n states with its options, by the row of its method. */
static operations step_operations(unsigned recipe, int n, operations derivative, implicit_cost cost)
{
    const operations one_sum = {.add = 1}, combination = {ISO_SUMS_OF(recipe), ISO_PRODUCTS_OF(recipe), 0, 0};
    operations total = plus((operations){0}, n, combination);
    total = plus(total, ISO_EVALUATIONS_OF(recipe), derivative);
    total = plus(plus(total, ISO_JACOBIANS_OF(recipe), cost.factor), ISO_SOLUTIONS_OF(recipe), cost.solve);
    if (ISO_CHECKS_DERIVATIVES(recipe)) {
        /* The sums of an Adams formula of so many derivatives and one, and the increment less them. */
        const int kept = ISO_CHECK_KEPT(recipe);
        const operations centred = {.add = 6, .mul = 5};
        total = plus(total, n, ISO_IS_CENTRED(recipe) ? centred : (operations){.add = kept + 1, .mul = kept + 1});
    } else if (ISO_IS_CHECKED(recipe)) {
        total.mul++; /* the error by the difference to the predictor */
    }
    return plus(total, sums_of_addition(recipe) * n, one_sum);
}

/* What follows the method in a step. */
static operations cost_of_settling(const plant *p, const graph *g)
{
    const operations changes = count_operations(g, p->after.values, (size_t)p->after.count);
    const operations additions = {.add = sums_of_addition(p->m->recipe)}, watch = {.add = 2, .mul = 2};
    const operations total = plus(changes, p->after.adds ? p->after.count : 0, additions);
    const operations energy = count_operations(g, &p->energy, 1);
    return plus(plus(total, p->after.pivot_count, watch), p->m->near_holds ? 2 : 0, energy);
}

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
                       p->formulations.of[f]);
        }
    }
}

/* Where the closures put what the scene gives no start, and what could go on in two ways from there. */
static void assembled_lines(const mechanism *m, text *out)
{
    const char *meeting = "";
    for (int i = 0; i < m->segment_count; i++) {
        const segment *l = &m->segments[i];
        const char *word = slides(l) ? "m" : "rad";
        if (l->kind == JOINT_SPHERICAL && l->start_found) {
            const double *q = l->start;
            text_add(out, "assembled %s quaternion %.9g %.9g %.9g %.9g\n", l->name, q[0], q[1], q[2], q[3]);
        } else if (l->start_found) {
            text_add(out, "assembled %s %.9g %s\n", l->name, l->start[0], word);
        }
        if (l->kind == JOINT_SPHERICAL && l->speed_found) {
            const double *w = l->speed;
            text_add(out, "assembled %s_spin %.9g %.9g %.9g rad/s\n", l->name, w[0], w[1], w[2]);
        } else if (l->speed_found) {
            text_add(out, "assembled %s_speed %.9g %s/s\n", l->name, l->speed[0], word);
        }
        meeting = l->start_meets ? arena_format(out->memory, "%s %s", meeting, l->name) : meeting;
    }
    text_add(out, meeting[0] == '\0' ? "%s" : "dead_position%s\n", meeting);
}

/* What effects have by the step, the method and the inertia at the start. */
static void derived_lines(const mechanism *m, const graph *g, text *out)
{
    if (m->derived_count == 0) {
        return;
    }
    const evaluation at = {.p = m->defaults};
    double *numbers = arena_take(g->memory, g->count, sizeof *numbers);
    graph_evaluate(g, 0, &at, numbers);
    for (int i = 0; i < m->derived_count; i++) {
        text_add(out, "stable %s %.9g %s\n", m->derived[i].about.name, numbers[m->derived[i].next],
                 m->derived[i].about.unit);
    }
}

static implicit_cost cost_of_solving(const plant *p, const graph *g)
{
    implicit_cost cost = {{0}, {0}};
    if (ISO_IS_IMPLICIT(p->m->recipe)) {
        cost.factor = count_operations(g, p->j.factors, (size_t)p->j.factor_count);
        if (p->j.looped != NULL) {
            const elimination *e = &p->j.looped->e;
            cost.factor = plus(cost.factor, 1, count_operations(g, p->derivatives, (size_t)state_count(p->m)));
            cost.factor = plus(cost.factor, e->products, (operations){.add = 1, .mul = 1});
            cost.factor = plus(cost.factor, e->count, (operations){.div = 1});
            cost.factor = plus(cost.factor, e->lower, (operations){.mul = 1});
            cost.solve = (operations){.add = e->places - e->count, .mul = e->places};
        } else {
            cost.solve = count_operations(g, p->j.solution, (size_t)state_count(p->m));
        }
    }
    return cost;
}

/* What the states with sub-steps of their own add: these, a half more where two stages are in the middle of a step; in each
 * the derivatives, the sums of the method and of the mean, and the way of the states that they read. */
static operations fast_operations(const plant *p, const graph *g)
{
    const unsigned recipe = p->m->recipe;
    const int stages = ISO_EVALUATIONS_OF(recipe), count = p->fast.count;
    const int places = ISO_IS(recipe, ISO_RK4) ? 2 : stages - 1;
    const int passes = p->m->fast_substeps * (ISO_IS(recipe, ISO_RK4) ? 3 : 2) / 2;
    const operations derivative = count_operations(g, p->fast.derivatives, (size_t)count);
    operations one = plus((operations){0}, stages, derivative);
    if (count == 0) {
        return one;
    }
    one = plus(one, count,
               (operations){.add = ISO_SUMS_OF(recipe) + stages + 1, .mul = ISO_PRODUCTS_OF(recipe) + stages / 2});
    one = plus(one, places, (operations){.mul = 1});
    one = plus(one, places * p->fast.read_count, (operations){.add = 2, .mul = 2});
    return plus((operations){0}, passes, one);
}

operations cost_of_step(const plant *p, const graph *g)
{
    const int n = state_count(p->m);
    const node *derivatives = p->held_derivatives != NULL ? p->held_derivatives : p->derivatives;
    const operations derivative = count_operations(g, derivatives, (size_t)n);
    const operations rates = count_operations(g, derivatives, (size_t)p->rate_count);
    const operations once =
        count_operations(g, p->held.values + p->held.tuned, (size_t)(p->held.count - p->held.tuned));
    const operations step = step_operations(p->m->recipe, n, derivative, cost_of_solving(p, g));
    const operations all = plus(plus(step, 1, fast_operations(p, g)), 1, rates);
    return plus(plus(plus(all, 1, once), 1, smooth_operations(p->m)), p->is_curved, derivative);
}

/* The outputs of each rate; what shows an acceleration evaluates the derivative. */
static void rate_lines(const plant *p, const graph *g, text *out)
{
    const output_rates rates = output_rates_of(p, out->memory);
    for (int i = 0; i < rates.count; i++) {
        const output_rate *o = &rates.all[i];
        const size_t count = (size_t)o->count;
        const operations derivative = count_operations(g, p->derivatives, (size_t)state_count(p->m));
        count_line(
            out, arena_format(out->memory, "outputs_every_%.0f", o->every),
            plus(count_operations(g, o->roots, count), uses_operation(g, o->roots, count, OP_DERIVATIVE), derivative));
    }
}

void cost_summary(const plant *p, const graph *g, text *out)
{
    const mechanism *m = p->m;
    const int n = state_count(m), real_bytes = p->is_double ? 8 : 4;
    text_add(out, "scene %s\nmethod %s\nstep %g s\nreal %s\n", m->name, method_names[ISO_METHOD_OF(m->recipe)], m->step,
             p->is_double ? "double" : "float");
    text_add(out, "states %d\ninputs %d\nparameters %d\noutputs %d\n", n, m->input_count, m->parameter_count,
             p->output_count);
    if (m->memory_count > 0) {
        text_add(out, "memories %d\n", m->memory_count);
    }
    assembled_lines(m, out);
    derived_lines(m, g, out);
    formulation_lines(p, out);
    count_line(out, "derivative", count_operations(g, p->derivatives, (size_t)n));
    if (ISO_IS_IMPLICIT(m->recipe)) {
        const implicit_cost cost = cost_of_solving(p, g);
        count_line(out, "factor", cost.factor);
        count_line(out, "solve", cost.solve);
        text_add(out, "factors %d %s\n", p->j.factor_count, factoring_names[p->j.kind]);
    }
    if (!ISO_IS_VARYING(m->recipe)) { /* whose sub-steps are as many as it needs */
        const operations settle = cost_of_settling(p, g);
        const int settles = m->projections > 1 ? m->projections : 1;
        const operations part = plus(cost_of_step(p, g), settles, settle);
        count_line(out, "step", plus(part, m->parts - 1, part));
        for (int i = 0; i < m->policies.rung_count; i++) {
            if (m->policies.rungs[i] == ISO_METHODS || m->policies.dropped[i] > p->reduced_plant_count) {
                continue;
            }
            const reduced_plant *left = reduced_plant_on_rung(p, i);
            mechanism by = *m;
            plant with = left == NULL ? *p : *left->p;
            by.recipe = rung_recipe(p, i);
            with.m = &by;
            const operations rung = plus(cost_of_step(&with, left == NULL ? g : left->g), settles, settle);
            count_line(out, arena_format(out->memory, "step%s", rung_suffix(p, i, out->memory)),
                       plus(rung, m->parts - 1, rung));
        }
    }
    if (has_slow_outputs(m)) {
        rate_lines(p, g, out);
    }
    text_add(out, "state_bytes %d\nkept_bytes %d\n", n * real_bytes, ISO_VECTORS_KEPT(m->recipe) * n * real_bytes);
}

void cost_methods(text *out)
{
    text_add(out, "| method | order | evaluations | Jacobians | solutions | vectors kept | with a check |\n");
    text_add(out, "|---|---|---|---|---|---|---|\n");
    for (unsigned method = 0; method < ISO_METHODS; method++) {
        const bool varies = ISO_IS_VARYING(method);
        text_add(out, "| %s | %s%d | %d%s | %d | %d | %d | %d |\n", method_names[method], varies ? "1 to " : "",
                 ISO_ORDER_OF(method), ISO_EVALUATIONS_OF(method), varies ? " a sub-step" : "",
                 ISO_JACOBIANS_OF(method), ISO_SOLUTIONS_OF(method), ISO_VECTORS_KEPT(method),
                 ISO_VECTORS_KEPT(method | ISO_CHECKED));
    }
}
