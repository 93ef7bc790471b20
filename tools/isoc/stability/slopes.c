#include "tools/isoc/stability/stability.h"

#include <math.h>

linearised linearise(const graph *g, const mechanism *m, const node *of_roots, size_t count)
{
    const size_t states = (size_t)state_count(m);
    arena *memory = g->memory;
    node *roots = arena_take(memory, count + 1, sizeof *roots), *along = arena_take(memory, states + 1, sizeof *along);
    linearised result = {.m = m, .changes = arena_take(memory, count + 1, sizeof *result.changes)};
    result.g = economise(g, of_roots, count, roots);
    for (size_t i = 0; i < states; i++) {
        along[i] = leaf(&result.g, OP_INPUT, held_count(m) + (int)i);
    }
    differentiate_along(&result.g, roots, count, along, NULL, result.changes);
    return result;
}

/* How a state changes with one of the smaller set: the states of a quaternion with the rotations of its segment. */
typedef struct turning {
    int state, reduced;
    double factor, back; /* and this one with it */
} turning;

/* All that are not zero; returns their number. The small rotations e of a quaternion (w, x, y, z): dq = e q / 2, and
 * phi = 2 (e q)' dq. */
static int list_turnings(const mechanism *m, const double *x, turning *all)
{
    static const int from[3][4] = {{1, 0, 3, 2}, {2, 3, 0, 1}, {3, 2, 1, 0}};
    static const double sign[3][4] = {{-1, 1, -1, 1}, {-1, 1, 1, -1}, {-1, -1, 1, 1}};
    int count = 0, reduced = 0, next = 0;
    FOR_ALL (const segment, l, m->segments, m->segment_count) {
        next += positions_of(l->kind);
        if (l->kind != JOINT_SPHERICAL) {
            all[count++] = (turning){l->position, reduced++, 1.0, 1.0};
            continue;
        }
        for (int e = 0; e < 3; e++, reduced++) {
            for (int c = 0; c < 4; c++) {
                const double moved = sign[e][c] * x[l->position + from[e][c]];
                all[count++] = (turning){l->position + c, reduced, 0.5 * moved, 2.0 * moved};
            }
        }
    }
    for (int i = next; i < state_count(m); i++) {
        all[count++] = (turning){i, reduced++, 1.0, 1.0};
    }
    return count;
}

static int reduced_count(const mechanism *m)
{
    int count = state_count(m);
    for (int i = 0; i < m->segment_count; i++) {
        count -= m->segments[i].kind == JOINT_SPHERICAL;
    }
    return count;
}

/* Clears the slopes of quaternions by their own rotations: the rate is q omega / 2; a rotation phi turns it into
 * (phi q) omega / 2, which does not change phi. */
static void clear_quaternions(const mechanism *m, slopes *s)
{
    for (int i = 0, at = 0; i < m->segment_count; i++) {
        const int count = m->segments[i].kind == JOINT_SPHERICAL ? 3 : 1;
        for (int row = at; count == 3 && row < at + 3; row++) {
            for (int column = at; column < at + 3; column++) {
                s->at[row * s->n + column] = 0.0;
            }
        }
        at += count;
    }
}

static void find_fast(const mechanism *m, const turning *all, int count, arena *memory, slopes *s)
{
    s->is_fast = arena_take(memory, (size_t)s->n + 1, sizeof *s->is_fast);
    s->substeps = m->effects.fast_substeps;
    for (int i = 0; i < count; i++) {
        if (is_fast_state(m, all[i].state)) {
            s->is_fast[all[i].reduced] = true;
            s->fast_count++;
        }
    }
}

slopes slopes_at(const linearised *l, const double *x, const double *u)
{
    const mechanism *m = l->m;
    const graph *g = &l->g;
    const int states = state_count(m), inputs = held_count(m);
    slopes result = {.n = reduced_count(m), .infinite = -1};
    result.positions = result.n - m->dof_count;
    double *numbers = arena_take(g->memory, g->count, sizeof *numbers);
    double *arguments = arena_take(g->memory, (size_t)(inputs + states) + 1, sizeof *arguments);
    turning *all = arena_take(g->memory, 4 * (size_t)states + 1, sizeof *all);
    result.at = arena_take(g->memory, (size_t)(result.n * result.n) + 1, sizeof *result.at);
    const int count = list_turnings(m, x, all);
    find_fast(m, all, count, g->memory, &result);
    const evaluation at = {.x = x, .u = arguments, .p = m->parameters.defaults};
    for (int i = 0; i < inputs; i++) {
        arguments[i] = u[i];
    }
    for (int column = 0; column < result.n; column++) {
        for (int i = 0; i < states; i++) {
            arguments[inputs + i] = 0.0;
        }
        int by = 0;
        for (int i = 0; i < count; i++) {
            arguments[inputs + all[i].state] += all[i].reduced == column ? all[i].factor : 0.0;
            by = all[i].reduced == column ? all[i].state : by;
        }
        graph_evaluate(g, 0, &at, numbers);
        for (int i = 0; i < count; i++) {
            const double change = numbers[l->changes[all[i].state]];
            result.at[all[i].reduced * result.n + column] += change * all[i].back;
            result.infinite = isfinite(change) || result.infinite >= 0 ? result.infinite : by;
        }
    }
    clear_quaternions(m, &result);
    arena_return(g->memory, numbers, g->count, sizeof *numbers);
    return result;
}
