#include "tools/isoc/dynamics/dynamics.h"

/* Newton-Euler with the accelerations, inward. */
static void build_forces(const dynamics *d, balance *b)
{
    const mechanism *m = d->m;
    node *taken = arena_take(d->g->memory, (size_t)m->dof_count, sizeof *taken);
    b->wrenches = arena_take(d->g->memory, (size_t)m->segment_count, sizeof *b->wrenches);
    b->accelerations = reaction_accelerations(d);
    graph_section(d->g, "What is left of the efforts over what the accelerations take");
    inertial_wrenches(&d->k, b->accelerations, b->wrenches);
    efforts_of_wrenches(&d->k, b->wrenches, taken);
    FOR_ALL (const segment, l, m->segments, m->segment_count) {
        for (int f = l->dof; f < l->dof + dofs_of(l->kind); f++) {
            const node rate = leaf(d->g, OP_DERIVATIVE, m->position_count + f);
            taken[f] = add(d->g, taken[f], mul(d->g, l->armature, rate));
        }
    }
    efforts_less(d, taken, b->left);
}

/* The rows of the constraints, and the forces of their multipliers. */
static void build_constraints(const dynamics *d, balance *b)
{
    graph *g = d->g;
    const mechanism *m = d->m;
    const constraints *phi = &d->loops.phi;
    const int n = m->dof_count, rows = b->rows;
    for (int r = 0; r < phi->count; r++) {
        node demand = demand_of(g, m, &phi->all[r]);
        const node lambda = leaf(g, OP_MULTIPLIER, r);
        for (int f = 0; f < n; f++) {
            const node entry = phi->all[r].row[f];
            b->weights[f * rows + n + r] = b->weights[(n + r) * rows + f] = entry;
            b->left[f] = sub(g, b->left[f], mul(g, entry, lambda));
            demand = add(g, demand, mul(g, entry, leaf(g, OP_DERIVATIVE, m->position_count + f)));
        }
        b->left[n + r] = neg(g, demand);
        b->weights[(n + r) * rows + n + r] = neg(g, d->loops.regularisation);
    }
}

balance balance_build(const dynamics *d)
{
    const mechanism *m = d->m;
    const int n = m->dof_count, rows = n + d->loops.phi.count;
    balance b = {.rows = rows, .left = arena_take(d->g->memory, (size_t)rows, sizeof *b.left)};
    b.weights = zero_nodes(d->g, (size_t)(rows * rows));
    for (int i = 0; i < n; i++) {
        for (int j = i; j != GROUND; j = m->dofs[j].before) {
            b.weights[i * rows + j] = b.weights[j * rows + i] = d->mass.entries[i * n + j];
        }
    }
    build_forces(d, &b);
    build_constraints(d, &b);
    return b;
}
