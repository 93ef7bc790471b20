#include "tools/isoc/jacobian.h"

/* The rules of differentiation; da and db are the derivatives of the operands. */
static node derivative_of(graph *g, node i, node da, node db)
{
    const graph_node n = g->nodes[i];
    switch (n.op) {
    case OP_ADD:
        return add(g, da, db);
    case OP_SUB:
        return sub(g, da, db);
    case OP_MUL:
        return add(g, mul(g, da, n.b), mul(g, n.a, db));
    case OP_DIV: /* (a / b)' = (a' - (a / b) b') / b, with one division for all derivatives */
        return mul(g, sub(g, da, mul(g, i, db)), divide(g, constant(g, 1.0), n.b));
    case OP_NEG:
        return neg(g, da);
    case OP_SQRT:
        return divide(g, da, mul(g, constant(g, 2.0), i));
    case OP_SIN:
        return mul(g, cosine(g, n.a), da);
    case OP_COS:
        return neg(g, mul(g, sine(g, n.a), da));
    default:
        return constant(g, 0.0);
    }
}

void differentiate(graph *g, const node *roots, size_t count, node by, node *derivatives)
{
    const size_t before = g->count; /* what is made on the way is not differentiated */
    const node zero = constant(g, 0.0), one = constant(g, 1.0);
    bool *needed = arena_take(g->memory, g->count, sizeof *needed);
    node *d = arena_take(g->memory, g->count, sizeof *d);
    graph_reach(g, roots, count, needed);
    for (size_t i = 0; i < before; i++) {
        d[i] = (node)i == by ? one : zero;
        if (needed[i] && g->nodes[i].op >= OP_ADD) {
            d[i] = derivative_of(g, (node)i, d[g->nodes[i].a], d[g->nodes[i].b]);
        }
    }
    for (size_t i = 0; i < count; i++) {
        derivatives[i] = d[roots[i]];
    }
}

/* Where factors are put down: a constant stays one, any other node gets its place in lu[]. */
static node put_down(graph *g, jacobian *made, node n)
{
    if (is_constant(g, n)) {
        return n;
    }
    for (int i = 0; i < made->factor_count; i++) {
        if (made->factors[i] == n) {
            return leaf(g, OP_FACTOR, i);
        }
    }
    made->factors[made->factor_count] = n;
    return leaf(g, OP_FACTOR, made->factor_count++);
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

/* With J = [0 1; A B] and r = (r_q, r_v): (1 - hb B - hb^2 A) d_v = r_v + hb A r_q, d_q = r_q + hb d_v. */
static void solve(graph *g, jacobian *made, const node *lu, const node *coupling, node hb, int n)
{
    node *y = made->solution + n;
    for (int i = 0; i < n; i++) {
        y[i] = leaf(g, OP_RIGHT, n + i);
        for (int j = 0; j < n; j++) {
            y[i] = add(g, y[i], mul(g, put_down(g, made, coupling[i * n + j]), leaf(g, OP_RIGHT, j)));
        }
        for (int j = 0; j < i; j++) {
            y[i] = sub(g, y[i], mul(g, put_down(g, made, lu[i * n + j]), y[j]));
        }
    }
    for (int i = n - 1; i >= 0; i--) {
        for (int j = i + 1; j < n; j++) {
            y[i] = sub(g, y[i], mul(g, put_down(g, made, lu[i * n + j]), y[j]));
        }
        y[i] = mul(g, y[i], put_down(g, made, lu[i * n + i]));
    }
    for (int i = 0; i < n; i++) {
        made->solution[i] = add(g, leaf(g, OP_RIGHT, i), mul(g, put_down(g, made, hb), y[i]));
    }
}

jacobian jacobian_build(graph *g, const dynamics *d)
{
    const int n = d->m->link_count;
    const size_t square = (size_t)n * (size_t)n;
    node *by_q = arena_take(g->memory, square, sizeof *by_q), *by_qd = arena_take(g->memory, square, sizeof *by_qd);
    node *column = arena_take(g->memory, (size_t)n, sizeof *column);
    jacobian made = {.factors = arena_take(g->memory, 2 * square + 1, sizeof *made.factors)};
    made.solution = arena_take(g->memory, 2 * (size_t)n, sizeof *made.solution);

    graph_section(g, "Jacobian of the accelerations: by positions and by speeds");
    for (int j = 0; j < n; j++) {
        differentiate(g, d->acceleration, (size_t)n, d->motions[j].q, column);
        for (int i = 0; i < n; i++) {
            by_q[i * n + j] = column[i];
        }
        differentiate(g, d->acceleration, (size_t)n, d->motions[j].qd, column);
        for (int i = 0; i < n; i++) {
            by_qd[i * n + j] = column[i];
        }
    }

    graph_section(g, "1 - hb B - hb^2 A = L U, for accelerations q'' with A = dq''/dq, B = dq''/dq'");
    const node hb = leaf(g, OP_STEP, 0);
    for (size_t k = 0; k < square; k++) {
        const node one = constant(g, k % (size_t)(n + 1) == 0 ? 1.0 : 0.0);
        by_q[k] = mul(g, hb, by_q[k]);
        by_qd[k] = sub(g, one, mul(g, hb, add(g, by_qd[k], by_q[k])));
    }
    factorise(g, by_qd, n);
    graph_section(g, "L U d_v = r_v + hb A r_q, then d_q = r_q + hb d_v");
    solve(g, &made, by_qd, by_q, hb, n);
    return made;
}
