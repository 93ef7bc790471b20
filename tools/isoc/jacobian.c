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
        return sum_of_products(g, da, n.b, n.a, db);
    case OP_DIV: { /* (a / b)' = (a' - (a / b) b') / b, with one division for all derivatives */
        const node above = sub(g, da, mul(g, i, db)), inverse = divide(g, constant(g, 1.0), n.b);
        return mul(g, above, inverse);
    }
    case OP_NEG:
        return neg(g, da);
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

/* The states that are solved for: all but the positions whose rate is a speed, which follow from that speed. */
typedef struct unknowns {
    int *states; /* of the unknowns */
    int count;
    int *speeds; /* of every state: where among the unknowns its rate stands, or -1 */
} unknowns;

static unknowns choose_unknowns(graph *g, const node *slopes, int n)
{
    unknowns made = {.states = arena_take(g->memory, (size_t)n, sizeof *made.states)};
    made.speeds = arena_take(g->memory, (size_t)n, sizeof *made.speeds);
    for (int i = 0; i < n; i++) {
        if (g->nodes[slopes[i]].op != OP_STATE) {
            made.states[made.count++] = i;
        }
    }
    for (int i = 0; i < n; i++) {
        made.speeds[i] = -1;
        for (int j = 0; j < made.count; j++) {
            if (slopes[i] == leaf(g, OP_STATE, made.states[j])) {
                made.speeds[i] = j;
            }
        }
    }
    return made;
}

/* With p the positions whose rates are speeds and z the other states, z' = f(p, z), and r = (r_p, r_z):
 * (1 - hb B - hb^2 A) d_z = r_z + hb A r_p with A = df/dp and B = df/dz, then d_p = r_p + hb d_speed. */
static void solve(graph *g, jacobian *made, const unknowns *z, const node *lu, const node *coupling, node hb,
                  int states)
{
    const int n = z->count;
    node *y = arena_take(g->memory, (size_t)n, sizeof *y);
    for (int i = 0; i < n; i++) {
        y[i] = leaf(g, OP_RIGHT, z->states[i]);
        for (int j = 0; j < states; j++) {
            const node factor = put_down(g, made, coupling[i * states + j]);
            y[i] = add(g, y[i], mul(g, factor, leaf(g, OP_RIGHT, j)));
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
        made->solution[z->states[i]] = y[i];
    }
    for (int i = 0; i < states; i++) {
        if (z->speeds[i] >= 0) {
            const node moved = mul(g, put_down(g, made, hb), y[z->speeds[i]]);
            made->solution[i] = add(g, leaf(g, OP_RIGHT, i), moved);
        }
    }
}

jacobian jacobian_build(graph *g, const node *slopes, int states)
{
    const unknowns z = choose_unknowns(g, slopes, states);
    const int n = z.count;
    const size_t square = (size_t)n * (size_t)n;
    node *f = arena_take(g->memory, (size_t)n, sizeof *f), *column = arena_take(g->memory, (size_t)n, sizeof *column);
    node *lu = arena_take(g->memory, square, sizeof *lu);
    node *coupling = arena_take(g->memory, (size_t)(n * states), sizeof *coupling);
    jacobian made = {.factors = arena_take(g->memory, square + (size_t)(n * states) + 1, sizeof *made.factors)};
    made.solution = arena_take(g->memory, (size_t)states, sizeof *made.solution);
    for (int i = 0; i < n; i++) {
        f[i] = slopes[z.states[i]];
    }

    graph_section(g, "Jacobian of the accelerations: by positions and by speeds");
    const node zero = constant(g, 0.0), one = constant(g, 1.0), hb = leaf(g, OP_STEP, 0);
    for (size_t i = 0; i < square; i++) {
        lu[i] = zero;
    }
    for (int j = 0, unknown = 0; j < states; j++) {
        const bool is_unknown = z.speeds[j] < 0;
        const int to = is_unknown ? unknown++ : z.speeds[j];
        differentiate(g, f, (size_t)n, leaf(g, OP_STATE, j), column);
        for (int i = 0; i < n; i++) {
            coupling[i * states + j] = is_unknown ? zero : mul(g, hb, column[i]);
            lu[i * n + to] = add(g, is_unknown ? column[i] : coupling[i * states + j], lu[i * n + to]);
        }
    }

    graph_section(g, "1 - hb B - hb^2 A = L U, for z' = f(p, z) with A = df/dp, B = df/dz");
    for (int k = 0; k < n * n; k++) {
        lu[k] = sub(g, k % (n + 1) == 0 ? one : zero, mul(g, hb, lu[k]));
    }
    factorise(g, lu, n);
    graph_section(g, "L U d_z = r_z + hb A r_p, then d_p = r_p + hb d_speed");
    solve(g, &made, &z, lu, coupling, hb, states);
    return made;
}
