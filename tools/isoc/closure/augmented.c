#include "tools/isoc/closure/closure.h"

#include <float.h>
#include <math.h>
#include <string.h>

/* The constraint with the fewest neighbours first (Tinney and Walker 1967, scheme 2), counting the fill of each
 * elimination. */
static void choose_order(graph *g, const node *schur, int n, int *order)
{
    bool *linked = arena_take(g->memory, (size_t)(n * n), sizeof *linked);
    bool *done = arena_take(g->memory, (size_t)n, sizeof *done);
    for (int i = 0; i < n * n; i++) {
        linked[i] = !is_zero(g, schur[i]);
    }
    for (int next = 0; next < n; next++) {
        int best = -1, fewest = n + 1;
        for (int i = 0; i < n; i++) {
            int neighbours = 0;
            for (int j = 0; j < n; j++) {
                neighbours += !done[j] && linked[i * n + j];
            }
            if (!done[i] && neighbours < fewest) {
                best = i;
                fewest = neighbours;
            }
        }
        done[best] = true;
        order[next] = best;
        for (int i = 0; i < n; i++) {
            for (int j = 0; j < n; j++) {
                linked[i * n + j] = linked[i * n + j] || (linked[best * n + i] && linked[best * n + j]);
            }
        }
    }
}

/* A + e = L D L' in place, in the chosen order; 1 / D on the diagonal. */
static void factorise(augmented *a, const mechanism *m)
{
    graph *g = a->mass->k->g;
    const int n = a->phi.count;
    node *at = a->schur;
    graph_section(g, "Factorisation of the Schur complement, L D L'");
    for (int s = 0; s < n; s++) {
        const int k = a->order[s];
        a->pivots[k] = graph_name(g, at[k * n + k], "pivot_%s_%d", m->closures[a->phi.all[k].closure].name, k);
        at[k * n + k] = divide(g, constant(g, 1.0), a->pivots[k]);
        for (int t = s + 1; t < n; t++) {
            const int i = a->order[t];
            if (is_zero(g, at[i * n + k])) {
                continue;
            }
            const node factor = mul(g, at[i * n + k], at[k * n + k]);
            for (int v = s + 1; v <= t; v++) {
                const int j = a->order[v];
                at[i * n + j] = sub(g, at[i * n + j], mul(g, factor, at[j * n + k]));
            }
        }
        /* Column k becomes the factors only now, since the rows below needed its entries. */
        for (int t = s + 1; t < n; t++) {
            const int i = a->order[t];
            at[i * n + k] = mul(g, at[i * n + k], at[k * n + k]);
        }
    }
}

/* x := (A + e)^-1 x */
static void solve(const augmented *a, node *x)
{
    graph *g = a->mass->k->g;
    const int n = a->phi.count;
    for (int s = 0; s < n; s++) {
        const int k = a->order[s];
        for (int t = s + 1; t < n; t++) {
            const int i = a->order[t];
            x[i] = sub(g, x[i], mul(g, a->schur[i * n + k], x[k]));
        }
    }
    for (int s = n - 1; s >= 0; s--) {
        const int k = a->order[s];
        x[k] = mul(g, x[k], a->schur[k * n + k]);
        for (int t = s + 1; t < n; t++) {
            const int i = a->order[t];
            x[k] = sub(g, x[k], mul(g, a->schur[i * n + k], x[i]));
        }
    }
}

/* A = (L'^-1 Phi_q')' D^-1 (L'^-1 Phi_q'). */
static void build_schur(augmented *a)
{
    const mass_matrix *mass = a->mass;
    graph *g = mass->k->g;
    const int n = a->phi.count;
    graph_section(g, "Schur complement A = Phi_q M^-1 Phi_q'");
    for (int r = 0; r < n; r++) {
        a->inward[r] = arena_take(g->memory, (size_t)mass->n, sizeof **a->inward);
        a->reach[r] = arena_take(g->memory, (size_t)mass->n, sizeof **a->reach);
        memcpy(a->inward[r], a->phi.all[r].row, (size_t)mass->n * sizeof **a->inward);
        mass_matrix_inward(mass, a->inward[r]);
        for (int f = 0; f < mass->n; f++) {
            a->reach[r][f] = mul(g, a->inward[r][f], mass->inverse[f]);
        }
    }
    for (int r = 0; r < n; r++) {
        for (int s = 0; s <= r; s++) {
            node sum = constant(g, 0.0);
            for (int f = 0; f < mass->n; f++) {
                sum = add(g, sum, mul(g, a->inward[r][f], a->reach[s][f]));
            }
            a->schur[r * n + s] = a->schur[s * n + r] = sum;
        }
    }
}

/* e: 1 / penalty, or as the rounding asks for. */
static double regularisation(const augmented *a)
{
    const mechanism *m = a->mass->k->m;
    graph *g = a->mass->k->g;
    if (!m->drift.is_redundant || m->drift.penalty > 0.0) {
        return m->drift.is_redundant ? 1.0 / m->drift.penalty : 0.0;
    }
    const double *numbers = numbers_at_start(g, m);
    double sum = 0.0;
    for (int r = 0; r < a->phi.count; r++) {
        note_built_in(g, m, &a->schur[r * a->phi.count + r], 1);
        sum += numbers[a->schur[r * a->phi.count + r]];
    }
    return sum / a->phi.count * sqrt(0.5 * (m->is_double ? DBL_EPSILON : (double)FLT_EPSILON));
}

node demand_of(graph *g, const mechanism *m, const constraint *c)
{
    const bool in_speed = is_zero(g, c->position);
    const node damping = constant(g, in_speed ? m->drift.alpha : 2.0 * m->drift.alpha);
    const node square_beta = constant(g, m->drift.beta * m->drift.beta);
    const node damped = mul(g, damping, c->rate), drawn = mul(g, square_beta, c->position);
    return add(g, c->bias, add(g, damped, drawn));
}

/* Phi_q M^-1 (effort - bias) - gamma, from D^-1 L'^-1 (effort - bias). */
static void build_demand(const augmented *a, const node *scaled, node *demand)
{
    graph *g = a->mass->k->g;
    graph_section(g, "What the closures demand");
    for (int r = 0; r < a->phi.count; r++) {
        demand[r] = demand_of(g, a->mass->k->m, &a->phi.all[r]);
        for (int f = 0; f < a->mass->n; f++) {
            demand[r] = add(g, demand[r], mul(g, a->inward[r][f], scaled[f]));
        }
    }
}

augmented augmented_factors(const mass_matrix *mass, constraints phi)
{
    graph *g = mass->k->g;
    const int n = phi.count;
    augmented a = {.mass = mass, .phi = phi};
    a.order = arena_take(g->memory, (size_t)n, sizeof *a.order);
    a.inward = arena_take(g->memory, (size_t)n, sizeof *a.inward);
    a.reach = arena_take(g->memory, (size_t)n, sizeof *a.reach);
    a.schur = arena_take(g->memory, (size_t)(n * n), sizeof *a.schur);
    a.pivots = arena_take(g->memory, (size_t)n, sizeof *a.pivots);
    a.diagonal = arena_take(g->memory, (size_t)n, sizeof *a.diagonal);
    build_schur(&a);
    const node e = a.regularisation = constant(g, regularisation(&a));
    for (int r = 0; r < n; r++) {
        a.schur[r * n + r] = a.diagonal[r] = add(g, a.schur[r * n + r], e);
    }
    choose_order(g, a.schur, n, a.order);
    factorise(&a, mass->k->m);
    return a;
}

augmented augmented_build(const mass_matrix *mass, constraints phi, node *effort)
{
    const mechanism *m = mass->k->m;
    graph *g = mass->k->g;
    const int n = phi.count;
    augmented a = augmented_factors(mass, phi);
    const node e = a.regularisation;
    a.multipliers = arena_take(g->memory, (size_t)n, sizeof *a.multipliers);
    node *delta = arena_take(g->memory, (size_t)n, sizeof *delta);
    graph_section(g, "Efforts less bias, over the pivots");
    for (int f = 0; f < mass->n; f++) {
        effort[f] = mul(g, effort[f], mass->inverse[f]);
    }
    build_demand(&a, effort, delta);

    graph_section(g, "Multipliers lambda");
    for (int r = 0; r < n; r++) {
        a.multipliers[r] = constant(g, 0.0);
    }
    for (int i = 0; i < m->drift.multiplier_iterations; i++) {
        solve(&a, delta);
        for (int r = 0; r < n; r++) {
            a.multipliers[r] = add(g, a.multipliers[r], delta[r]);
            delta[r] = mul(g, e, delta[r]);
        }
    }
    for (int r = 0; r < n; r++) {
        graph_name(g, a.multipliers[r], "lambda_%s_%d", m->closures[phi.all[r].closure].name, r);
    }

    graph_section(g, "Efforts less bias and multipliers, over the pivots");
    for (int f = 0; f < mass->n; f++) {
        for (int r = 0; r < n; r++) {
            effort[f] = sub(g, effort[f], mul(g, a.reach[r][f], a.multipliers[r]));
        }
    }
    return a;
}

void augmented_project(const augmented *a, const node *gap, node *change)
{
    graph *g = a->mass->k->g;
    const int n = a->phi.count;
    node *x = arena_take(g->memory, (size_t)n, sizeof *x);
    memcpy(x, gap, (size_t)n * sizeof *x);
    solve(a, x);
    for (int f = 0; f < a->mass->n; f++) {
        change[f] = constant(g, 0.0);
        for (int r = 0; r < n; r++) {
            change[f] = sub(g, change[f], mul(g, a->reach[r][f], x[r]));
        }
    }
    mass_matrix_outward(a->mass, change);
}
