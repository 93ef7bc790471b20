#include "tools/isoc/dynamics/dynamics.h"

#include "tools/isoc/method/step_map.h"

/* The efforts of dampers, springs and effects, and of the forces of effects on bodies; those of inputs do not count. */
static node *build_efforts(graph *g, const dynamics *d)
{
    const mechanism *m = d->m;
    const size_t n = (size_t)m->dof_count;
    const wrench none = {vector_zero(g), vector_zero(g)};
    node *effort = arena_take(g->memory, n, sizeof *effort), *pull = arena_take(g->memory, n, sizeof *pull);
    wrench *wrenches = arena_take(g->memory, (size_t)m->segment_count, sizeof *wrenches);
    for (int i = 0; i < m->segment_count; i++) {
        wrenches[i] = none;
    }
    FOR_ALL (const applied_force, f, m->forces.applied, m->forces.applied_count) {
        if (f->drive < 0) {
            wrenches[f->segment] = wrench_sub(g, wrenches[f->segment], wrench_of_applied_force(g, f));
        }
    }
    efforts_of_wrenches(&d->k, wrenches, pull);
    efforts_less(d, pull, effort);
    return effort;
}

/* Adds -part times the derivatives by a state, times `factor`, to column `index` of sum[n n]. */
static void add_column(graph *g, const node *efforts, int n, int state_index, node factor, int index, node *sum)
{
    node *column = arena_take(g->memory, (size_t)n, sizeof *column);
    differentiate(g, efforts, (size_t)n, leaf(g, OP_STATE, state_index), column);
    for (int i = 0; i < n; i++) {
        sum[i * n + index] = sub(g, sum[i * n + index], mul(g, factor, column[i]));
    }
}

/* The addition to the mass matrix, [n n], before its symmetric part is taken. A turn about axis c of a spherical joint
 * changes its quaternion by q (0, e_c) / 2. */
static node *build_addition(graph *g, const dynamics *d, const node *efforts, double hb)
{
    const mechanism *m = d->m;
    const int n = m->dof_count;
    const node once = constant(g, hb), twice = constant(g, hb * hb), zero = constant(g, 0.0);
    node *sum = zero_nodes(g, (size_t)(n * n));
    for (int f = 0; f < n; f++) {
        const segment *l = &m->segments[m->dofs[f].segment];
        add_column(g, efforts, n, m->position_count + f, once, f, sum);
        if (l->kind != JOINT_SPHERICAL) {
            add_column(g, efforts, n, l->position, twice, f, sum);
            continue;
        }
        node rate[3] = {zero, zero, zero}, moved[4];
        rate[f - l->dof] = constant(g, 1.0);
        quaternion_rates(g, d->k.motions[m->dofs[f].segment].q, rate, moved);
        for (int i = 0; i < 4; i++) {
            add_column(g, efforts, n, l->position + i, mul(g, twice, moved[i]), f, sum);
        }
    }
    return sum;
}

/* A mass matrix whose degrees of freedom are all ancestors of those after them, since efforts may couple any two: zeros
 * vanish from its factors. */
static mass_matrix *blank_chain(graph *g, const dynamics *d)
{
    const size_t n = (size_t)d->m->dof_count;
    mechanism *m = list_copy(g->memory, d->m, 1, sizeof *m);
    kinematics *k = list_copy(g->memory, &d->k, 1, sizeof *k);
    mass_matrix *result = arena_take(g->memory, 1, sizeof *result);
    k->m = m;
    m->dofs = list_copy(g->memory, d->m->dofs, n, sizeof *m->dofs);
    for (int f = 0; f < m->dof_count; f++) {
        m->dofs[f].before = f > 0 ? f - 1 : GROUND;
    }
    *result =
        (mass_matrix){.k = k, .n = d->m->dof_count, .entries = arena_take(g->memory, n * n, sizeof *result->entries)};
    return result;
}

const mass_matrix *resistance_build(graph *g, const dynamics *d)
{
    const mechanism *m = d->m;
    const int n = m->dof_count;
    const double hb = method_step(m) * implicit_part(g->memory, ISO_METHOD_OF(m->method.recipe));
    if (hb == 0.0) {
        return &d->mass;
    }
    graph_section(g, "What a push meets within a step: inertia, dampers, springs, effects");
    const node *efforts = build_efforts(g, d);
    if (!uses_operation(g, efforts, (size_t)n, OP_STATE)) {
        return &d->mass;
    }
    const node *addition = build_addition(g, d, efforts, hb), half = constant(g, 0.5);
    mass_matrix *result = blank_chain(g, d);
    for (int i = 0; i < n; i++) {
        for (int j = 0; j <= i; j++) {
            const node both = add(g, addition[i * n + j], addition[j * n + i]);
            result->entries[i * n + j] = mul(g, half, both);
        }
        for (int j = i; j != GROUND; j = m->dofs[j].before) {
            result->entries[i * n + j] = add(g, d->mass.entries[i * n + j], result->entries[i * n + j]);
        }
    }
    mass_matrix_factorise(result);
    return result;
}
