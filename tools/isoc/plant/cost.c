#include <string.h>

#include "tools/isoc/plant/plant.h"

/* The cost of smooth inputs: their differences in a tick, and polynomials in Horner's form at the places where the
 * method evaluates; at the end of a step all weights are one. */
static operations smooth_operations(const mechanism *m)
{
    const int degree = ISO_DEGREE(m->method.recipe);
    operations one = {.add = degree, .mul = 1};
    const iso_tableau *table = iso_tableau_of(m->method.recipe);
    if (ISO_IS(m->method.recipe, ISO_ROSENBROCK)) {
        one = operations_plus(one, 1, (operations){.add = 2 * degree, .mul = degree + 1});
    } else if (table == NULL) {
        one.add += degree;
    } else {
        for (uint8_t i = 1; i < table->stages; i++) {
            const bool is_new = i == 1 || iso_stage_at(table, i) != iso_stage_at(table, (uint8_t)(i - 1));
            one.add += is_new ? degree : 0;
            one.mul += is_new && iso_stage_at(table, i) != 1.0 ? degree : 0;
        }
    }
    operations all = {0};
    for (int i = 0; i < m->inputs.sampled_count && degree > 0; i++) {
        all = operations_plus(all, m->inputs.smooth[i], one);
    }
    return all;
}

/* x += dx, plain or compensated. */
static int sums_of_addition(unsigned recipe)
{
    return ISO_IS_COMPENSATED(recipe) ? 7 : 1;
}

/* A step of n states with its options, by the row of its method. */
static operations step_operations(unsigned recipe, int n, operations derivative, implicit_cost cost)
{
    const operations one_sum = {.add = 1}, combination = {ISO_SUMS_OF(recipe), ISO_PRODUCTS_OF(recipe), 0, 0};
    operations total = operations_plus((operations){0}, n, combination);
    total = operations_plus(total, ISO_EVALUATIONS_OF(recipe) - ISO_IS_IMPLICIT(recipe), derivative);
    total = operations_plus(operations_plus(total, ISO_IS_IMPLICIT(recipe), cost.factor), ISO_SOLUTIONS_OF(recipe),
                            cost.solve);
    if (ISO_CHECKS_DERIVATIVES(recipe)) {
        /* The sums of an Adams formula of so many derivatives and one, and the increment less them. */
        const int kept = ISO_CHECK_KEPT(recipe);
        const operations centred = {.add = 6, .mul = 5};
        total = operations_plus(total, n,
                                ISO_IS_CENTRED(recipe) ? centred : (operations){.add = kept + 1, .mul = kept + 1});
    } else if (ISO_IS_CHECKED(recipe)) {
        total.mul++; /* the error by the difference to the predictor */
    }
    return operations_plus(total, sums_of_addition(recipe) * n, one_sum);
}

operations cost_of_settling(const plant *p, const graph *g)
{
    const operations changes = count_operations(g, p->after.values, (size_t)p->after.count);
    const operations additions = {.add = sums_of_addition(p->m->method.recipe)}, watch = {.add = 2, .mul = 2};
    const operations total = operations_plus(changes, p->after.adds ? p->after.count : 0, additions);
    const operations energy = count_operations(g, &p->energy, 1);
    return operations_plus(operations_plus(total, p->after.pivot_count, watch), p->m->drift.near_holds ? 2 : 0, energy);
}

/* Of the factors and the derivative, unrolled. */
static operations count_linear(const plant *p, const graph *g)
{
    const size_t factors = (size_t)p->j.factor_count, states = (size_t)state_count(p->m);
    node *roots = arena_take(g->memory, factors + states, sizeof *roots);
    memcpy(roots, p->j.factors, factors * sizeof *roots);
    memcpy(roots + factors, p->held_derivatives != NULL ? p->held_derivatives : p->derivatives, states * sizeof *roots);
    return count_operations(g, roots, p->j.looped != NULL ? factors : factors + states);
}

implicit_cost cost_of_solving(const plant *p, const graph *g)
{
    implicit_cost cost = {{0}, {0}};
    if (ISO_IS_IMPLICIT(p->m->method.recipe)) {
        cost.factor = count_linear(p, g);
        if (p->j.looped != NULL) {
            const elimination *e = &p->j.looped->e;
            cost.factor =
                operations_plus(cost.factor, 1, count_operations(g, p->derivatives, (size_t)state_count(p->m)));
            cost.factor = operations_plus(cost.factor, e->products, (operations){.add = 1, .mul = 1});
            cost.factor = operations_plus(cost.factor, e->count, (operations){.div = 1});
            cost.factor = operations_plus(cost.factor, e->lower, (operations){.mul = 1});
            cost.solve = (operations){.add = e->nonzeros - e->count, .mul = e->nonzeros};
        } else {
            cost.solve = count_operations(g, p->j.solution, (size_t)state_count(p->m));
        }
    }
    return cost;
}

/* How often the fast states go through a whole step for the stages of the slow ones (core/methods/multirate.h), and how
 * many places between its ends these have. */
static double passes_of(const iso_tableau *table, int *places)
{
    double passes = table->stages == 1, from = 0.0, to = 0.0;
    *places = 0;
    for (uint8_t i = 1; i < table->stages; i++) {
        const double at = i + 1 == table->stages ? 1.0 : iso_stage_at(table, i);
        from = at == to ? from : to;
        *places += i == 1 || at != to;
        to = at;
        passes += to - from;
    }
    return passes;
}

/* The cost of states with sub-steps of their own: in each of these the derivatives, the sums of the method and of the
 * mean, and the way of the states that they read. */
static operations fast_operations(const plant *p, const graph *g)
{
    const unsigned recipe = p->m->method.recipe;
    const int stages = ISO_EVALUATIONS_OF(recipe), count = p->fast.count;
    const operations derivative = count_operations(g, p->fast.derivatives, (size_t)count);
    operations one = operations_plus((operations){0}, stages, derivative);
    if (count == 0) {
        return one;
    }
    int places;
    const int passes = (int)(p->m->effects.fast_substeps * passes_of(iso_tableau_of(recipe), &places) + 0.5);
    one = operations_plus(
        one, count, (operations){.add = ISO_SUMS_OF(recipe) + stages + 1, .mul = ISO_PRODUCTS_OF(recipe) + stages / 2});
    one = operations_plus(one, places, (operations){.mul = 1});
    one = operations_plus(one, places * p->fast.read_count, (operations){.add = 2, .mul = 2});
    return operations_plus((operations){0}, passes, one);
}

/* In the later stages each sine and cosine follows from that of the start, by the operations of iso_sincos_beyond; of
 * an angle that may turn far, in one stage from the angle. */
static operations less_for_sines(const plant *p, operations step)
{
    const operations beyond = {.add = p->is_double ? 10 : 8, .mul = p->is_double ? 13 : 11, .sincos = -1};
    const int stages = ISO_EVALUATIONS_OF(p->m->method.recipe) - 1;
    return operations_plus(step, stages * p->angles.count - p->angles.spin_count, beyond);
}

operations cost_of_step(const plant *p, const graph *g)
{
    const int n = state_count(p->m);
    const node *derivatives = p->held_derivatives != NULL ? p->held_derivatives : p->derivatives;
    const operations derivative = count_operations(g, derivatives, (size_t)n);
    const operations rates = count_operations(g, derivatives, (size_t)p->rate_count);
    const int further = p->held.count - p->held.tuned; /* than tunables */
    const operations once =
        further > 0 ? count_operations(g, p->held.values + p->held.tuned, (size_t)further) : (operations){0};
    const operations step = step_operations(p->m->method.recipe, n, derivative, cost_of_solving(p, g));
    const operations by_sines = operations_plus(less_for_sines(p, step), 1, cost_of_events(p, g));
    const operations all = operations_plus(operations_plus(by_sines, 1, fast_operations(p, g)), 1, rates);
    return operations_plus(operations_plus(operations_plus(all, 1, once), 1, smooth_operations(p->m)), p->is_curved,
                           derivative);
}
