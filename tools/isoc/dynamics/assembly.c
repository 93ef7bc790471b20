#include "tools/isoc/dynamics/dynamics.h"

#include <math.h>
#include <string.h>

static const double closed_as_given =
    1e-6;                          /* m, rad, and per second: the gap that the digits of given values may leave */
static const double exact = 1e-10; /* the bound of rounding */

typedef struct assembly {
    source *s;
    const mechanism *m;
    const constraints *phi;
    closing c;
    bool *is_free;    /* [degrees of freedom] */
    bool *meets;      /* likewise: takes part in a multiple root */
    bool keeps_rough; /* coordinates with a rough start are not free */
} assembly;

/* The joints, or their parts, with free coordinates, for a message. */
static const char *list_free(const assembly *a)
{
    const char *list = "";
    FOR_ALL (const segment, l, a->m->segments, a->m->segment_count) {
        bool any = false;
        for (int f = l->dof; f < l->dof + dofs_of(l->kind); f++) {
            any = any || a->is_free[f];
        }
        if (any) {
            list = arena_format(a->s->memory, "%s%s%s", list, list[0] == '\0' ? "" : ", ", l->name);
        }
    }
    return list;
}

/* Chooses the degrees of freedom that closures depend on: all of them, or those without a start. Returns how many. */
static int choose_free(const assembly *a, bool rates, bool all)
{
    int count = 0;
    for (int f = 0; f < a->m->dof_count; f++) {
        const segment *l = &a->m->segments[a->m->dofs[f].segment];
        const bool has_start =
            rates ? l->origin.speed_given : l->origin.start_given || (l->origin.start_is_rough && a->keeps_rough);
        a->is_free[f] = false;
        for (int r = 0; r < a->phi->count && (all || !has_start); r++) {
            const bool feels = closing_counts(&a->c, rates, r) && !is_zero(a->c.d->g, a->phi->all[r].row[f]);
            a->is_free[f] = a->is_free[f] || feels;
        }
        count += a->is_free[f];
    }
    return count;
}

static const closure *closure_of(const assembly *a, gap open)
{
    return &a->m->closures[a->phi->all[open.row].closure];
}

/* The unit of a constraint: of axes an angle, of joints that of their coordinate. */
static const char *unit_of(const assembly *a, gap open)
{
    const graph *g = a->c.d->g;
    const closure *at = closure_of(a, open);
    const vector force = a->phi->all[open.row].force;
    const bool is_length = acts_along_joints(at->kind)
                               ? slides(&a->m->segments[at->parent.segment])
                               : !is_zero(g, force.at[0]) || !is_zero(g, force.at[1]) || !is_zero(g, force.at[2]);
    return is_length ? "m" : "rad";
}

static void tell_open(const assembly *a, gap open, int count)
{
    const char *list = list_free(a);
    choose_free(a, false, true);
    const bool would_close = closing_search(&a->c, a->is_free, closed_as_given).size <= closed_as_given;
    source_problem(a->s, closure_of(a, open)->at,
                   "'%s' cannot close: a gap of %.3g %s remains; the constraints have rank %d of %d in the coordinates "
                   "without a start: %s%s",
                   closure_of(a, open)->name, open.size, unit_of(a, open), open.rank, open.all,
                   count == 0 ? "none" : list, would_close ? "; it closes without the given starts" : "");
}

/* Moves the other coordinates to close the loops as far as possible while rough starts are kept; so the nearest
 * solution is found. */
static void go_near(assembly *a)
{
    for (int i = 0; i < a->m->segment_count; i++) {
        a->keeps_rough = a->keeps_rough || a->m->segments[i].origin.start_is_rough;
    }
    if (a->keeps_rough && choose_free(a, false, false) > 0) {
        (void)closing_search(&a->c, a->is_free, closed_as_given);
    }
    a->keeps_rough = false;
}

static bool close_positions(const assembly *a)
{
    const int count = choose_free(a, false, false);
    const gap open = closing_search(&a->c, a->is_free, closed_as_given);
    if (!(open.size <= closed_as_given)) {
        tell_open(a, open, count);
        return false;
    }
    const int undetermined = branches_look(&a->c, a->is_free, a->meets);
    if (undetermined > 0) {
        return source_problem(
            a->s, closure_of(a, open)->at,
            "the closures leave %d of %d coordinates undetermined (rank %d): give a start to %d of %s", undetermined,
            count, open.rank, undetermined, list_free(a));
    }
    choose_free(a, false, true);
    const gap left = closing_run(&a->c, false, a->is_free);
    if (!(left.size <= exact)) {
        return source_problem(
            a->s, closure_of(a, left)->at,
            "'%s' contradicts the other closures: a gap of %.3g %s remains; the constraints have rank %d of %d",
            closure_of(a, left)->name, left.size, unit_of(a, left), left.rank, left.all);
    }
    return true;
}

static bool close_speeds(const assembly *a)
{
    choose_free(a, true, false);
    const gap open = closing_run(&a->c, true, a->is_free);
    if (!(open.size <= closed_as_given)) {
        return source_problem(
            a->s, closure_of(a, open)->at,
            "the speeds at the start violate '%s' by %.3g %s/s: leave out those that follow from the others",
            closure_of(a, open)->name, open.size, unit_of(a, open));
    }
    choose_free(a, true, true);
    const gap left = closing_run(&a->c, true, a->is_free);
    if (left.rank == left.all || a->m->drift.is_redundant) {
        return true;
    }
    const place at = a->m->closures[a->phi->all[a->phi->count - 1].closure].at;
    const int nearby = branches_rank_nearby(&a->c);
    if (nearby == left.all) {
        source_problem(a->s, at,
                       "the closures do not determine how the loops move on: ways to move meet at the start, where the "
                       "constraints have rank %d, and %d beside it; start beside it, or write stabilisation lagrangian",
                       left.rank, nearby);
    } else {
        source_problem(a->s, at,
                       "the closures are redundant: their constraints have rank %d of %d at the start; leave out the "
                       "redundant ones, or write stabilisation lagrangian",
                       left.rank, left.all);
    }
    return false;
}

/* A constraint that no joint changes, as out of the plane of a planar mechanism, must hold as it is. */
static bool check_dropped(const assembly *a)
{
    FOR_ALL (const constraint, c, a->phi->dropped, a->phi->dropped_count) {
        const double off = fabs(a->c.numbers[c->position]);
        if (!(off <= closed_as_given)) {
            return source_problem(a->s, a->m->closures[c->closure].at,
                                  "'%s' cannot close: a gap of %.3g (m or rad) remains that no joint can close",
                                  a->m->closures[c->closure].name, off);
        }
    }
    return true;
}

/* A distance without a length has that of the start, which must not be zero. */
static bool check_distances(const assembly *a)
{
    FOR_ALL (const constraint, c, a->phi->all, a->phi->count) {
        if (a->m->closures[c->closure].kind == CLOSE_DISTANCE && !(a->c.numbers[c->length] > closed_as_given)) {
            return source_problem(
                a->s, a->m->closures[c->closure].at,
                "the points of '%s' coincide at the start: write a length, as in length 1 m, or a start at "
                "which they are apart",
                a->m->closures[c->closure].name);
        }
    }
    return true;
}

/* A disc stands on its plane, above it. */
static bool check_discs(const assembly *a)
{
    FOR_ALL (const constraint, c, a->phi->all, a->phi->count) {
        const closure *at = &a->m->closures[c->closure];
        if (at->is_disc && !is_zero(a->c.d->g, c->position) && !(a->c.numbers[c->length] > closed_as_given)) {
            return source_problem(a->s, at->at, "the disc of '%s' lies flat on its plane at the start, or is below it",
                                  at->name);
        }
    }
    return true;
}

static double largest_change(const double *from, const double *to, int count)
{
    double largest = 0.0;
    for (int n = 0; n < count; n++) {
        largest = fmax(largest, fabs(to[n] - from[n]));
    }
    return largest;
}

static void keep_start(const assembly *a)
{
    FOR_ALL (segment, l, a->m->segments, a->m->segment_count) {
        const double *x = a->c.x + l->position;
        const double *speed = a->c.x + a->m->position_count + l->dof;
        for (int f = l->dof; f < l->dof + dofs_of(l->kind); f++) {
            l->origin.start_meets = l->origin.start_meets || a->meets[f];
        }
        l->origin.start_found = largest_change(l->start, x, positions_of(l->kind)) > closed_as_given;
        l->origin.speed_found = largest_change(l->speed, speed, dofs_of(l->kind)) > closed_as_given;
        memcpy(l->start, x, (size_t)positions_of(l->kind) * sizeof *x);
        memcpy(l->speed, speed, (size_t)dofs_of(l->kind) * sizeof *x);
    }
}

void assemble(source *s, const graph *g, const mechanism *m)
{
    if (m->closure_count == 0) {
        return;
    }
    graph scratch = graph_copy(g);
    const dynamics *d =
        dynamics_build(&scratch, m, FORMULATION_COMPOSITE); /* in the axes of the base, whatever is kept */
    assembly a = {.s = s, .m = m, .phi = &d->loops.phi, .c = closing_start(s->memory, d)};
    a.is_free = arena_take(s->memory, (size_t)m->dof_count, sizeof *a.is_free);
    a.meets = arena_take(s->memory, (size_t)m->dof_count, sizeof *a.meets);
    go_near(&a);
    if (check_distances(&a) && check_dropped(&a) && close_positions(&a) && check_discs(&a) && close_speeds(&a)) {
        keep_start(&a);
    }
    graph_free(&scratch);
}
