/* Events that meet: more of them in a step than it has slots; and those whose function comes down to zero and never
 * passes it. */
#include "tools/isoc/stability/stability.h"

#include <float.h>
#include <math.h>
#include <string.h>

/* Events of a step that are followed; and the steps that a function stays near zero. */
enum { MOST_FOLLOWED = 16, STEPS_NEAR_ZERO = 100 };

/* Near zero, and zero but for rounding, as parts of the largest value of a function so far. */
static const double near_zero = 1e-6, rounding = 1e-9;

/* One event on the way. */
typedef struct watched {
    double value, zero;                   /* its function, less what rounding leaves at its time; and this */
    bool is_armed, has_passed, has_fired; /* it passes zero at its time; it was below zero once */
    double largest;                       /* of its function */
    int near, longest;
    double since, near_since; /* s: when it came near zero; for the longest time */
    bool is_held, is_at_rest; /* it puts its function on zero */
    int after;                /* the event before it in its first step that had too many; -1: there is none */
    double met;               /* s: that step; */
    int crowd;                /* and the most in a step in which it waited */
} watched;

struct meetings {
    const event_plan *plan;
    course run;
    watched *all; /* [events] */
    int count, slots;
    double until;             /* s: so far it is followed */
    double *from;             /* [states] at the begin of what is left of a step */
    double *set;              /* [sets] */
    int order[MOST_FOLLOWED]; /* the events of a step */
};

static double function_in(const meetings *k, int i, const double *numbers)
{
    return numbers[k->run.plant.roots[k->run.states + (size_t)i]];
}

/* Moves from the begin of what is left of the step, whose nodes stand in w->plant.now; those there in w->plant.moved.
 */
static bool move_by(meetings *k, double length)
{
    course *w = &k->run;
    memcpy(w->x, k->from, w->states * sizeof *w->x);
    const bool is_finite = course_move(w, length);
    course_plant(w, w->x, w->plant.moved);
    return is_finite;
}

/* Whether an event fires up to w->x. */
static bool is_crossed(const meetings *k, int i)
{
    return k->all[i].is_armed && function_in(k, i, k->run.plant.moved) < k->all[i].zero;
}

static bool any_crossed(const meetings *k)
{
    bool any = false;
    for (int i = 0; i < k->count; i++) {
        any = any || is_crossed(k, i);
    }
    return any;
}

/* Of those that fire between two parts of the rest of a step, by secants the first, and its part. */
static int first_between(const meetings *k, double low, double high, double *share)
{
    int first = -1;
    *share = high;
    for (int i = 0; i < k->count; i++) {
        const watched *e = &k->all[i];
        const double end = function_in(k, i, k->run.plant.moved) - e->zero;
        const double at = low + (high - low) * fmax(e->value, 0.0) / fmax(e->value - end, DBL_MIN);
        if (is_crossed(k, i) && (first < 0 || at < *share)) {
            first = i;
            *share = at;
        }
    }
    return first;
}

/* Sets the functions to their values at w->x. */
static void note_values(meetings *k, const double *numbers)
{
    for (int i = 0; i < k->count; i++) {
        k->all[i].value = function_in(k, i, numbers) - k->all[i].zero;
    }
}

/* The event that comes first in what is left of a step, and its part of that, by halves; -1: none, and w->x is the end.
 */
static int first_event(meetings *k, double left, double *share)
{
    enum { HALVES = 10 };
    double low = 0.0, high = 1.0;
    for (int i = 0; i < k->count; i++) {
        if (k->all[i].is_armed && k->all[i].value < 0.0) { /* it has waited, or another one moved it */
            *share = 0.0;
            return i;
        }
    }
    if (!any_crossed(k)) {
        return -1;
    }
    for (int half = 0; half < HALVES; half++) {
        const double middle = 0.5 * (low + high);
        (void)move_by(k, middle * left);
        if (any_crossed(k)) {
            high = middle;
        } else {
            low = middle;
            note_values(k, k->run.plant.moved);
        }
    }
    (void)move_by(k, high * left);
    return first_between(k, low, high, share);
}

/* Where a function is zero and its event does not move it: whether it rises there. */
static bool rises(meetings *k, int which, double length)
{
    static const double part = 1e-3;
    course *w = &k->run;
    for (size_t i = 0; i < w->states; i++) {
        w->stage[i] = w->x[i] + part * length * w->plant.now[w->plant.roots[i]];
    }
    course_plant(w, w->stage, w->plant.moved);
    return function_in(k, which, w->plant.moved) >= function_in(k, which, w->plant.now);
}

/* Sets what an event sets, at w->x, and evaluates all behind it. */
static void fire(meetings *k, int which, double left)
{
    course *w = &k->run;
    watched *fired = &k->all[which];
    course_plant(w, w->x, w->plant.now);
    const double *before = w->plant.now;
    const node *roots = w->plant.roots + w->states + (size_t)k->count;
    for (int i = 0; i < k->plan->set_count; i++) {
        k->set[i] = before[roots[i]];
    }
    for (int i = 0; i < k->plan->set_count; i++) {
        if (k->plan->owners[i] == which) {
            w->x[k->plan->states[i]] = k->set[i];
        }
    }
    for (int i = 0; i < k->count; i++) {
        watched *e = &k->all[i];
        const double was = function_in(k, i, before) - e->zero;
        e->is_armed = e->is_armed || (was >= 0.0 && !e->has_passed);
    }
    course_plant(w, w->x, w->plant.now);
    const double behind = function_in(k, which, w->plant.now);
    const bool moves = k->plan->moves[which];
    fired->has_fired = true;
    fired->zero = moves ? 0.0 : behind;
    fired->is_armed = moves ? behind >= 0.0 : rises(k, which, left);
    fired->has_passed = !moves && !fired->is_armed;
    fired->is_held = moves && fabs(behind) <= rounding * fired->largest;
    note_values(k, w->plant.now);
}

static bool is_among(const int *order, int count, int which)
{
    bool any = false;
    for (int i = 0; i < count; i++) {
        any = any || order[i] == which;
    }
    return any;
}

/* A contact that its own event puts on its place and that falls again is at rest: it may wait for the next step, and
 * gets as far as it falls in this one. */
static void rest(watched *e)
{
    e->is_armed = false;
    e->has_passed = e->is_at_rest = true;
}

/* Follows the events of a step. Returns their number, or -1 where states are not finite. */
static int follow_step(meetings *k)
{
    int *order = k->order;
    course *w = &k->run;
    double left = w->step, share;
    int count = 0;
    for (int i = 0; i < k->count; i++) {
        k->all[i].zero = 0.0;
    }
    note_values(k, w->plant.now);
    for (;;) {
        memcpy(k->from, w->x, w->states * sizeof *w->x);
        if (!move_by(k, left)) {
            return -1;
        }
        const int first = count < MOST_FOLLOWED ? first_event(k, left, &share) : -1;
        if (first < 0) {
            return count;
        }
        (void)move_by(k, share * left);
        left *= 1.0 - share;
        fire(k, first, left);
        if (k->all[first].is_held && is_among(order, count, first)) {
            rest(&k->all[first]);
        } else {
            order[count++] = first;
        }
    }
}

/* What the functions are at the end of a step, in w->plant.moved. */
static void end_step(meetings *k, double now)
{
    for (int i = 0; i < k->count; i++) {
        watched *e = &k->all[i];
        const double end = function_in(k, i, k->run.plant.moved);
        e->is_armed = end >= 0.0 || e->is_at_rest;
        e->has_passed = e->is_at_rest = false;
        e->has_fired = e->has_fired || end < 0.0;
        e->largest = fmax(e->largest, end);
        e->near = end < near_zero * e->largest ? e->near + 1 : 0;
        e->since = e->near == 1 ? now : e->since;
        if (e->near > e->longest) {
            e->longest = e->near;
            e->near_since = e->since;
        }
    }
}

/* Keeps of each event its first step with more events than slots, where it had to wait. */
static void keep_meeting(meetings *k, int count, double now)
{
    const int *order = k->order;
    for (int i = k->slots; i < count; i++) {
        watched *e = &k->all[order[i]];
        if (e->after < 0) {
            e->after = order[i - 1];
            e->met = now;
        }
        e->crowd = count > e->crowd ? count : e->crowd;
    }
}

int meetings_step(meetings *k, uint64_t step)
{
    for (int i = 0; i < k->count && step == 0; i++) {
        k->all[i].is_armed = function_in(k, i, k->run.plant.now) >= 0.0;
    }
    const int count = follow_step(k);
    k->until = (double)(step + 1) * k->run.step;
    if (count >= 0) {
        end_step(k, k->until);
    }
    return count;
}

static void follow_events(meetings *k)
{
    int count = 0;
    for (uint64_t step = 0; count >= 0 && course_goes_on(&k->run, step); step++) {
        course_begin(&k->run, step);
        count = meetings_step(k, step);
        keep_meeting(k, count, k->until);
    }
}

static void warn_of_meeting(const source *s, const meetings *k, int which)
{
    const watched *e = &k->all[which];
    const event *all = k->run.m->events.all;
    const bool is_itself = e->after == which, moves = k->plan->moves[which];
    const char *other = is_itself ? "itself" : arena_format(s->memory, "that of %s", source_line(s, all[e->after].at));
    const char *cure = arena_format(s->memory, "take `events %d`, or a shorter step", e->crowd);
    if (is_itself && !moves) {
        cure = "what bounces ever faster comes to rest where the event sets its place too";
    } else if (e->crowd == MOST_FOLLOWED) {
        cure = "they follow each other without an end: let a mode end that";
    }
    source_warn(
        s, all[which].at,
        "this event follows %s within a step of %.4g ms, at %.4g s, and waits for the next step (`events %d`): %s",
        other, 1e3 * k->run.step, e->met, k->slots, cure);
}

static void warn_of_touch(const source *s, const meetings *k, int which)
{
    const watched *e = &k->all[which];
    source_warn(s, k->run.m->events.all[which].at,
                "this event does not happen until %.4g s: its two sides come together, to 1e-6 of their largest "
                "difference at %.4g s, "
                "and do not pass each other; what decays to a value does not reach it: compare with one before it",
                k->until, e->near_since);
}

/* Whether all inputs are known: those of a port are not. */
static bool inputs_known(const mechanism *m)
{
    bool all = true;
    for (int i = 0; i < m->inputs.count; i++) {
        all = all && m->inputs.driven[i];
    }
    return all;
}

course *meetings_course(meetings *k)
{
    return &k->run;
}

meetings *meetings_of(const graph *g, const plant *p, const node *more, size_t count, size_t *first)
{
    const mechanism *m = p->m;
    arena *memory = g->memory;
    const size_t events = (size_t)m->events.count, states = (size_t)state_count(m);
    const size_t sets = (size_t)p->events.set_count;
    node *roots = arena_take(memory, states + events + sets + count + 1, sizeof *roots);
    memcpy(roots, p->derivatives, states * sizeof *roots);
    for (size_t i = 0; i < events; i++) {
        roots[states + i] = m->events.all[i].function;
    }
    memcpy(roots + states + events, p->events.values, sets * sizeof *roots);
    *first = states + events + sets;
    for (size_t i = 0; i < count; i++) {
        roots[*first + i] = more[i];
    }
    meetings *k = arena_take(memory, 1, sizeof *k);
    *k = (meetings){.plan = &p->events, .run = course_of(g, p, roots, *first + count), .count = m->events.count};
    k->slots = m->events.slots;
    k->all = arena_take(memory, events, sizeof *k->all);
    k->from = arena_take(memory, states + 1, sizeof *k->from);
    k->set = arena_take(memory, sets + 1, sizeof *k->set);
    for (int i = 0; i < k->count; i++) {
        k->all[i].after = -1;
    }
    return k;
}

void meetings_check(const source *s, const graph *g, const plant *p)
{
    const mechanism *m = p->m;
    size_t unused;
    if (m->events.count == 0 || m->events.hold_count > 0) {
        return;
    }
    meetings *k = meetings_of(g, p, NULL, 0, &unused);
    follow_events(k);
    for (int i = 0; i < k->count; i++) {
        if (k->all[i].after >= 0) {
            warn_of_meeting(s, k, i);
        } else if (!k->all[i].has_fired && k->all[i].longest >= STEPS_NEAR_ZERO && inputs_known(m)) {
            warn_of_touch(s, k, i);
        }
    }
    course_free(&k->run);
}
