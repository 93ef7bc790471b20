#include "tools/isoc/tree/tree.h"

#include <string.h>

/* Whether any formula asks for one. */
static bool asks_for_inertia(const graph *g)
{
    bool any = false;
    for (size_t i = 0; i < g->count; i++) {
        any = any || g->nodes[i].op == OP_INERTIA;
    }
    return any;
}

/* The inverse of a symmetric positive matrix, by Gauss and Jordan without a search for pivots; [n n]. */
static void invert(double *a, size_t n)
{
    for (size_t k = 0; k < n; k++) {
        const double pivot = 1.0 / a[k * n + k];
        a[k * n + k] = 1.0;
        for (size_t j = 0; j < n; j++) {
            a[k * n + j] *= pivot;
        }
        for (size_t i = 0; i < n; i++) {
            const double factor = i == k ? 0.0 : a[i * n + k];
            a[i * n + k] = i == k ? a[i * n + k] : 0.0;
            for (size_t j = 0; j < n && i != k; j++) {
                a[i * n + j] -= factor * a[k * n + j];
            }
        }
    }
}

/* The inverse of the mass matrix at the start, [n n]. */
static double *inverse_of_mass(const graph *g, const mechanism *m, const mass_matrix *mass)
{
    const size_t n = (size_t)m->dof_count;
    const double *numbers = numbers_at_start(g, m);
    double *inverse = arena_take(g->memory, n * n, sizeof *inverse);
    note_built_in(g, m, mass->entries, n * n);
    for (int i = 0; i < m->dof_count; i++) {
        for (int j = i; j != GROUND; j = m->dofs[j].before) {
            inverse[i * m->dof_count + j] = inverse[j * m->dof_count + i] =
                numbers[mass->entries[i * m->dof_count + j]];
        }
    }
    invert(inverse, n);
    return inverse;
}

/* The velocity of a point that moves with the body, beside its origin. */
static vector velocity_beside(const kinematics *k, const inertia_query *i)
{
    graph *g = k->g;
    const body_frame *frame = &k->m->bodies.frames[i->body];
    const vector point = vector_add(g, matrix_apply(g, frame->turn, i->point), frame->offset);
    const vector moves = axes_of_body(k, frame, i->in_body, point_velocity(k, frame->segment, point));
    const vector turns = axes_of_body(k, frame, i->in_body, k->motions[frame->segment].omega);
    return vector_add(g, moves, vector_cross(g, turns, i->beside));
}

/* The rows of the Jacobian of these velocities at the start, [count n]: as velocities are linear, the value of each
 * where one speed is 1 and all others are 0. */
static double *jacobian(const graph *g, const mechanism *m, const node *velocities, size_t count)
{
    const size_t n = (size_t)m->dof_count;
    double *x = mechanism_start(m, g->memory), *speeds = x + m->position_count;
    evaluation at = start_of(g, m);
    at.x = x;
    double *numbers = arena_take(g->memory, g->count, sizeof *numbers);
    double *rows = arena_take(g->memory, count * n + 1, sizeof *rows);
    note_built_in(g, m, velocities, count);
    memset(speeds, 0, n * sizeof *speeds);
    for (size_t f = 0; f < n; f++) {
        speeds[f] = 1.0;
        graph_evaluate(g, 0, &at, numbers);
        speeds[f] = 0.0;
        for (size_t i = 0; i < count; i++) {
            rows[i * n + f] = numbers[velocities[i]];
        }
    }
    return rows;
}

/* 1 / (row M^-1 row') */
static double mass_along(const double *row, const double *inverse, size_t n)
{
    double sum = 0.0;
    for (size_t i = 0; i < n; i++) {
        for (size_t j = 0; j < n; j++) {
            sum += row[i] * inverse[i * n + j] * row[j];
        }
    }
    return 1.0 / sum;
}

const node *effective_inertias(graph *g, const mechanism *m)
{
    if (!asks_for_inertia(g)) {
        return NULL;
    }
    graph scratch = graph_copy(g); /* so that none of these nodes is in the graph of the plant */
    const kinematics k = kinematics_build(&scratch, m);
    kinematics_velocities(&k);
    const size_t n = (size_t)m->dof_count, points = 3 * m->queries.inertias.count;
    const mass_matrix mass = mass_matrix_build(&k);
    node *velocities = arena_take(g->memory, points + 1, sizeof *velocities);
    for (size_t i = 0; i < m->queries.inertias.count; i++) {
        const vector v = velocity_beside(&k, &m->queries.inertias.all[i]);
        memcpy(velocities + 3 * i, v.at, sizeof v.at);
    }
    const double *inverse = inverse_of_mass(&scratch, m, &mass), *rows = jacobian(&scratch, m, velocities, points);
    graph_free(&scratch);
    node *result = arena_take(g->memory, n + points, sizeof *result);
    for (size_t i = 0; i < n; i++) {
        result[i] = constant(g, 1.0 / inverse[i * n + i]);
    }
    for (size_t i = 0; i < points; i++) {
        result[n + i] = constant(g, mass_along(rows + i * n, inverse, n));
    }
    return result;
}
