#include "tools/isoc/plant/plant.h"

#include <float.h>
#include <math.h>

void pivots_check(source *s, const graph *g, const plant *p)
{
    static const char *const about[] = {" about its x axis", " about its y axis", " about its z axis"};
    const mechanism *m = p->m;
    const size_t n = (size_t)m->dof_count;
    graph scratch = graph_copy(g);
    const kinematics k = kinematics_build(&scratch, m);
    node *pivots = arena_take(g->memory, n, sizeof *pivots), *inertias = arena_take(g->memory, n, sizeof *inertias);
    articulated_pivots(&k, pivots);
    mass_matrix_diagonal(&k, inertias);
    const double *numbers = numbers_at_start(&scratch, m);
    graph_free(&scratch);
    /* From the tips inward, in the order of the elimination: all pivots after a bad one are bad too. */
    for (int f = m->dof_count - 1; f >= 0; f--) {
        const double pivot = numbers[pivots[f]], inertia = numbers[inertias[f]];
        const segment *l = &m->segments[m->dofs[f].segment];
        if (!(inertia > 0.0) || !(pivot > 1e-10 * inertia)) {
            const bool is_ball = l->kind == JOINT_SPHERICAL;
            source_problem(s, l->at,
                           "the joint '%s' moves no inertia%s at the start (singular mass matrix): give a body beyond "
                           "it an inertia%s",
                           l->name, is_ball ? about[f - l->dof] : "",
                           is_ball ? "" : " or a centre of mass off its axis");
            return;
        }
    }
}

static const char *advice(const plant *p)
{
    return p->is_double ? "" : ": try --real double";
}

static const char *name_of_real(const plant *p)
{
    return p->is_double ? "a double" : "a float";
}

/* A closure is lost by rounding if its pivot is less than an ulp of the number that it was subtracted from. Returns
 * whether there is one, after noting it. */
static bool check_closures(source *s, const plant *p, const double *numbers)
{
    const augmented *loops = &p->d->loops;
    const double ulp = p->is_double ? DBL_EPSILON : (double)FLT_EPSILON;
    for (int i = 0; i < loops->phi.count; i++) {
        const int r = loops->order[i];
        const double pivot = numbers[loops->pivots[r]], diagonal = numbers[loops->diagonal[r]];
        if (!(pivot > ulp * diagonal)) {
            const closure *c = &p->m->closures[loops->phi.all[r].closure];
            source_problem(s, c->at,
                           "%s cannot hold '%s' at the start: its pivot, %.3g, is lost in the rounding of %.3g%s",
                           name_of_real(p), c->name, pivot, diagonal, advice(p));
            return true;
        }
    }
    return false;
}

/* The force of a spring along its ends needs a distance, whose square a float holds. Returns whether one has none,
 * after noting it. */
static bool check_springs(source *s, const graph *g, const plant *p, const double *numbers)
{
    bool met = false;
    for (int i = 0; i < p->m->forces.spring_count; i++) {
        const point_spring *spring = &p->m->forces.springs[i];
        const bool is_direct = is_zero(g, spring->length) && is_zero(g, spring->damping);
        if (!is_direct && numbers[p->d->springs[i].square] < (double)FLT_MIN) {
            source_problem(s, spring->at, "the ends of '%s' meet at the start, where it has no direction",
                           spring->name);
            met = true;
        }
    }
    return met;
}

/* The first node that a root needs and that is not finite, though its operands are. */
static node first_fault(const graph *g, node root, const double *numbers)
{
    node first = root;
    for (reached r = reach(g, &root, 1); reach_next(&r);) {
        first = first == root && !isfinite(numbers[r.at]) ? r.at : first;
    }
    return first;
}

/* The tunable that a divisor which is zero depends on, one that is zero before any other; -1 if there is none. */
static int tunable_of(const graph *g, const plant *p, node divisor)
{
    int found = -1;
    for (reached r = reach(g, &divisor, 1); reach_next(&r);) {
        if (r.n->op == OP_PARAMETER && (found < 0 || p->m->parameters.at_start[r.n->index] == 0.0)) {
            found = r.n->index;
        }
    }
    return found;
}

/* Why a root is not finite, with advice: a division by zero, or a number beyond the range of a float. */
static const char *reason(const graph *g, const plant *p, const evaluation *at, node root, double *numbers)
{
    const graph_node *n = &g->nodes[first_fault(g, root, numbers)];
    if (n->op == OP_DIV && numbers[n->b] == 0.0) {
        const int tunable = tunable_of(g, p, n->b);
        return tunable < 0 ? ": a division by what is zero at the start"
                           : arena_format(g->memory, ": a division by zero, as the tunable '%s' is %g",
                                          p->m->parameters.all[tunable].name, p->m->parameters.at_start[tunable]);
    }
    evaluation exact = *at;
    exact.rounds_to_float = false;
    graph_evaluate(g, 0, &exact, numbers);
    return isfinite(numbers[root]) ? advice(p) : "";
}

/* The derivative, in the order in which it is emitted. */
static void check_derivative(source *s, const graph *original, const plant *p, const evaluation *at)
{
    const mechanism *m = p->m;
    const size_t states = (size_t)state_count(m);
    node *roots = arena_take(original->memory, states, sizeof *roots);
    graph economical = economise(original, p->derivatives, states, roots), *g = &economical;
    double *numbers = arena_take(g->memory, g->count, sizeof *numbers);
    graph_evaluate(g, 0, at, numbers);
    for (int f = 0; f < m->dof_count; f++) {
        const node root = roots[m->position_count + f];
        const double derivative = numbers[root];
        if (!isfinite(derivative)) {
            source_problem(s, m->segments[m->dofs[f].segment].at, "the acceleration of '%s' at the start is %s in %s%s",
                           m->dofs[f].name, isnan(derivative) ? "no number" : "infinite", name_of_real(p),
                           reason(g, p, at, root, numbers));
            break;
        }
    }
    arena_return(g->memory, numbers, g->count, sizeof *numbers);
    graph_free(g);
}

void start_check(source *s, const graph *g, const plant *p)
{
    evaluation at = start_of(g, p->m);
    at.rounds_to_float = !p->is_double;
    double *numbers = arena_take(g->memory, g->count, sizeof *numbers);
    graph_evaluate(g, 0, &at, numbers);
    if (!check_springs(s, g, p, numbers) && !check_closures(s, p, numbers)) {
        check_derivative(s, g, p, &at);
    }
    arena_return(g->memory, numbers, g->count, sizeof *numbers);
}
