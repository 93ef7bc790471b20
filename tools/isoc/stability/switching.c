#include "tools/isoc/stability/stability.h"

#include <math.h>
#include <string.h>

/* A run is looked at in windows of so many steps; a formula that jumps less often in one does not count as switching.
 */
enum { WINDOW = 2000, FEWEST_JUMPS = 4 };

/* The largest share of a switched value that half a step at each jump may be. */
static const double most_share = 0.01;

/* A contribution of an effect: an effort, a force, a moment, or the rate of a state. */
typedef struct gift {
    int effect, first, count; /* of the roots */
    int state;                /* of a rate; -1 of an effort */
    double last, largest;     /* the size of the last jump; and the largest of the gift itself so far */
    double jumps, amount;     /* sums over the steps of a window */
    int times, at_rows;       /* the jumps, and those of them by memories */
} gift;

/* The worst window of an effect. */
typedef struct finding {
    double share, steps, until; /* steps between two jumps; s */
    bool is_at_rows;            /* most are by memories */
} finding;

typedef struct look {
    meetings *events; /* NULL: there are none */
    course *run, own;
    double *u_moved;
    compared rows;
    gift *gifts;
    int gift_count;
    finding *worst; /* [effects] */
} look;

/* The jumps of the roots: the plant here as it is switched on the other side, jumped[roots]. `sign` is 1 where the
 * other side is the step before. */
static void jump_at(look *l, const double *x, const double *u, uint64_t tick, double sign, double *jumped)
{
    course *w = l->run;
    functions *f = &w->plant, *d = &w->drives;
    const bool is_after = sign > 0.0;
    memcpy(l->u_moved, u, (size_t)held_count(w->m) * sizeof *u);
    if (has_switched(d)) {
        course_evaluate(w, d, &(evaluation){.p = w->parameters, .tick = tick}, is_after ? d->before : d->now, d->moved);
        course_inputs(w, d->moved, l->u_moved);
    }
    const double *here = is_after ? f->now : f->before, *there = is_after ? f->before : f->now;
    course_evaluate(w, f, &(evaluation){.x = x, .u = l->u_moved, .p = w->parameters, .tick = tick}, there, f->moved);
    for (int i = 0; i < l->gift_count; i++) {
        for (int k = l->gifts[i].first; k < l->gifts[i].first + l->gifts[i].count; k++) {
            jumped[k] = sign * (here[f->roots[k]] - f->moved[f->roots[k]]);
        }
    }
}

/* A kink has a difference that changes its sign where it is, and jumps by nothing; a jump has one on both sides. */
static double size_of_jump(const gift *g, const double *after, const double *before)
{
    double sum = 0.0;
    for (int k = g->first; k < g->first + g->count; k++) {
        const double least = fmin(fabs(after[k]), fabs(before[k]));
        sum += (after[k] > 0.0) == (before[k] > 0.0) ? least : 0.0;
    }
    return sum;
}

static double size_of_gift(const look *l, const gift *g)
{
    double sum = 0.0;
    for (int k = g->first; k < g->first + g->count; k++) {
        sum += fabs(l->run->plant.now[l->run->plant.roots[k]]);
    }
    return sum;
}

/* Adds a jump of a gift, where it is more than rounding. */
static void add_jump(gift *g, double jump, bool at_rows)
{
    static const double rounding = 1e-9;
    if (jump > rounding * g->largest) {
        g->last = jump;
        g->jumps += jump;
        g->times++;
        g->at_rows += at_rows;
    }
}

/* A rate falls between two jumps, as the state follows the switched value: the fall counts as half of the jump, at
 * least. */
static void add_step(look *l, bool jumps, const double *after, const double *before)
{
    FOR_ALL (gift, g, l->gifts, l->gift_count) {
        const double size = size_of_gift(l, g);
        g->largest = fmax(g->largest, size);
        add_jump(g, jumps ? size_of_jump(g, after, before) : 0.0, false);
        g->amount += g->state >= 0 ? fmax(size, 0.5 * g->last) : size;
    }
}

/* Adds what rates jump by memories that a comparison of their state sets in this row, half a step late in the mean. */
static void add_rows(look *l)
{
    course *w = l->run;
    memcpy(l->u_moved, w->u, (size_t)held_count(w->m) * sizeof *w->u);
    if (!compared_put_back(&l->rows, w, l->u_moved)) {
        return;
    }
    const evaluation at = {.x = w->x, .u = l->u_moved, .p = w->parameters, .tick = w->tick};
    course_evaluate(w, &w->plant, &at, NULL, w->plant.moved);
    FOR_ALL (gift, g, l->gifts, l->gift_count) {
        const node rate = w->plant.roots[g->first];
        if (g->state >= 0 && compared_has(&l->rows, w, g->state)) {
            add_jump(g, fabs(w->plant.now[rate] - w->plant.moved[rate]), true);
        }
    }
}

static void end_window(look *l, double until)
{
    FOR_ALL (gift, g, l->gifts, l->gift_count) {
        const double share = g->times >= FEWEST_JUMPS ? 0.5 * g->jumps / g->amount : 0.0;
        finding *worst = &l->worst[g->effect];
        if (share > worst->share) {
            *worst = (finding){share, (double)WINDOW / (double)g->times, until, 2 * g->at_rows > g->times};
        }
        g->jumps = g->amount = 0.0;
        g->times = g->at_rows = 0;
    }
}

/* A step; what jumps in one with events, does so at its time, or is not told. Returns whether states are finite. */
static bool look_on(look *l, uint64_t k, bool *has_events)
{
    const int events = l->events == NULL ? 0 : meetings_step(l->events, k);
    *has_events = events > 0;
    return l->events == NULL ? course_move(l->run, l->run->step) : events >= 0;
}

static void follow_jumps(look *l, arena *memory, size_t roots)
{
    course *w = l->run;
    double *after = arena_take(memory, roots + 1, sizeof *after);
    double *before = arena_take(memory, roots + 1, sizeof *before);
    bool goes_on = true, has_events = true;
    for (uint64_t k = 0; goes_on && course_goes_on(w, k); k++) {
        course_begin(w, k);
        const bool jumps = !has_events && (has_switched(&w->plant) || has_switched(&w->drives));
        if (jumps) {
            jump_at(l, w->x, w->u, w->tick, 1.0, after);
            jump_at(l, w->x_before, w->u_before, w->earlier, -1.0, before);
        }
        add_step(l, jumps, after, before);
        if (k > 0 && w->nexts.any_switch) {
            add_rows(l);
            compared_watch(&l->rows, w);
        }
        if ((k + 1) % WINDOW == 0) {
            end_window(l, (double)(k + 1) * w->step);
        }
        goes_on = look_on(l, k, &has_events);
    }
}

/* The efforts and rates of each effect. */
static size_t list_contributions(look *l, const plant *p, node *roots)
{
    const mechanism *m = p->m;
    int count = 0;
    for (int i = 0; i < m->effects.push_count; i++) {
        l->gifts[l->gift_count++] =
            (gift){.effect = m->effects.pushes[i].effect, .first = count, .count = 1, .state = -1};
        roots[count++] = m->effects.pushes[i].effort;
    }
    FOR_ALL (const applied_force, f, m->forces.applied, m->forces.applied_count) {
        for (int turns = 0; turns < 2 && f->drive < 0; turns++, count += 3) {
            l->gifts[l->gift_count++] = (gift){.effect = f->effect, .first = count, .count = 3, .state = -1};
            memcpy(roots + count, turns ? f->moment.at : f->force.at, 3 * sizeof *roots);
        }
    }
    FOR_ALL (const effect_quantity, e, m->effects.states, m->effects.state_count) {
        const int number = m->effects.first_state + (int)(e - m->effects.states);
        if (e->is_mode) {
            continue;
        }
        l->gifts[l->gift_count++] = (gift){.effect = e->effect, .first = count, .count = 1, .state = number};
        roots[count++] = e->next;
    }
    return (size_t)count;
}

/* Whether the method goes with events. */
static bool events_fit(const mechanism *m)
{
    return ISO_IS_EXPLICIT(m->method.recipe) || ISO_IS(m->method.recipe, ISO_SEMI_IMPLICIT);
}

static void warn_of_jumps(const source *s, const look *l, int effect)
{
    const finding *f = &l->worst[effect];
    const mechanism *m = l->run->m;
    const name *n = &m->effects.names[effect];
    source_warn(
        s, n->at,
        "the effect '%s' jumps every %.3g steps of %.4g ms in the %.3g s until %.4g s: %s, here %.2g %% of what "
        "it switches; up to 1 %% takes a step of %.2g ms%s",
        n->text, f->steps, 1e3 * l->run->step, (double)WINDOW * l->run->step, f->until,
        f->is_at_rows ? "a memory compares once a step, and is late by up to one"
                      : "a jump within a step is misplaced by up to half of it",
        100.0 * f->share, 1e3 * l->run->step * most_share / f->share,
        events_fit(m) ? ", a mode that a `when` sets at the time of the jump, or share(A < B), the part of a "
                        "step in which it holds"
                      : "");
}

static look look_of(const graph *g, const plant *p, size_t *root_count)
{
    const mechanism *m = p->m;
    arena *memory = g->memory;
    const size_t gifts = (size_t)(m->effects.push_count + 6 * m->forces.applied_count + m->effects.state_count);
    const size_t states = (size_t)state_count(m);
    node *roots = arena_take(memory, states + gifts + 1, sizeof *roots);
    look l = {.gifts = arena_take(memory, gifts + 1, sizeof *l.gifts)};
    l.worst = arena_take(memory, (size_t)m->effects.count + 1, sizeof *l.worst);
    l.u_moved = arena_take(memory, (size_t)held_count(m) + 1, sizeof *l.u_moved);
    memcpy(roots, p->derivatives, states * sizeof *roots);
    size_t first = states;
    const size_t count = list_contributions(&l, p, roots + states);
    if (m->events.count > 0) {
        l.events = meetings_of(g, p, roots + states, count, &first);
    } else {
        l.own = course_of(g, p, roots, states + count);
    }
    for (int i = 0; i < l.gift_count; i++) {
        l.gifts[i].first += (int)first;
    }
    *root_count = first + count;
    return l;
}

void switching_check(const source *s, const graph *g, const plant *p)
{
    const mechanism *m = p->m;
    if (ISO_IS_VARYING(m->method.recipe) || ISO_IS_IMPLICIT(m->method.recipe) || m->effects.count == 0 ||
        m->events.hold_count > 0) {
        return;
    }
    size_t roots;
    look l = look_of(g, p, &roots);
    l.run = l.events == NULL ? &l.own : meetings_course(l.events);
    if (l.run->plant.any_switch || l.run->drives.any_switch || l.run->nexts.any_switch) {
        l.rows = compared_of(l.run, g->memory);
        follow_jumps(&l, g->memory, roots);
        compared_warn(&l.rows, s, l.run);
    }
    for (int i = 0; i < m->effects.count; i++) {
        if (l.worst[i].share > most_share) {
            warn_of_jumps(s, &l, i);
        }
    }
    course_free(l.run);
}
