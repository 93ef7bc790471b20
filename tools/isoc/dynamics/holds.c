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

/* row' D^-1 x */
static node product_over_pivots(const mass_matrix *mass, const node *row, const node *x)
{
    graph *g = mass->k->g;
    node sum = constant(g, 0.0);
    for (int f = 0; f < mass->n; f++) {
        const node part = mul(g, row[f], mass->inverse[f]);
        sum = add(g, sum, mul(g, part, x[f]));
    }
    return sum;
}

/* The share of a mobility below which what is left of it is rounding: other holds hold this one already. That of
 * ISO_HOLD_ROUNDING in core/methods/hold.h. */
static double rounding_of(const mechanism *m)
{
    return 64.0 * (m->is_double ? DBL_EPSILON : (double)FLT_EPSILON);
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

hold_equations holds_build(const mass_matrix *mass, node *x)
{
    graph *g = mass->k->g;
    const mechanism *m = mass->k->m;
    const int n = m->events.hold_count;
    const held_speed *all = m->events.holds;
    hold_equations result = {.free = zero_nodes(g, (size_t)n),
                             .mobility = zero_nodes(g, (size_t)(n * n)),
                             .effort = zero_nodes(g, (size_t)n)};
    node **rows = arena_take(g->memory, (size_t)n, sizeof *rows);
    node *sliding = arena_take(g->memory, (size_t)n, sizeof *sliding), *right = zero_nodes(g, (size_t)n);
    graph_section(g, "Holds: mobility of their speeds, and accelerations without holds");
    for (int i = 0; i < n; i++) {
        rows[i] = row_inward(mass, &all[i]);
        result.free[i] = product_over_pivots(mass, rows[i], x);
        for (int j = 0; j <= i; j++) {
            result.mobility[i * n + j] = result.mobility[j * n + i] = product_over_pivots(mass, rows[i], rows[j]);
        }
    }
    graph_section(g, "Efforts of holds");
    for (int i = 0; i < n; i++) {
        const node mode = leaf(g, OP_STATE, all[i].state);
        sliding[i] = neg(g, mul(g, mode, all[i].sliding));
    }
    for (int i = 0; i < n; i++) {
        const node stuck = sub(g, constant(g, 1.0), slipping(g, &all[i]));
        node sum = result.free[i];
        for (int j = 0; j < n; j++) {
            sum = add(g, sum, mul(g, result.mobility[i * n + j], sliding[j]));
        }
        right[i] = neg(g, mul(g, stuck, sum));
    }
    solve_stuck(m, g, result.mobility, right);
    for (int i = 0; i < n; i++) {
        result.effort[i] = graph_name(g, add(g, sliding[i], right[i]), "effort_%s", all[i].called);
        for (int f = 0; f < mass->n; f++) {
            x[f] = add(g, x[f], mul(g, rows[i][f], result.effort[i]));
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
