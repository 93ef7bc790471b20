#include "tools/isoc/stability/stability.h"

#include <math.h>

enum { MOST_STATES = 60 };

/* Where the Jacobian is evaluated. */
typedef struct point {
    const char *when;
    double *x, *u;
} point;

/* The modes of the mechanism without some of its causes. */
static modes modes_without(const graph *g, const mechanism *m, formulation kept, const bool *gone, const point *at)
{
    graph copy = graph_copy(g);
    mechanism *less = list_copy(g->memory, m, 1, sizeof *m);
    node *derivatives = arena_take(g->memory, (size_t)state_count(m) + 1, sizeof *derivatives);
    for (int i = 0; i < cause_count(m); i++) {
        if (gone[i]) {
            *less = without_cause(less, &copy, i);
        }
    }
    derivatives_build(&copy, less, kept, derivatives);
    linearised l = linearise(&copy, less, derivatives, (size_t)state_count(m));
    const modes result = modes_of(g->memory, slopes_at(&l, at->x, at->u));
    graph_free(&l.g);
    graph_free(&copy);
    return result;
}

/* A measure of bad modes: the number that grow by the method; or the rate of the fastest drift. */
typedef double badness(const modes *all, const mechanism *m);

static double growing(const modes *all, const mechanism *m)
{
    int fastest;
    return count_growing(all, m->method.recipe, method_step(m), &fastest);
}

static double drifting(const modes *all, const mechanism *m)
{
    return drift_of(all, m->method.recipe, method_step(m)).rate;
}

/* The cause without which the modes are the least bad, and these modes; -1 where without each they are as bad as that.
 */
static int find_cause(const graph *g, const plant *p, bool *gone, const point *at, badness *bad, double least,
                      modes *left)
{
    int found = -1;
    for (int i = 0; i < cause_count(p->m) && least > 0.0; i++) {
        if (!gone[i] && is_cause(g, p->m, i)) {
            gone[i] = true;
            const modes tried = modes_without(g, p->m, p->formulations.kept, gone, at);
            const double is = tried.found ? bad(&tried, p->m) : least;
            gone[i] = false;
            if (is < least) {
                least = is;
                found = i;
                *left = tried;
            }
        }
    }
    return found;
}

/* rk4 2.78 ms, rosenbrock any */
static const char *steps_text(arena *memory, const modes *m)
{
    const char *all = "";
    for (unsigned method = 0; method < ISO_METHODS; method++) {
        const double step = ISO_IS_VARYING(method) ? 0.0 : largest_step(m, method);
        if (!ISO_IS_VARYING(method)) {
            const char *before = all[0] == '\0' ? "" : ", ";
            all = isinf(step) ? arena_format(memory, "%s%s%s any", all, before, method_names[method])
                              : arena_format(memory, "%s%s%s %.3g ms", all, before, method_names[method], 1e3 * step);
        }
    }
    return all;
}

static void warn_of_growth(const source *s, arena *memory, const plant *p, const modes *m, int which, const point *at)
{
    const mechanism *machine = p->m;
    const cause c = cause_of(machine, which);
    int fastest = 0;
    count_growing(m, machine->method.recipe, method_step(machine), &fastest);
    const double im = fabs(m->im[fastest]);
    const char *oscillation = im == 0.0 ? "" : arena_format(memory, " +- %.4g i", im);
    const char *parts = machine->effects.fast_substeps == 0
                            ? ""
                            : arena_format(memory, ", %d sub-steps of it for effects", machine->effects.fast_substeps);
    source_warn(
        s, c.at,
        "the %s '%s' is too fast for %s with a step of %.4g ms%s: the Jacobian %s has the eigenvalue %.4g%s 1/s; the "
        "largest stable steps: %s",
        c.sort, c.name, method_names[ISO_METHOD_OF(machine->method.recipe)], 1e3 * method_step(machine), parts,
        at->when, m->re[fastest], oscillation, steps_text(memory, m));
}

/* Warns of each cause, until the rest is stable: with the modes `before`, of the mechanism without those that are gone.
 * Returns whether there was one. */
static bool check_modes(const source *s, const graph *g, const plant *p, modes before, bool *gone, const point *at)
{
    bool any = false;
    while (before.found && growing(&before, p->m) > 0.0) {
        modes left = before;
        const int which = find_cause(g, p, gone, at, growing, growing(&before, p->m), &left);
        warn_of_growth(s, g->memory, p, &before, which, at);
        any = true;
        if (which < 0) {
            break;
        }
        gone[which] = true;
        before = left;
    }
    return any;
}

static bool check_point(const source *s, const graph *g, const plant *p, slopes tangent, const point *at)
{
    bool *gone = arena_take(g->memory, (size_t)cause_count(p->m) + 1, sizeof *gone);
    return check_modes(s, g, p, modes_of(g->memory, tangent), gone, at);
}

/* Warns of an oscillation that is not too fast for the method, but that it lets grow by e within a life. */
static void check_drift(const source *s, const graph *g, const plant *p, slopes tangent, const point *at)
{
    const mechanism *m = p->m;
    const modes all = modes_of(g->memory, tangent);
    bool *gone = arena_take(g->memory, (size_t)cause_count(m) + 1, sizeof *gone);
    modes left;
    const drift found = all.found ? drift_of(&all, m->method.recipe, method_step(m)) : (drift){0.0, 0.0};
    if (found.rate * life < 1.0) {
        return;
    }
    const cause c = cause_of(m, find_cause(g, p, gone, at, drifting, 1.0 / life, &left)); /* none within a life */
    const char *others = "";
    for (unsigned method = 0; method < ISO_METHODS; method++) {
        if (!ISO_IS_VARYING(method) && drift_of(&all, method, method_step(m)).rate * life < 1.0) {
            others = arena_format(g->memory, "%s%s%s", others, others[0] == '\0' ? "" : ", ", method_names[method]);
        }
    }
    source_warn(
        s, c.at,
        "the oscillation of %.4g rad/s by the %s '%s' grows by e in %.3g s with %s and a step of %.4g ms, by the "
        "method alone; take a shorter step%s%s",
        found.frequency, c.sort, c.name, 1.0 / found.rate, method_names[ISO_METHOD_OF(m->method.recipe)],
        1e3 * method_step(m), others[0] == '\0' ? "" : ", or ", others);
}

/* The start with all joints at rest. Returns whether they were not. */
static bool stop_at(const mechanism *m, point *at)
{
    bool moved = false;
    for (int i = m->position_count; i < state_count(m); i++) {
        moved = moved || at->x[i] != 0.0;
        at->x[i] = 0.0;
    }
    at->when = "at rest";
    return moved;
}

/* Checks a steepest point of an effect, without the others whose own are passed on the way there: these are looked at
 * by themselves. */
static bool check_steepest_point(const source *s, const graph *g, const plant *p, const linearised *l,
                                 steepness *const *all, int effect, const double *from, const point *at)
{
    bool *gone = arena_take(g->memory, (size_t)cause_count(p->m) + 1, sizeof *gone), any_gone = false;
    for (int i = 0; i < p->m->effects.count; i++) {
        gone[i] = i != effect && is_passed(all[i], from, at->x);
        any_gone = any_gone || gone[i];
    }
    const modes found = any_gone ? modes_without(g, p->m, p->formulations.kept, gone, at)
                                 : modes_of(g->memory, slopes_at(l, at->x, at->u));
    return check_modes(s, g, p, found, gone, at);
}

/* Checks the points with one state beside a kink of an effect, where that is steepest. With closures a state cannot
 * move alone. Returns whether there was a warning. */
static bool check_steepest(const source *s, const graph *g, const plant *p, const linearised *l, const point *at)
{
    const mechanism *m = p->m;
    const int count = m->closure_count == 0 ? m->effects.count : 0;
    steepness **all = arena_take(g->memory, (size_t)count + 1, sizeof *all);
    bool any = false;
    for (int i = 0; i < count; i++) {
        all[i] = steepness_find(g, m, i, at->x, at->u);
    }
    for (int i = 0; i < count; i++) {
        const char *when = arena_format(g->memory, "where '%s' is steepest", m->effects.names[i].text);
        bool is_warned = false;
        for (int k = 0; k < all[i]->count && !is_warned; k++) {
            const point there = {when, all[i]->points[k], at->u};
            is_warned = check_steepest_point(s, g, p, l, all, i, at->x, &there);
        }
        any = any || is_warned;
    }
    for (int i = 0; i < count; i++) {
        steepness_free(all[i]);
    }
    return any;
}

/* An implicit method divides by the Jacobian. */
static void refuse(source *s, const mechanism *m, arena *memory, int which)
{
    const name n = {mechanism_states(m, memory)[which].about.name, mechanism_states(m, memory)[which].at};
    source_problem(
        s, n.at,
        "the Jacobian at the start is not finite: something has no slope by '%s' there, and %s needs it; take "
        "another start, or a formula that is smooth there",
        n.text, method_names[ISO_METHOD_OF(m->method.recipe)]);
}

void stability_line(const plant *p, text *out)
{
    const int states = state_count(p->m);
    if (!ISO_IS_VARYING(p->m->method.recipe) && states > MOST_STATES) {
        text_add(out, "stability not checked, %d states are more than %d\n", states, MOST_STATES);
    }
}

void stability_check(source *s, const graph *g, const plant *p)
{
    const mechanism *m = p->m;
    if (ISO_IS_VARYING(m->method.recipe) || state_count(m) > MOST_STATES) {
        return;
    }
    linearised l = linearise(g, m, p->derivatives, (size_t)state_count(m));
    point at = {"at the start", mechanism_start(m, g->memory), inputs_at_start(g, m)};
    const slopes first = slopes_at(&l, at.x, at.u);
    if (first.infinite >= 0 && ISO_IS_IMPLICIT(m->method.recipe)) {
        refuse(s, m, g->memory, first.infinite);
    } else if (!check_point(s, g, p, first, &at) && !check_steepest(s, g, p, &l, &at)) {
        check_drift(s, g, p, first, &at);
        if (stop_at(m, &at) && !check_point(s, g, p, slopes_at(&l, at.x, at.u), &at)) {
            (void)check_steepest(s, g, p, &l, &at);
        }
    }
    graph_free(&l.g);
}
