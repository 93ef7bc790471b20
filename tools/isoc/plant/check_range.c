#include "tools/isoc/plant/plant.h"

#include <math.h>
#include <string.h>

#include "tools/isoc/base/numbers.h"

/* Marks the nodes that the functions of the plant depend on. */
static void mark_all(const graph *g, const plant *p, bool *needed)
{
    const struct {
        const node *roots;
        int count;
    } functions[] = {
        {p->derivatives, state_count(p->m)},  {p->outputs.roots, p->outputs.count},
        {p->after.equations, p->after.count}, {p->m->inputs.drives, p->m->inputs.count + p->m->clocks.count},
        {p->j.factors, p->j.factor_count},    {p->j.solution, p->j.solution != NULL ? state_count(p->m) : 0},
        {&p->violation, p->violation >= 0},   {&p->broken, p->broken >= 0},
    };
    for (size_t f = 0; f < COUNT_OF(functions); f++) {
        for (reached r = reach(g, functions[f].roots, (size_t)functions[f].count); reach_next(&r);) {
            needed[r.at] = true;
        }
    }
}

/* The first quantity with a name that this constant is part of; NULL if there is none. */
static const char *named_quantity(const graph *g, size_t i, const bool *needed)
{
    bool *depends = arena_take(g->memory, g->count, sizeof *depends);
    depends[i] = true;
    for (size_t n = i + 1; n < g->count; n++) {
        const graph_node *result = &g->nodes[n];
        const int operands = operators[result->op].operands;
        depends[n] = (operands > 0 && depends[result->a]) || (operands == 2 && depends[result->b]);
        if (depends[n] && needed[n] && result->name != NULL) {
            return result->name;
        }
    }
    return NULL;
}

/* The place of the joint or closure whose name ends the name of the quantity; of the first joint if there is none. */
static place place_of(const mechanism *m, const char *shown_as)
{
    const size_t length = strlen(shown_as);
    place at = m->segments[0].at;
    size_t longest = 0;
    for (int i = 0; i < m->dof_count + m->closure_count; i++) {
        const closure *c = i < m->dof_count ? NULL : &m->closures[i - m->dof_count];
        const char *ending = c == NULL ? m->dofs[i].name : c->name;
        const size_t part = strlen(ending);
        if (part > longest && part < length && strcmp(shown_as + length - part, ending) == 0) {
            longest = part;
            at = c == NULL ? m->segments[m->dofs[i].segment].at : c->at;
        }
    }
    return at;
}

/* A default of an effect that follows from an inertia has no number where nothing can move. Returns whether there is
 * one, after noting it. */
static bool check_derived(source *s, const plant *p, const double *numbers)
{
    FOR_EACH (const effect_quantity, e, p->m->effects.derived) {
        if (!isfinite(numbers[e->next])) {
            source_problem(s, e->at, "nothing moves there at the start, so '%s' has no default: give it a value",
                           e->about.name);
            return true;
        }
    }
    return false;
}

/* Whether a constant below the least normal float does no harm. As a factor it is scaled (tools/isoc/emit/code.c). In a
 * sum the nearest float is off by 2^-150 at most, half the last place of the least normal float: that is a rounding
 * like any other unless the sum itself is as small. A divisor has no such scale. `numbers` are the values at the start.
 */
static bool is_harmless(const graph *g, const plant *p, const bool *needed, const double *numbers, size_t i)
{
    if (!real_is_tiny(constant_value(g, (node)i), p->is_double)) {
        return false;
    }
    for (size_t n = i + 1; n < g->count; n++) {
        const graph_node *result = &g->nodes[n];
        const int operands = operators[result->op].operands;
        const bool is_first = operands > 0 && result->a == (node)i, is_second = operands == 2 && result->b == (node)i;
        const bool is_sum = result->op == OP_ADD || result->op == OP_SUB;
        if (needed[n] && ((is_second && result->op == OP_DIV) ||
                          ((is_first || is_second) && is_sum && real_is_tiny(numbers[n], false)))) {
            return false;
        }
    }
    return true;
}

void range_check(source *s, const graph *g, const plant *p)
{
    bool *needed = arena_take(g->memory, g->count, sizeof *needed);
    const double *numbers = numbers_at_start(g, p->m);
    if (check_derived(s, p, numbers)) {
        return;
    }
    mark_all(g, p, needed);
    for (size_t i = 0; i < g->count; i++) {
        if (!needed[i] || !is_constant(g, (node)i) || real_holds(constant_value(g, (node)i), p->is_double) ||
            is_harmless(g, p, needed, numbers, i)) {
            continue;
        }
        const char *found = named_quantity(g, i, needed), *shown_as = found == NULL ? "an output" : found;
        if (isfinite(constant_value(g, (node)i))) {
            source_problem(s, place_of(p->m, shown_as), "the equations contain %g, as a part of %s; %s",
                           constant_value(g, (node)i), shown_as, real_advice(constant_value(g, (node)i), p->is_double));
        } else {
            source_problem(s, place_of(p->m, shown_as), "the equations divide by zero, in a part of %s: %s", shown_as,
                           "a formula has a divisor that is zero in every position");
        }
        return;
    }
}
