#include "tools/isoc/plant/plant.h"

linearised linearise(const graph *g, const mechanism *m, const node *roots, size_t count)
{
    const size_t states = (size_t)state_count(m);
    arena *memory = g->memory;
    node *along = arena_take(memory, states + 1, sizeof *along);
    linearised result = {.m = m, .values = arena_take(memory, count + 1, sizeof *result.values)};
    result.changes = arena_take(memory, count + 1, sizeof *result.changes);
    result.g = economise(g, roots, count, result.values);
    for (size_t i = 0; i < states; i++) {
        along[i] = leaf(&result.g, OP_INPUT, held_count(m) + (int)i);
    }
    differentiate_along(&result.g, result.values, count, along, NULL, result.changes);
    return result;
}

/* The small rotations e of a quaternion (w, x, y, z): dq = e q / 2, and e = 2 dq q'. */
turnings turnings_at(const mechanism *m, arena *memory, const double *x)
{
    static const int from[3][4] = {{1, 0, 3, 2}, {2, 3, 0, 1}, {3, 2, 1, 0}};
    static const double sign[3][4] = {{-1, 1, -1, 1}, {-1, 1, 1, -1}, {-1, -1, 1, 1}};
    turnings result = {.all = arena_take(memory, 4 * (size_t)state_count(m) + 1, sizeof *result.all)};
    int next = 0;
    FOR_ALL (const segment, l, m->segments, m->segment_count) {
        next += positions_of(l->kind);
        if (l->kind != JOINT_SPHERICAL) {
            result.all[result.count++] = (turning){l->position, result.reduced++, NULL, 1.0, 1.0};
            continue;
        }
        for (int e = 0; e < 3; e++, result.reduced++) {
            for (int c = 0; c < 4; c++) {
                const double moved = sign[e][c] * x[l->position + from[e][c]];
                result.all[result.count++] = (turning){l->position + c, result.reduced, l, 0.5 * moved, 2.0 * moved};
            }
        }
    }
    for (int i = next; i < state_count(m); i++) {
        result.all[result.count++] = (turning){i, result.reduced++, NULL, 1.0, 1.0};
    }
    return result;
}
