#include "tools/isoc/dynamics/dynamics.h"

#include <float.h>

/* A value where the hold is stuck, else zero; and where it slips. Modes are 0, 1 and -1. */
static node slipping(graph *g, const held_speed *h)
{
    const node mode = leaf(g, OP_STATE, h->state);
    return mul(g, mode, mode);
}

/* L'^-1 of the row of its speed. */
static node *row_inward(const mass_matrix *mass, const held_speed *h)
{
    graph *g = mass->k->g;
    node *row = zero_nodes(g, (size_t)mass->n);
    row[h->dof] = constant(g, 1.0);
    if (h->against >= 0) {
        row[h->against] = constant(g, -1.0);
    }
    mass_matrix_inward(mass, row);
    return row;
}

/* row' x */
static node product(const mass_matrix *mass, const node *row, const node *x)
{
    graph *g = mass->k->g;
    node sum = constant(g, 0.0);
    for (int f = 0; f < mass->n; f++) {
        sum = add(g, sum, mul(g, row[f], x[f]));
    }
    return sum;
}

/* D^-1 row, and with closures what these leave of it. */
static node *response(const mass_matrix *mass, const augmented *loops, const node *row, node *multipliers)
{
    graph *g = mass->k->g;
    node *result = zero_nodes(g, (size_t)mass->n);
    for (int f = 0; f < mass->n; f++) {
        result[f] = mul(g, row[f], mass->inverse[f]);
    }
    if (loops != NULL) {
        augmented_respond(loops, result, multipliers);
    }
    return result;
}

/* The share of a mobility below which what is left of it is rounding: other holds hold this one already. That of
 * ISO_HOLD_ROUNDING in core/methods/hold.h. */
static double rounding_of(const mechanism *m)
{
    return 256.0 * (m->is_double ? DBL_EPSILON : (double)FLT_EPSILON);
}

/* 1 / pivot; zero where that is rounding against the mobility of a hold that is stuck. */
static node inverse_of(graph *g, const mechanism *m, const held_speed *h, node pivot, node own)
{
    const node is_free = slipping(g, h);
    const node limit = mul(g, constant(g, rounding_of(m)), own);
    const node is_good = above(g, pivot, limit);
    const node counts = larger(g, is_free, is_good);
    const node rest = sub(g, constant(g, 1.0), counts);
    const node safe = add(g, mul(g, pivot, counts), rest);
    return divide(g, counts, safe);
}

/* x := B^-1 x, where B has the rows and columns of A that are stuck, and those of the identity. */
static void solve_stuck(const mechanism *m, graph *g, const node *mobility, node *x)
{
    const int n = m->events.hold_count;
    const held_speed *all = m->events.holds;
    node *at = zero_nodes(g, (size_t)(n * n)); /* L, and 1 / D on the diagonal */
    for (int i = 0; i < n; i++) {
        const node is_free = slipping(g, &all[i]), own = mobility[i * n + i];
        const node stuck = sub(g, constant(g, 1.0), is_free);
        node pivot = add(g, mul(g, stuck, own), is_free);
        for (int j = 0; j < i; j++) {
            const node other = sub(g, constant(g, 1.0), slipping(g, &all[j]));
            const node both = mul(g, stuck, other);
            at[i * n + j] = mul(g, both, mobility[i * n + j]);
            for (int k = 0; k < j; k++) {
                at[i * n + j] = sub(g, at[i * n + j], mul(g, at[i * n + k], at[j * n + k]));
            }
        }
        for (int k = 0; k < i; k++) {
            const node factor = mul(g, at[i * n + k], at[k * n + k]);
            pivot = sub(g, pivot, mul(g, factor, at[i * n + k]));
            at[i * n + k] = factor;
        }
        graph_name(g, pivot, "pivot_hold_%d", i);
        at[i * n + i] = n == 1 ? divide(g, constant(g, 1.0), pivot) : inverse_of(g, m, &all[i], pivot, own);
        for (int k = 0; k < i; k++) {
            x[i] = sub(g, x[i], mul(g, at[i * n + k], x[k]));
        }
    }
    for (int i = n - 1; i >= 0; i--) {
        x[i] = mul(g, x[i], at[i * n + i]);
        for (int k = i + 1; k < n; k++) {
            x[i] = sub(g, x[i], mul(g, at[k * n + i], x[k]));
        }
    }
}

/* The efforts, from mobility and free accelerations. */
static void find_efforts(const mechanism *m, graph *g, hold_equations *h)
{
    const int n = m->events.hold_count;
    const held_speed *all = m->events.holds;
    node *sliding = zero_nodes(g, (size_t)n), *right = zero_nodes(g, (size_t)n);
    graph_section(g, "Efforts of holds");
    for (int i = 0; i < n; i++) {
        const node mode = leaf(g, OP_STATE, all[i].state);
        sliding[i] = neg(g, mul(g, mode, all[i].sliding));
    }
    for (int i = 0; i < n; i++) {
        const node stuck = sub(g, constant(g, 1.0), slipping(g, &all[i]));
        node sum = h->free[i];
        for (int j = 0; j < n; j++) {
            sum = add(g, sum, mul(g, h->mobility[i * n + j], sliding[j]));
        }
        right[i] = neg(g, mul(g, stuck, sum));
    }
    solve_stuck(m, g, h->mobility, right);
    for (int i = 0; i < n; i++) {
        h->effort[i] = graph_name(g, add(g, sliding[i], right[i]), "effort_%s", all[i].called);
    }
}

hold_equations holds_build(const mass_matrix *mass, augmented *loops, node *x)
{
    graph *g = mass->k->g;
    const mechanism *m = mass->k->m;
    const int n = m->events.hold_count, rows = loops == NULL ? 0 : loops->phi.count;
    const size_t count = (size_t)n;
    hold_equations result = {
        .free = zero_nodes(g, count), .mobility = zero_nodes(g, count * count), .effort = zero_nodes(g, count)};
    node **responses = arena_take(g->memory, count, sizeof *responses);
    node *multipliers = zero_nodes(g, count * (size_t)rows + 1);
    graph_section(g, "Holds: mobility of their speeds, and accelerations without holds");
    for (int i = 0; i < n; i++) {
        const node *row = row_inward(mass, &m->events.holds[i]);
        responses[i] = response(mass, loops, row, multipliers + i * rows);
        result.free[i] = product(mass, row, x);
        for (int j = 0; j <= i; j++) {
            result.mobility[i * n + j] = result.mobility[j * n + i] = product(mass, row, responses[j]);
        }
    }
    find_efforts(m, g, &result);
    for (int i = 0; i < n; i++) {
        for (int f = 0; f < mass->n; f++) {
            x[f] = add(g, x[f], mul(g, responses[i][f], result.effort[i]));
        }
        for (int r = 0; r < rows; r++) {
            const node more = mul(g, multipliers[i * rows + r], result.effort[i]);
            loops->multipliers[r] = add(g, loops->multipliers[r], more);
        }
    }
    return result;
}

void holds_stop(graph *g, const mechanism *m, node *x)
{
    FOR_ALL (const held_speed, h, m->events.holds, m->events.hold_count) {
        const node is_free = slipping(g, h);
        const node moving = mul(g, is_free, x[h->dof]);
        if (h->against < 0) {
            x[h->dof] = moving;
        } else {
            const node stuck = sub(g, constant(g, 1.0), is_free);
            x[h->dof] = add(g, moving, mul(g, stuck, x[h->against]));
        }
    }
}
