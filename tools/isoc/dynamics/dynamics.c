#include "tools/isoc/dynamics/dynamics.h"

const char *const formulation_names[FORMULATIONS] = {
    "composite", "articulated", "parent_axes", "child_axes", "legs", "legs_in_parent_axes", "legs_in_child_axes"};

bool formulation_is_by_legs(formulation f)
{
    return f >= FORMULATION_LEGS;
}

bool formulation_fits(const mechanism *m, formulation f)
{
    const bool has_holds = m->events.hold_count > 0, is_of_tree = f == FORMULATION_ARTICULATED;
    return f == FORMULATION_COMPOSITE ||
           (is_of_tree == (m->closure_count == 0) && !(has_holds && (is_of_tree || formulation_is_by_legs(f))) &&
            (!formulation_is_by_legs(f) || (m->closure_count > 1 && !m->drift.is_redundant)));
}

static closure_axes axes_of(formulation f)
{
    static const closure_axes axes[FORMULATIONS] = {[FORMULATION_PARENT_AXES] = AXES_OF_PARENT,
                                                    [FORMULATION_CHILD_AXES] = AXES_OF_CHILD,
                                                    [FORMULATION_LEGS_IN_PARENT_AXES] = AXES_OF_PARENT,
                                                    [FORMULATION_LEGS_IN_CHILD_AXES] = AXES_OF_CHILD};
    return axes[f];
}

void efforts_less(const dynamics *d, const node *bias, node *effort)
{
    graph *g = d->g;
    for (int f = 0; f < d->m->dof_count; f++) {
        const segment *l = &d->m->segments[d->m->dofs[f].segment];
        const motion *now = &d->k.motions[d->m->dofs[f].segment];
        effort[f] = l->drive < 0 ? constant(g, 0.0) : leaf(g, OP_INPUT, l->drive);
        effort[f] = sub(g, effort[f], mul(g, l->damping, now->qd[f - l->dof]));
        effort[f] = sub(g, effort[f], mul(g, l->spring, sub(g, now->q[0], l->rest)));
        effort[f] = add(g, effort[f], d->m->effects.efforts[f]);
        for (int i = 0; i < d->m->forces.spring_count; i++) {
            effort[f] = sub(g, effort[f], mul(g, d->springs[i].by_length, d->springs[i].row[f]));
        }
        effort[f] = graph_name(g, sub(g, effort[f], bias[f]), "tau_%s", d->m->dofs[f].name);
    }
}

static void solve_loops(dynamics *d, node *bias, formulation chosen)
{
    graph *g = d->g;
    node *x = d->acceleration;
    bias_build(&d->k, bias, d->accelerations);
    graph_section(g, "Efforts less bias: drives, damping, springs");
    efforts_less(d, bias, x);
    d->mass = mass_matrix_build(&d->k);
    if (formulation_is_by_legs(chosen)) {
        const constraints phi = constraints_build(&d->k, d->accelerations, axes_of(chosen));
        d->mass.is_left = find_shared(&d->mass, &phi);
    }
    mass_matrix_factorise(&d->mass);
    graph_section(g, "Accelerations q'' = L^-1 D^-1 L'^-1 (effort - bias - Phi_q' lambda)");
    mass_matrix_inward(&d->mass, x);
    graph_section(g, "Closures: places, Jacobian Phi_q, and Phi'' at q'' = 0");
    d->loops = augmented_build(&d->mass, constraints_build(&d->k, d->accelerations, axes_of(chosen)), x);
    if (d->m->events.hold_count > 0) {
        d->holds = holds_build(&d->mass, &d->loops, x);
    }
    graph_section(g, "Accelerations outward");
    mass_matrix_outward(&d->mass, x);
    holds_stop(g, d->m, x);
}

/* The bias comes later. */
static void efforts_alone(dynamics *d)
{
    graph_section(d->g, "Efforts: drives, damping, springs");
    efforts_less(d, zero_nodes(d->g, (size_t)d->m->dof_count), d->acceleration);
}

/* The efforts for absolute speeds w: since q_i' = w_i - (+-) w_parent, the effort of i is subtracted from its parent's,
 * with that sign. */
static void efforts_at_absolute(const kinematics *k, node *effort)
{
    const mechanism *m = k->m;
    for (int i = 0; i < m->segment_count; i++) {
        const int f = m->segments[i].dof, before = m->dofs[f].before, shared = shared_axis(k, i);
        if (shared != 0) {
            effort[before] = sub(k->g, effort[before], mul(k->g, constant(k->g, shared), effort[f]));
        }
    }
}

/* q'' of w'. */
static void relative_of_absolute(const kinematics *k, node *x)
{
    const mechanism *m = k->m;
    for (int i = m->segment_count - 1; i >= 0; i--) {
        const int f = m->segments[i].dof, before = m->dofs[f].before, shared = shared_axis(k, i);
        if (shared != 0) {
            const node of_parent = mul(k->g, constant(k->g, shared), x[before]);
            x[f] = sub(k->g, x[f], of_parent);
        }
    }
}

/* Links that turn about parallel axes have absolute speeds: then only the angle between two of them couples their
 * accelerations, not all angles between. With holds the speeds are those of joints. */
static void solve_tree(dynamics *d, node *bias)
{
    graph *g = d->g;
    kinematics absolute = d->k;
    node *x = d->acceleration;
    absolute.absolute = d->m->events.hold_count == 0;
    efforts_alone(d);
    efforts_at_absolute(&absolute, x);
    bias_build(&absolute, bias, d->accelerations);
    graph_section(g, "Efforts less bias");
    for (int f = 0; f < d->m->dof_count; f++) {
        x[f] = graph_name(g, sub(g, x[f], bias[f]), "tau_%s", d->m->dofs[f].name);
    }
    mass_matrix mass = mass_matrix_build(&absolute);
    mass_matrix_factorise(&mass);
    graph_section(g, "Accelerations q'' = L^-1 D^-1 L'^-1 (effort - bias)");
    mass_matrix_inward(&mass, x);
    mass_matrix_scale(&mass, x);
    if (d->m->events.hold_count > 0) {
        d->holds = holds_build(&mass, NULL, x);
    }
    mass_matrix_outward(&mass, x);
    relative_of_absolute(&absolute, x);
    holds_stop(g, d->m, x);
}

int composite_products(const graph *g, const mechanism *m, int most)
{
    graph scratch = graph_copy(g);
    kinematics absolute = kinematics_build(&scratch, m);
    absolute.absolute = true;
    const int products = mass_matrix_products(&absolute, most);
    graph_free(&scratch);
    return products;
}

/* Articulated bodies include the bias. */
static void solve_articulated(dynamics *d, node *bias)
{
    efforts_alone(d);
    articulated_solve(&d->k, d->acceleration);
    bias_build(&d->k, bias, d->accelerations);
}

const dynamics *dynamics_build(graph *g, const mechanism *m, formulation chosen)
{
    const size_t n = (size_t)m->dof_count;
    dynamics *d = arena_take(g->memory, 1, sizeof *d);
    *d = (dynamics){.m = m, .g = g, .k = kinematics_build(g, m)};
    graph_section(g, "Springs between points");
    d->springs = springs_build(&d->k);
    d->acceleration = arena_take(g->memory, n, sizeof *d->acceleration);
    d->accelerations = arena_take(g->memory, (size_t)m->segment_count, sizeof *d->accelerations);
    node *bias = arena_take(g->memory, n, sizeof *bias);
    if (m->closure_count > 0) {
        solve_loops(d, bias, chosen);
    } else if (chosen == FORMULATION_ARTICULATED) {
        solve_articulated(d, bias);
    } else {
        solve_tree(d, bias);
    }
    if (m->closure_count == 0 && ISO_IS_IMPLICIT(m->method.recipe)) {
        d->mass = mass_matrix_build(&d->k); /* for the balance */
    }
    for (size_t f = 0; f < n; f++) {
        graph_name(g, d->acceleration[f], "qdd_%s", m->dofs[f].name);
    }
    return d;
}
