#include "tools/isoc/stability/stability.h"

#include <math.h>
#include <string.h>

/* A quaternion has no slopes by its own rotations: the rate is q omega / 2; a rotation phi turns it into
 * (phi q) omega / 2, which does not change phi. */
slopes slopes_at(const linearised *l, const double *x, const double *u)
{
    const mechanism *m = l->m;
    const graph *g = &l->g;
    const int states = state_count(m), inputs = held_count(m);
    const turnings turned = turnings_at(m, g->memory, x);
    slopes result = {.n = turned.reduced, .positions = turned.reduced - m->dof_count, .infinite = -1};
    double *numbers = arena_take(g->memory, g->count, sizeof *numbers);
    double *arguments = arena_take(g->memory, (size_t)(inputs + states) + 1, sizeof *arguments);
    result.at = arena_take(g->memory, (size_t)(result.n * result.n) + 1, sizeof *result.at);
    result.is_fast = arena_take(g->memory, (size_t)result.n + 1, sizeof *result.is_fast);
    result.substeps = m->effects.fast_substeps;
    FOR_EACH (const turning, t, turned) {
        result.is_fast[t->reduced] = is_fast_state(m, t->state);
        result.fast_count += is_fast_state(m, t->state);
    }
    const evaluation at = {.x = x, .u = arguments, .p = m->parameters.at_start};
    memcpy(arguments, u, (size_t)inputs * sizeof *u);
    for (int column = 0; column < result.n; column++) {
        const turning *by = NULL;
        memset(arguments + inputs, 0, (size_t)states * sizeof *arguments);
        FOR_EACH (const turning, t, turned) {
            arguments[inputs + t->state] += t->reduced == column ? t->factor : 0.0;
            by = t->reduced == column ? t : by;
        }
        graph_evaluate(g, 0, &at, numbers);
        FOR_EACH (const turning, t, turned) {
            const double change = numbers[l->changes[t->state]];
            const bool is_own = t->quaternion != NULL && t->quaternion == by->quaternion;
            result.at[t->reduced * result.n + column] += is_own ? 0.0 : change * t->back;
            result.infinite = isfinite(change) || result.infinite >= 0 ? result.infinite : by->state;
        }
    }
    arena_return(g->memory, numbers, g->count, sizeof *numbers);
    return result;
}
