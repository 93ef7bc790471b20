#include "tools/isoc/dynamics/dynamics.h"

static void put(settled *result, int index, node to)
{
    result->states[result->count] = index;
    result->values[result->count++] = to;
}

/* Adds a state with its change. */
static void put_change(graph *g, settled *result, int index, node from, node change)
{
    put(result, index, result->adds ? change : add(g, from, change));
}

/* A quaternion of length one; where the projection moves it, turned by small angles about the segment's axes. */
static void put_quaternion(graph *g, settled *result, const dynamics *d, int i, const node *moved)
{
    const segment *l = &d->m->segments[i];
    node q[4], turned[4], normed[4];
    for (int n = 0; n < 4; n++) {
        q[n] = d->k.motions[i].q[n];
        turned[n] = constant(g, 0.0);
    }
    if (moved != NULL) {
        quaternion_rates(g, q, moved + l->dof, turned);
    }
    for (int n = 0; n < 4; n++) {
        q[n] = add(g, q[n], turned[n]);
    }
    if (result->adds) {
        quaternion_lengthening(g, q, normed);
    } else {
        quaternion_normalise(g, q, normed);
    }
    for (int n = 0; n < 4; n++) {
        put(result, l->position + n, result->adds ? add(g, turned[n], normed[n]) : normed[n]);
    }
}

/* The change of every state where the positions move by small motions of the degrees of freedom. */
static node *along_moves(graph *g, const dynamics *d, const node *moved)
{
    const mechanism *m = d->m;
    node *along = zero_nodes(g, (size_t)state_count(m));
    for (int i = 0; i < m->segment_count; i++) {
        const segment *l = &m->segments[i];
        if (l->kind == JOINT_SPHERICAL) {
            quaternion_rates(g, d->k.motions[i].q, moved + l->dof, along + l->position);
        } else {
            along[l->position] = moved[l->dof];
        }
    }
    return along;
}

/* The rates after the states change by along[]. Sines and cosines change to first order, as the states do. */
static void move_rates(graph *g, const node *along, node *rates, size_t count)
{
    const size_t before = g->count;
    node *to = all_nodes(g);
    phasor *phasors = phasors_find(g, along, before);
    for (size_t i = 0; i < before; i++) {
        const phasor t = phasors[i];
        if (g->nodes[i].op == OP_STATE) {
            to[i] = add(g, (node)i, along[g->nodes[i].index]);
        } else if (t.other >= 0 && !is_zero(g, t.rate)) {
            to[i] = add(g, (node)i, mul(g, t.rate, t.other));
        }
    }
    replace_nodes(g, rates, count, before, to);
    arena_return(g->memory, to, before, sizeof *to);
    arena_return(g->memory, phasors, before, sizeof *phasors);
}

static void put_pivot(graph *g, settled *result, node pivot, int of_closure)
{
    if (!is_constant(g, pivot)) {
        result->pivots[result->pivot_count] = pivot;
        result->pivot_closures[result->pivot_count++] = of_closure;
    }
}

/* Whether the product of six such pivots is in the range of float, with room for their changes in the motion. */
static bool is_moderate(double pivot)
{
    const double most = 65536.0;
    return pivot > 1.0 / most && pivot < most;
}

/* The product of the pivots of each closure: the determinant of its block after the elimination of those before it,
 * which does not depend on its axes. The regularisation would hide how small it is, and is subtracted. The pivots of a
 * leg vanish where it is stretched, also where the other legs keep the platform's freedom: with legs, the determinant
 * of all shows a singular position. */
static void put_pivots(graph *g, const augmented *over, settled *result)
{
    const size_t count = (size_t)over->phi.count;
    result->pivots = arena_take(g->memory, count, sizeof *result->pivots);
    result->pivot_closures = arena_take(g->memory, count, sizeof *result->pivot_closures);
    if (over->size > over->phi.count) {
        put_pivot(g, result, augmented_inverse_determinant(over), over->phi.all[0].closure);
        return;
    }
    const double *numbers = numbers_at_start(g, over->mass->k->m);
    node product = constant(g, 1.0);
    for (int r = 0; r < over->phi.count; r++) {
        const constraint *c = &over->phi.all[r];
        const node pivot = over->pivots[r];
        product = mul(g, product, sub(g, pivot, over->regularisation));
        if (r + 1 == over->phi.count || c[1].closure != c->closure || !is_moderate(numbers[pivot]) ||
            !is_moderate(numbers[over->pivots[r + 1]])) {
            put_pivot(g, result, product, c->closure);
            product = constant(g, 1.0);
        }
    }
}

/* [nodes] that the gaps and rates read, but not through the changes of the positions: computed at the end of a step. */
static bool *find_read_by_gaps(graph *g, const augmented *over, const node *gaps, const node *rates, const node *moved)
{
    bool *result = arena_take(g->memory, g->count, sizeof *result);
    bool *is_change = arena_take(g->memory, g->count, sizeof *is_change);
    for (int f = 0; f < over->mass->n; f++) {
        const graph_node *n = &g->nodes[moved[f]];
        is_change[n->op == OP_NEG ? n->a : moved[f]] = true;
    }
    for (int r = 0; r < over->phi.count; r++) {
        result[gaps[r]] = result[rates[r]] = true;
    }
    for (size_t i = g->count; i-- > 0;) {
        const graph_node *n = &g->nodes[i];
        const node operands[] = {n->a, n->b};
        for (int k = 0; k < operators[n->op].operands && result[i] && !is_change[i]; k++) {
            result[operands[k]] = true;
        }
    }
    arena_return(g->memory, is_change, g->count, sizeof *is_change);
    return result;
}

/* Adds factors without their signs, and no leaves. */
static void put_all(const graph *g, settled *result, const bool *is_read, const node *factors, int count)
{
    for (int i = 0; i < count; i++) {
        const node bare = g->nodes[factors[i]].op == OP_NEG ? g->nodes[factors[i]].a : factors[i];
        if (!is_read[bare] && operators[g->nodes[bare].op].operands > 0) {
            result->factors[result->factor_count++] = bare;
        }
    }
}

/* The factors of M and of the Schur complement that a projection reads and its gaps do not read. */
static void put_factors(graph *g, const augmented *over, const bool *is_read, settled *result)
{
    const mass_matrix *mass = over->mass;
    const int n = mass->n, rows = over->phi.count, size = over->size;
    result->factors =
        arena_take(g->memory, (size_t)(n * n + n + rows * n + size * size + size), sizeof *result->factors);
    for (int f = 0; f < n; f++) {
        put_all(g, result, is_read, mass->at + f * n, f);
    }
    for (int r = 0; r < rows; r++) {
        put_all(g, result, is_read, over->reach[r], n);
    }
    put_all(g, result, is_read, mass->inverse, n);
    put_all(g, result, is_read, over->schur, size * size);
    put_all(g, result, is_read, over->pivots, size);
}

/* The changes of positions and speeds with which the closures hold, to first order and with the least kinetic energy:
 * Eich (1993), "Convergence results for a coordinate projection method applied to mechanical systems with algebraic
 * constraints", SIAM J. Numerical Analysis 30(5). With an implicit method stiffness counts as well as inertia. There
 * inertia alone would close a gap by a strain of any spring that has a light body at its end, however stiff the spring
 * is; such a strain after every step is a force that the next one must take back, and it grows.
 *
 * The speeds are those that the closures demand where the positions move to: the rates change on the way by as much as
 * the local error times the speed, which would be left from every step to the next. */
static void build_changes(graph *g, const dynamics *d, node **moved, node **sped, settled *result)
{
    const constraints *phi = &d->loops.phi;
    const size_t count = (size_t)phi->count;
    node *gaps = arena_take(g->memory, count, sizeof *gaps), *rates = arena_take(g->memory, count, sizeof *rates);
    const mass_matrix *resistance = resistance_build(g, d);
    const augmented over = resistance == &d->mass ? d->loops : augmented_factors(resistance, *phi);
    graph_section(g, "Projection of the positions");
    for (size_t r = 0; r < count; r++) {
        gaps[r] = phi->all[r].position;
        rates[r] = phi->all[r].rate;
    }
    *moved = augmented_project(&over, gaps);
    holds_stop(g, d->m, *moved);
    graph_section(g, "Projection of the speeds");
    move_rates(g, along_moves(g, d, *moved), rates, count);
    *sped = augmented_project(&over, rates);
    holds_stop(g, d->m, *sped);
    put_pivots(g, &over, result);
    if (resistance == &d->mass) {
        put_factors(g, &over, find_read_by_gaps(g, &over, gaps, rates, *moved), result);
    }
}

settled settled_build(graph *g, const dynamics *d)
{
    const mechanism *m = d->m;
    const bool projected = m->drift.projections > 0 && d->loops.phi.count > 0;
    const size_t states = (size_t)state_count(m);
    settled result = {.adds = ISO_IS_COMPENSATED(m->method.recipe)};
    result.states = arena_take(g->memory, states, sizeof *result.states);
    result.values = result.equations = arena_take(g->memory, states, sizeof *result.values);
    node *moved = NULL, *sped = NULL;
    if (projected) {
        build_changes(g, d, &moved, &sped, &result);
    }
    graph_section(g, "Where the step ends; a quaternion's length by one step of Newton's method for 1 / norm");
    for (int i = 0; i < m->segment_count; i++) {
        const segment *l = &m->segments[i];
        if (l->kind == JOINT_SPHERICAL) {
            put_quaternion(g, &result, d, i, moved);
        } else if (projected && !is_zero(g, moved[l->dof])) {
            put_change(g, &result, l->position, d->k.motions[i].q[0], moved[l->dof]);
        }
    }
    for (int f = 0; f < m->dof_count && projected; f++) {
        if (!is_zero(g, sped[f])) {
            const int index = m->position_count + f;
            put_change(g, &result, index, leaf(g, OP_STATE, index), sped[f]);
        }
    }
    return result;
}
