#include "tools/isoc/implicit/jacobian.h"

const char *const factoring_names[FACTORINGS] = {"full", "sparse", "looped"};

/* Where factors are stored: a constant stays one, any other node gets its place in lu[]. */
static node put_down(graph *g, jacobian *result, node n)
{
    if (is_constant(g, n)) {
        return n;
    }
    for (int i = 0; i < result->factor_count; i++) {
        if (result->factors[i] == n) {
            return leaf(g, OP_FACTOR, i);
        }
    }
    result->factors[result->factor_count] = n;
    return leaf(g, OP_FACTOR, result->factor_count++);
}

/* w = L U in place, the diagonal of U inverted. */
static void factorise(graph *g, node *w, int n)
{
    for (int k = 0; k < n; k++) {
        w[k * n + k] = divide(g, constant(g, 1.0), w[k * n + k]);
        for (int i = k + 1; i < n; i++) {
            w[i * n + k] = mul(g, w[i * n + k], w[k * n + k]);
            for (int j = k + 1; j < n; j++) {
                w[i * n + j] = sub(g, w[i * n + j], mul(g, w[i * n + k], w[k * n + j]));
            }
        }
    }
}

/* The unknowns z and their equations, weights (d_z - r_z) = hb d(left): all states but the positions whose rate is a
 * speed, which follow from that speed; and multipliers. */
typedef struct unknowns {
    int states, count;
    int *state_of; /* [count] the state of an unknown, or -1: a multiplier */
    int *partner;  /* [states] the unknown that a state is, or whose value is its rate */
    bool *follows; /* [states] whether it is the latter */
    node *left;    /* [count] */
    node *weights; /* [count count] */
} unknowns;

static unknowns unknowns_of(graph *g, const node *derivatives, int states, int dofs, int most)
{
    const size_t room = (size_t)most;
    unknowns z = {.states = states, .state_of = arena_take(g->memory, room, sizeof *z.state_of)};
    z.partner = arena_take(g->memory, (size_t)states, sizeof *z.partner);
    z.follows = arena_take(g->memory, (size_t)states, sizeof *z.follows);
    z.left = arena_take(g->memory, room, sizeof *z.left);
    z.weights = arena_take(g->memory, room * room, sizeof *z.weights);
    /* From the tips to the root, where M has its zeros. */
    for (int i = states - 1; i >= 0; i--) {
        const graph_node *rate = &g->nodes[derivatives[i]];
        z.follows[i] = rate->op == OP_STATE && rate->index >= states - dofs;
        if (!z.follows[i]) {
            z.partner[i] = z.count;
            z.state_of[z.count++] = i;
        }
    }
    for (int i = 0; i < states; i++) {
        z.partner[i] = z.follows[i] ? z.partner[g->nodes[derivatives[i]].index] : z.partner[i];
    }
    return z;
}

/* z' = f: the weights are those of the unit matrix. */
static unknowns solved_equations(graph *g, const dynamics *d, const node *derivatives)
{
    const int states = state_count(d->m);
    unknowns z = unknowns_of(g, derivatives, states, d->m->dof_count, states);
    for (int i = 0; i < z.count; i++) {
        z.left[i] = derivatives[z.state_of[i]];
        for (int j = 0; j < z.count; j++) {
            z.weights[i * z.count + j] = constant(g, i == j ? 1.0 : 0.0);
        }
    }
    return z;
}

/* The balance of forces in the place of the rates of the speeds, and of the constraints beside them. */
static unknowns balanced_equations(graph *g, const dynamics *d, const node *derivatives)
{
    const mechanism *m = d->m;
    const balance b = balance_build(d);
    const int states = state_count(m), rows = b.rows, n = m->dof_count;
    unknowns z = unknowns_of(g, derivatives, states, n, states + rows - n);
    int *row = arena_take(g->memory, (size_t)(states + rows), sizeof *row); /* of the balance; -1: an explicit rate */
    for (int i = 0; i < z.count; i++) {
        row[i] = z.state_of[i] < m->position_count ? -1 : z.state_of[i] - m->position_count;
    }
    for (int r = n; r < rows; r++) {
        row[z.count] = r;
        z.state_of[z.count++] = -1;
    }
    const node zero = constant(g, 0.0), one = constant(g, 1.0);
    for (int i = 0; i < z.count; i++) {
        z.left[i] = row[i] < 0 ? derivatives[z.state_of[i]] : b.left[row[i]];
        for (int j = 0; j < z.count; j++) {
            const bool both = row[i] >= 0 && row[j] >= 0;
            z.weights[i * z.count + j] = both ? b.weights[row[i] * rows + row[j]] : i == j ? one : zero;
        }
    }
    return z;
}

/* With p the positions that follow from speeds: (W - hb left_z - hb^2 left_p) d_z = W r_z + hb left_p r_p, then
 * d_p = r_p + hb d_speed. */
static void solve(graph *g, jacobian *result, const unknowns *z, const node *lu, const node *coupling, node hb)
{
    const int n = z->count;
    node *y = zero_nodes(g, (size_t)n);
    for (int i = 0; i < n; i++) {
        for (int j = 0; j < n; j++) {
            const node weight = put_down(g, result, z->weights[i * n + j]);
            y[i] = z->state_of[j] < 0 ? y[i] : add(g, y[i], mul(g, weight, leaf(g, OP_RIGHT, z->state_of[j])));
        }
        for (int j = 0; j < z->states; j++) {
            const node factor = put_down(g, result, coupling[i * z->states + j]);
            y[i] = add(g, y[i], mul(g, factor, leaf(g, OP_RIGHT, j)));
        }
        for (int j = 0; j < i; j++) {
            y[i] = sub(g, y[i], mul(g, put_down(g, result, lu[i * n + j]), y[j]));
        }
    }
    for (int i = n - 1; i >= 0; i--) {
        for (int j = i + 1; j < n; j++) {
            y[i] = sub(g, y[i], mul(g, put_down(g, result, lu[i * n + j]), y[j]));
        }
        y[i] = mul(g, y[i], put_down(g, result, lu[i * n + i]));
    }
    for (int i = 0; i < z->states; i++) {
        const node found = y[z->partner[i]];
        result->solution[i] = found;
        if (z->follows[i]) {
            const node moved = mul(g, put_down(g, result, hb), found);
            result->solution[i] = add(g, leaf(g, OP_RIGHT, i), moved);
        }
    }
}

/* Replaces the leaves of the balanced equations by the quantities that they stand for. */
static void put_solution(graph *g, const dynamics *d, const node *derivatives, node *nodes, int count)
{
    replace_leaves(g, nodes, (size_t)count, OP_DERIVATIVE, derivatives);
    replace_leaves(g, nodes, (size_t)count, OP_MULTIPLIER, d->loops.multipliers);
}

static jacobian build(graph *g, const dynamics *d, const node *derivatives, const unknowns *z)
{
    const int n = z->count, states = z->states;
    const size_t square = (size_t)(n * n), coupled = (size_t)(n * states);
    node *column = arena_take(g->memory, (size_t)n, sizeof *column);
    node *lu = zero_nodes(g, square), *coupling = zero_nodes(g, coupled);
    jacobian result = {.factors = arena_take(g->memory, 2 * square + coupled + 1, sizeof *result.factors)};
    result.solution = arena_take(g->memory, (size_t)states, sizeof *result.solution);

    graph_section(g, "Derivatives by positions and by speeds");
    const node hb = leaf(g, OP_STEP, 0);
    for (int j = 0; j < states; j++) {
        node *to = lu + z->partner[j];
        differentiate(g, z->left, (size_t)n, leaf(g, OP_STATE, j), column);
        for (int i = 0; i < n; i++) {
            if (z->follows[j]) {
                coupling[i * states + j] = column[i] = mul(g, hb, column[i]);
            }
            to[i * n] = add(g, column[i], to[i * n]);
        }
    }
    put_solution(g, d, derivatives, lu, n * n);
    put_solution(g, d, derivatives, coupling, n * states);

    graph_section(g, "W - hb B - hb^2 A = L U, for W z' = left(p, z) with A = d left / dp, B = d left / dz");
    for (int k = 0; k < n * n; k++) {
        lu[k] = sub(g, z->weights[k], mul(g, hb, lu[k]));
    }
    factorise(g, lu, n);
    graph_section(g, "L U d_z = W r_z + hb A r_p, then d_p = r_p + hb d_speed");
    solve(g, &result, z, lu, coupling, hb);
    return result;
}

/* Operations of a step: a factorisation and two or three solutions. */
static int cost_of(const graph *g, const jacobian *j, int states)
{
    enum { SOLUTIONS = 3 };
    const int factor = cycles_of(count_operations(g, j->factors, (size_t)j->factor_count));
    return factor + SOLUTIONS * cycles_of(count_operations(g, j->solution, (size_t)states));
}

/* Whether the balance is that of the accelerations: it has the multipliers of one iteration of the augmented
 * Lagrangian. Those of more differ from them by e over an eigenvalue of A, which a stiff element makes a multiple of
 * itself. */
static bool is_balance_exact(const mechanism *m)
{
    return !m->drift.is_redundant || m->drift.multiplier_iterations == 1;
}

/* Each in a copy of the graph. */
static jacobian full(graph *g, const dynamics *d, const node *derivatives)
{
    graph before = *g;
    const int states = state_count(d->m);
    *g = graph_copy(&before);
    const unknowns solved = solved_equations(g, d, derivatives);
    const jacobian of_solved = build(g, d, derivatives, &solved);
    graph with_solved = *g;
    *g = graph_copy(&before);
    const unknowns balanced = balanced_equations(g, d, derivatives);
    const jacobian of_balanced = build(g, d, derivatives, &balanced);
    graph_free(&before);
    const bool is_cheaper = cost_of(g, &of_balanced, states) < cost_of(&with_solved, &of_solved, states);
    const bool is_balanced = is_cheaper && is_balance_exact(d->m);
    graph_free(is_balanced ? &with_solved : g);
    *g = is_balanced ? *g : with_solved;
    return is_balanced ? of_balanced : of_solved;
}

/* L U in place, as core/methods/sparse.h does it. */
static void factorise_sparse(graph *g, const elimination *e, node *lu)
{
    const int *target = e->target;
    for (int i = 0; i < e->count; i++) {
        for (int at = e->row[i]; at + 1 < e->beyond[i]; at++) {
            const int k = e->column[at];
            lu[at] = mul(g, lu[at], lu[e->beyond[k] - 1]);
            for (int from = e->beyond[k]; from < e->row[k + 1]; from++) {
                node *to = &lu[e->row[i] + *target++];
                *to = sub(g, *to, mul(g, lu[at], lu[from]));
            }
        }
        lu[e->beyond[i] - 1] = divide(g, constant(g, 1.0), lu[e->beyond[i] - 1]);
    }
}

static void solve_sparse(graph *g, jacobian *result, const extended *x, const node *lu, int states)
{
    const elimination *e = &x->e;
    node *y = zero_nodes(g, (size_t)e->count);
    for (int i = 0; i < states; i++) {
        y[x->right_row[i]] = leaf(g, OP_RIGHT, i);
    }
    for (int i = 0; i < e->count; i++) {
        for (int at = e->row[i]; at + 1 < e->beyond[i]; at++) {
            y[i] = sub(g, y[i], mul(g, put_down(g, result, lu[at]), y[e->column[at]]));
        }
    }
    for (int i = e->count - 1; i >= 0; i--) {
        for (int at = e->beyond[i]; at < e->row[i + 1]; at++) {
            y[i] = sub(g, y[i], mul(g, put_down(g, result, lu[at]), y[e->column[at]]));
        }
        y[i] = mul(g, y[i], put_down(g, result, lu[e->beyond[i] - 1]));
    }
    for (int i = 0; i < states; i++) {
        result->solution[i] = y[x->found[i]];
    }
}

static jacobian sparse(graph *g, const dynamics *d, const node *derivatives, const extended *x)
{
    const int states = state_count(d->m);
    jacobian result = {.kind = FACTORING_SPARSE};
    result.factors = arena_take(g->memory, (size_t)x->e.nonzeros, sizeof *result.factors);
    result.solution = arena_take(g->memory, (size_t)states, sizeof *result.solution);
    replace_leaves(g, x->entries, (size_t)x->e.nonzeros, OP_DERIVATIVE, derivatives);
    graph_section(g, "Their factors L U");
    factorise_sparse(g, &x->e, x->entries);
    graph_section(g, "L U d = r, for all unknowns");
    solve_sparse(g, &result, x, x->entries, states);
    return result;
}

/* Whether the elimination is too long to be unrolled: up to so many products the code of factors and solution has less
 * than 300 kB on a Cortex-M4F. Loops take a quarter to a half of that, and three to four times the instructions. */
static bool is_long(const elimination *e)
{
    enum { MOST = 12000 };
    return e->products + e->nonzeros > MOST;
}

/* A lower bound of the products that the factors of J take where it is full: those of a matrix with the places of M,
 * eliminated from the tips to the root. */
static long full_products(const mechanism *m)
{
    long products = 0;
    for (int f = 0; f < m->dof_count; f++) {
        long ancestors = 0;
        for (int index = m->dofs[f].before; index != GROUND; index = m->dofs[index].before) {
            ancestors++;
        }
        products += ancestors * ancestors;
    }
    return products;
}

/* The full matrix, whose numbers are fewer to load and to store, unless the sparse one takes less than 3/4 of its
 * operations. Each is made in a copy of the graph. */
static jacobian cheaper(graph *g, graph *before, const dynamics *d, const node *derivatives, const extended *x)
{
    const int states = state_count(d->m);
    const jacobian of_sparse = sparse(g, d, derivatives, x);
    const int cost = cost_of(g, &of_sparse, states);
    if (full_products(d->m) > cost) {
        graph_free(before);
        return of_sparse;
    }
    graph with_sparse = *g;
    *g = *before;
    const jacobian of_full = full(g, d, derivatives);
    const bool is_sparse = 4 * cost < 3 * cost_of(g, &of_full, states);
    graph_free(is_sparse ? g : &with_sparse);
    *g = is_sparse ? with_sparse : *g;
    return is_sparse ? of_sparse : of_full;
}

jacobian jacobian_build(graph *g, const dynamics *d, const node *derivatives, factoring wanted)
{
    if (d->m->closure_count > 0 || wanted == FACTORING_FULL) {
        return full(g, d, derivatives);
    }
    graph before = *g;
    *g = graph_copy(&before);
    const extended *x = extended_build(g, d, derivatives);
    if (wanted == FACTORINGS && !is_long(&x->e)) {
        return cheaper(g, &before, d, derivatives, x);
    }
    graph_free(&before);
    const jacobian looped = {
        .kind = FACTORING_LOOPED, .factors = x->entries, .factor_count = x->e.nonzeros, .looped = x};
    return wanted == FACTORING_SPARSE ? sparse(g, d, derivatives, x) : looped;
}
