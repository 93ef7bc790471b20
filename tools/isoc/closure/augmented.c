#include "tools/isoc/closure/closure.h"

#include <float.h>
#include <math.h>
#include <string.h>

/* The constraint with the fewest neighbours first (Tinney and Walker 1967, scheme 2), counting the fill of each
 * elimination; then the shared degrees of freedom, likewise. */
static void choose_order(augmented *a)
{
    graph *g = a->mass->k->g;
    const int n = a->size;
    bool *linked = arena_take(g->memory, (size_t)(n * n), sizeof *linked);
    bool *done = arena_take(g->memory, (size_t)n, sizeof *done);
    for (int i = 0; i < n * n; i++) {
        linked[i] = !is_zero(g, a->schur[i]);
    }
    for (int next = 0; next < n; next++) {
        const int end = next < a->phi.count ? a->phi.count : n;
        int best = -1, fewest = n + 1;
        for (int i = 0; i < end; i++) {
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
        a->order[next] = best;
        for (int i = 0; i < n; i++) {
            for (int j = 0; j < n; j++) {
                linked[i * n + j] = linked[i * n + j] || (linked[best * n + i] && linked[best * n + j]);
            }
        }
    }
}

static node name_pivot(const augmented *a, int k)
{
    const mechanism *m = a->mass->k->m;
    graph *g = a->mass->k->g;
    const node pivot = a->schur[k * a->size + k];
    if (k < a->phi.count && a->phi.all[k].closure < 0) {
        return graph_name(g, pivot, "pivot_impulse_%d", k);
    }
    return k < a->phi.count ? graph_name(g, pivot, "pivot_%s_%d", m->closures[a->phi.all[k].closure].name, k)
                            : graph_name(g, pivot, "pivot_%s", m->dofs[a->shared[k - a->phi.count]].name);
}

/* The square root of the unit roundoff. */
static double root_of_roundoff(const mechanism *m)
{
    return sqrt(0.5 * (m->is_double ? DBL_EPSILON : (double)FLT_EPSILON));
}

/* [constraints] the lower bound of each pivot: for legs by tools/isoc/closure/legs.c; where the energy is held through
 * singular positions, above the rounding of A at the start, so that the speeds stay finite there. */
static double *bounds_of_pivots(const augmented *a)
{
    enum { ROUNDINGS = 64 };
    const mechanism *m = a->mass->k->m;
    const double *numbers = numbers_at_start(a->mass->k->g, m);
    const double root = root_of_roundoff(m);
    double *result = least_pivots(a, numbers, 4.0 * root);
    for (int r = 0; r < a->phi.count && m->drift.near_holds && !m->drift.is_redundant; r++) {
        result[r] = fmax(result[r], (double)ROUNDINGS * root * root * numbers[a->diagonal[r]]);
    }
    return result;
}

/* A + e = L D L' in place, in the chosen order; 1 / D on the diagonal. */
static void factorise(augmented *a)
{
    graph *g = a->mass->k->g;
    const int n = a->size;
    node *at = a->schur;
    const double *least = bounds_of_pivots(a);
    graph_section(g, "Factorisation of the Schur complement, L D L'");
    for (int s = 0; s < n; s++) {
        const int k = a->order[s];
        a->pivots[k] = name_pivot(a, k);
        const bool is_bounded = k < a->phi.count && least[k] > 0.0;
        const node bounded = is_bounded ? larger(g, a->pivots[k], constant(g, least[k])) : a->pivots[k];
        at[k * n + k] = divide(g, constant(g, 1.0), bounded);
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
    const int n = a->size;
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

/* L'^-1 Phi_q', and that over the pivots. */
static void build_rows(augmented *a)
{
    const mass_matrix *mass = a->mass;
    graph *g = mass->k->g;
    for (int r = 0; r < a->phi.count; r++) {
        a->inward[r] = list_copy(g->memory, a->phi.all[r].row, (size_t)mass->n, sizeof **a->inward);
        a->reach[r] = arena_take(g->memory, (size_t)mass->n, sizeof **a->reach);
        mass_matrix_inward(mass, a->inward[r]);
        for (int f = 0; f < mass->n; f++) {
            a->reach[r][f] = mul(g, a->inward[r][f], mass->inverse[f]);
        }
    }
}

/* A = (L'^-1 Phi_q')' D^-1 (L'^-1 Phi_q'), over the degrees of freedom that are not shared; beside it the columns of
 * those that are, and -M. */
static void build_schur(augmented *a)
{
    const mass_matrix *mass = a->mass;
    graph *g = mass->k->g;
    const int n = a->size, rows = a->phi.count;
    for (int r = 0; r < rows; r++) {
        for (int s = 0; s <= r; s++) {
            node sum = constant(g, 0.0);
            for (int f = 0; f < mass->n; f++) {
                sum = add(g, sum, mul(g, a->inward[r][f], a->reach[s][f]));
            }
            a->schur[r * n + s] = a->schur[s * n + r] = sum;
        }
    }
    for (int i = rows; i < n; i++) {
        const int f = a->shared[i - rows];
        for (int r = 0; r < rows; r++) {
            a->schur[i * n + r] = a->schur[r * n + i] = a->inward[r][f];
        }
        for (int j = rows; j <= i; j++) {
            a->schur[i * n + j] = a->schur[j * n + i] = neg(g, mass_matrix_left(mass, f, a->shared[j - rows]));
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
        note_built_in(g, m, &a->schur[r * a->size + r], 1);
        sum += numbers[a->schur[r * a->size + r]];
    }
    return sum / a->phi.count * root_of_roundoff(m);
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
    augmented a = {.mass = mass, .phi = phi, .size = phi.count};
    a.shared = arena_take(g->memory, (size_t)mass->n + 1, sizeof *a.shared);
    for (int f = 0; f < mass->n; f++) {
        if (mass->is_left != NULL && mass->is_left[f]) {
            a.shared[a.size++ - phi.count] = f;
        }
    }
    const int n = a.size;
    a.order = arena_take(g->memory, (size_t)n, sizeof *a.order);
    a.inward = arena_take(g->memory, (size_t)n, sizeof *a.inward);
    a.reach = arena_take(g->memory, (size_t)n, sizeof *a.reach);
    a.schur = arena_take(g->memory, (size_t)(n * n), sizeof *a.schur);
    a.pivots = arena_take(g->memory, (size_t)n, sizeof *a.pivots);
    a.diagonal = arena_take(g->memory, (size_t)n, sizeof *a.diagonal);
    graph_section(g, "Schur complement A = Phi_q M^-1 Phi_q'");
    build_rows(&a);
    build_schur(&a);
    const node e = a.regularisation = constant(g, regularisation(&a));
    for (int r = 0; r < phi.count; r++) {
        a.schur[r * n + r] = a.diagonal[r] = add(g, a.schur[r * n + r], e);
    }
    a.unfactored = list_copy(g->memory, a.schur, (size_t)(n * n), sizeof *a.schur);
    choose_order(&a);
    factorise(&a);
    return a;
}

/* x := (A + e)^-1 x; where legs have knees, refined once by the solution for the residual. */
static void solve_refined(const augmented *a, node *x)
{
    graph *g = a->mass->k->g;
    const int n = a->size;
    node *residual = list_copy(g->memory, x, (size_t)n, sizeof *x);
    solve(a, x);
    if (n > a->phi.count && have_knees(a->mass)) {
        for (int i = 0; i < n; i++) {
            for (int j = 0; j < n; j++) {
                residual[i] = sub(g, residual[i], mul(g, a->unfactored[i * n + j], x[j]));
            }
        }
        solve(a, residual);
        for (int i = 0; i < n; i++) {
            x[i] = add(g, x[i], residual[i]);
        }
    }
}

/* multipliers += those of this right side, right[size], which becomes that of the last iteration. */
static void add_multipliers(const augmented *a, node *right, node *multipliers)
{
    graph *g = a->mass->k->g;
    for (int i = 0; i < a->mass->k->m->drift.multiplier_iterations; i++) {
        solve_refined(a, right);
        for (int r = 0; r < a->phi.count; r++) {
            multipliers[r] = add(g, multipliers[r], right[r]);
            right[r] = mul(g, a->regularisation, right[r]);
        }
    }
}

/* lambda of A lambda = demand. Where degrees of freedom are shared, right[size] has their efforts behind the demands,
 * and becomes -q'' there. */
static void solve_multipliers(augmented *a, node *right)
{
    const mechanism *m = a->mass->k->m;
    graph *g = a->mass->k->g;
    const int rows = a->phi.count;
    graph_section(g, "Multipliers lambda");
    a->multipliers = zero_nodes(g, (size_t)rows);
    add_multipliers(a, right, a->multipliers);
    for (int r = 0; r < rows; r++) {
        graph_name(g, a->multipliers[r], "lambda_%s_%d", m->closures[a->phi.all[r].closure].name, r);
    }
}

/* Takes D^-1 L'^-1 Phi_q' x from change[degrees of freedom]; of the shared ones it becomes -shared. */
static void follow(const augmented *a, const node *x, const node *shared, node *change)
{
    graph *g = a->mass->k->g;
    for (int f = 0; f < a->mass->n; f++) {
        for (int r = 0; r < a->phi.count; r++) {
            change[f] = sub(g, change[f], mul(g, a->reach[r][f], x[r]));
        }
    }
    for (int i = a->phi.count; i < a->size; i++) {
        change[a->shared[i - a->phi.count]] = neg(g, shared[i]);
    }
}

augmented augmented_build(const mass_matrix *mass, constraints phi, node *effort)
{
    graph *g = mass->k->g;
    augmented a = augmented_factors(mass, phi);
    node *right = arena_take(g->memory, (size_t)a.size, sizeof *right);
    graph_section(g, "Efforts less bias, over the pivots");
    for (int i = phi.count; i < a.size; i++) {
        right[i] = effort[a.shared[i - phi.count]];
    }
    for (int f = 0; f < mass->n; f++) {
        effort[f] = mul(g, effort[f], mass->inverse[f]);
    }
    build_demand(&a, effort, right);
    solve_multipliers(&a, right);
    graph_section(g, "Efforts less bias and multipliers, over the pivots");
    follow(&a, a.multipliers, right, effort);
    return a;
}

void augmented_respond(const augmented *a, node *scaled, node *multipliers)
{
    graph *g = a->mass->k->g;
    node *right = zero_nodes(g, (size_t)a->size);
    for (int r = 0; r < a->phi.count; r++) {
        for (int f = 0; f < a->mass->n; f++) {
            right[r] = add(g, right[r], mul(g, a->inward[r][f], scaled[f]));
        }
    }
    add_multipliers(a, right, multipliers);
    follow(a, multipliers, right, scaled);
}

node *augmented_project(const augmented *a, const node *gap)
{
    graph *g = a->mass->k->g;
    node *x = zero_nodes(g, (size_t)a->size), *change = zero_nodes(g, (size_t)a->mass->n);
    memcpy(x, gap, (size_t)a->phi.count * sizeof *x);
    solve(a, x);
    follow(a, x, x, change);
    mass_matrix_outward(a->mass, change);
    return change;
}

node augmented_inverse_determinant(const augmented *a)
{
    graph *g = a->mass->k->g;
    const double *numbers = numbers_at_start(g, a->mass->k->m);
    node result = constant(g, 1.0);
    for (int s = 0; s < a->size; s++) {
        const node inverse = a->schur[a->order[s] * a->size + a->order[s]];
        result = mul(g, result, mul(g, constant(g, 1.0 / numbers[inverse]), inverse));
    }
    return result;
}
