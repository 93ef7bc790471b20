/* Events: a state, a mode or a speed is set at the time at which a function of the states falls below zero, within the
 * step. All is computed in every step, and chosen by masks: a step has one number of instructions with and without an
 * event, and the bits of the method where nothing fires.
 *
 * After the step of the method, the trial, each slot finds the first event between two states whose derivatives are
 * known, on the cubic through both (Hairer, Norsett, Wanner 1993, Solving Ordinary Differential Equations I, II.6): a
 * secant, then a step of Newton's method. It sets there what the event sets, and makes the rest of the step by a table.
 * Where the method has order four, so have the place of the event, and with it the rest by rk4.
 *
 * An event fires at an edge: where its function goes from >= 0 to < 0 from one evaluation to the next. It is armed
 * while it was not below zero when it was last evaluated; so a function that is below zero at the begin of a step fires
 * there if something has moved it since the last step, or if it had to wait. Of two at one time the first in the text
 * fires. What the slots leave waits, armed, for the next step.
 *
 * At its own time a function is zero, whatever rounding leaves of it: where the sets do not change it, what is left is
 * subtracted in the rest of the step, and its rate decides on which side it is. Where it falls, it has passed, and is
 * armed again when it has been below zero, or rises.
 */
#ifndef ISO_CORE_METHODS_EVENT_H
#define ISO_CORE_METHODS_EVENT_H

#include "core/methods/hold.h"
#include "core/methods/method.h"
#include "core/numbers/sqrt.h"

/* both[0] = the function of an event at x[states], and both[1] = its rate where dx[states] are those of the states. */
typedef void iso_event_function(real *both, const real *x, const real *dx, const real *u, const real *p);

/* to[sets] = what all events would set, from the states x before. */
typedef void iso_event_sets(real *to, const real *x, const real *u, const real *p);

/* The events of a plant, in the order of its text. */
typedef struct iso_events {
    size_t count;
    iso_event_function *const *functions; /* [count] */
    const bool *moves;                    /* [count] whether an event sets something that its own function reads */
    const uint16_t *reads;                /* the states that the functions read, of one event after the other: */
    const uint16_t *ends;                 /* [count] where those of each end */
    size_t sets;
    iso_event_sets *values;
    const uint16_t *states; /* [sets] of which state, */
    const uint16_t *owners; /* [sets] and by which event */
    uint8_t slots;          /* events in a step */
    const iso_tableau *rest;
    const iso_holds *holds; /* NULL: there are none; their changes are events behind the others */
    const bool *strikes;    /* [count] with holds: whether an event is an impulse */
} iso_events;

/* Reals of work space: vectors of the states, and the derivatives of the table; of each event its function, its
 * rate and what is subtracted from it; the values of all sets. */
#define ISO_EVENT_WORK(n, stages, events, sets) ((n) * (size_t)(3 + (stages)) + 3 * (size_t)(events) + (size_t)(sets))

/* What is known of holds takes as much as of events, and ISO_HOLD_WORK besides. */
#define ISO_EVENT_HOLD_WORK(holds) (3 * (size_t)(holds) + ISO_HOLD_WORK(holds))

/* A step, or the rest of one, whose ends are known. */
typedef struct iso_span {
    size_t n;
    real length;              /* s */
    real *from, *to;          /* [n] the states */
    real *leaving, *arriving; /* [n] their derivatives there */
} iso_span;

/* A step with events. */
typedef struct iso_event_step {
    const iso_events *events;
    iso_derivative *f;
    const real *u, *held; /* what it reads besides the states, */
    const real *p;        /* and the tunables */
    iso_span span;
    iso_bits *known; /* [events] in the memory */
    real *value;     /* [events] the functions at span.from, */
    real *rate;      /* [events] their rates there, */
    real *zero;      /* [events] and what is subtracted from each */
    real *x, *dx;    /* [n] on the way */
    real *set;       /* [sets] */
    real *k;         /* [stages n] derivatives in the rest of a step */
    iso_hold_room holds;
} iso_event_step;

/* All ones where x is below zero; -0 is not, nor what is no number, whose sign is no promise. */
ISO_INLINE iso_bits iso_is_negative(const real x)
{
    const iso_bits bits = iso_bits_of(x), beyond = ISO_EXPONENT_BITS - (bits & ~ISO_SIGN_BIT);
    return iso_mask_of_sign(bits & (bits - 1) & ~beyond);
}

/* All ones where a whole number is this one. */
ISO_INLINE iso_bits iso_is_whole(const iso_bits number, const size_t wanted)
{
    const iso_bits apart = number ^ (iso_word)wanted;
    return ~iso_mask_of_sign(apart | (0 - apart));
}

/* a where the mask is all ones, b where it is zero. */
ISO_INLINE iso_bits iso_select_bits(const iso_bits mask, const iso_bits a, const iso_bits b)
{
    return (a & mask) | (b & ~mask);
}

/* All ones where an event is armed; and the word of one that has passed. */
ISO_INLINE iso_bits iso_event_is_armed(const iso_bits known)
{
    return iso_mask_of_sign(known);
}

ISO_INLINE iso_bits iso_event_passed(void)
{
    return iso_mask_where(true) & (iso_word)1;
}

/* What is known of an event behind an evaluation of its function: it is armed where that is not below zero, but not
 * where it has passed through zero before and still falls from there. */
ISO_INLINE iso_bits iso_event_seen(const iso_bits known, const real value, const real rate)
{
    const iso_bits below = iso_is_negative(value), armed = iso_event_is_armed(known);
    const iso_bits passes = iso_mask_of_lowest(known) & ~armed & ~below & iso_is_negative(rate);
    return armed | iso_select_bits(passes, iso_event_passed(), ~below);
}

/* The weights, at a part t of a span, of its way and of the derivatives at both ends: for a state, and for its
 * derivative by t. */
typedef struct iso_weights {
    real way, leaving, arriving;
    real way_rate, leaving_rate, arriving_rate;
} iso_weights;

ISO_INLINE iso_weights iso_weights_at(const iso_span *const span, const real t)
{
    const real left = R(1.0) - t, both = t * left;
    return (iso_weights){.way = t * t * (R(1.0) + R(2.0) * left),
                         .leaving = span->length * both * left,
                         .arriving = -span->length * both * t,
                         .way_rate = R(6.0) * both,
                         .leaving_rate = span->length * (left * (left - R(2.0) * t)),
                         .arriving_rate = span->length * (t * (t - R(2.0) * left))};
}

/* A state on the cubic of Hermite, and its derivative by t. At t = 0 exactly `from`; what is constant stays exactly. */
ISO_INLINE void iso_span_state(const iso_span *const span, const iso_weights *const at, const size_t s, real *const x,
                               real *const dx)
{
    const real apart = span->to[s] - span->from[s], leaving = span->leaving[s], arriving = span->arriving[s];
    x[s] = span->from[s] + (at->way * apart + (at->leaving * leaving + at->arriving * arriving));
    dx[s] = at->way_rate * apart + (at->leaving_rate * leaving + at->arriving_rate * arriving);
}

/* All of them: x[n] and dx[n]. */
ISO_INLINE void iso_span_at(const iso_span *const span, const real t, real *const x, real *const dx)
{
    const iso_weights at = iso_weights_at(span, t);
    ISO_UNROLL
    for (size_t s = 0; s < span->n; s++) {
        iso_span_state(span, &at, s, x, dx);
    }
}

/* The number of events, with those of holds. */
ISO_INLINE size_t iso_event_count(const iso_events *const events)
{
    return events->holds == NULL ? events->count : events->count + events->holds->count;
}

/* Those that the function of an event reads. */
ISO_INLINE void iso_event_states(const iso_event_step *const step, const size_t e, const real t)
{
    const iso_events *const all = step->events;
    const iso_weights at = iso_weights_at(&step->span, t);
    if (e >= all->count) {
        iso_span_state(&step->span, &at, all->holds->speeds[e - all->count], step->x, step->dx);
        iso_span_state(&step->span, &at, all->holds->against[e - all->count], step->x, step->dx);
        return;
    }
    ISO_UNROLL
    for (size_t i = e == 0 ? 0 : all->ends[e - 1]; i < all->ends[e]; i++) {
        iso_span_state(&step->span, &at, all->reads[i], step->x, step->dx);
    }
}

/* The speed of a hold in its own direction, and its rate; zeros where it is stuck. */
ISO_INLINE real iso_event_slip(const iso_event_step *const step, const size_t i, const real *const x,
                               const real *const dx, real *const rate)
{
    const iso_holds *const holds = step->events->holds;
    const real mode = step->span.from[holds->modes[i]];
    const size_t speed = holds->speeds[i], against = holds->against[i];
    *rate = mode * (speed == against ? dx[speed] : dx[speed] - dx[against]);
    return mode * (speed == against ? x[speed] : x[speed] - x[against]);
}

/* The function of an event, less what rounding left of it at its last time, and its rate. */
ISO_INLINE real iso_event_value(const iso_event_step *const step, const size_t e, const real *const x,
                                const real *const dx, real *const rate)
{
    real both[2];
    if (e >= step->events->count) {
        return iso_event_slip(step, e - step->events->count, x, dx, rate);
    }
    step->events->functions[e](both, x, dx, step->u, step->p);
    *rate = both[1];
    return both[0] - step->zero[e];
}

/* The place t in the span at which an event fires, from 0 to 1; 2 where it does not. A function that rises at first
 * falls through zero later: there the root of a parabola takes the place of the secant, by the rate at the begin. */
ISO_INLINE real iso_event_place(const iso_event_step *const step, const size_t e)
{
    real rate;
    const iso_span *const span = &step->span;
    const real begin = step->value[e], end = iso_event_value(step, e, span->to, span->arriving, &rate);
    const iso_bits below = iso_is_negative(begin);
    const iso_bits armed = e < step->events->count ? iso_event_is_armed(step->known[e]) : iso_mask_where(true);
    const iso_bits crosses = armed & ~below & iso_is_negative(end);
    const iso_bits rises = crosses & ~iso_is_negative(step->rate[e]);
    const real rise = span->length * step->rate[e], bend = end - begin - rise;
    const real root = iso_sqrt(iso_select(rises, rise * rise - R(4.0) * bend * begin, R(1.0)));
    const real parabola = (rise + root) / iso_select(rises, R(-2.0) * bend, R(1.0));
    const real secant = begin / iso_select(crosses, begin - end, R(1.0));
    const real near = iso_select(crosses, iso_clamp(iso_select(rises, parabola, secant), R(0.0), R(1.0)), R(0.0));
    iso_event_states(step, e, near);
    const real value = iso_event_value(step, e, step->x, step->dx, &rate);
    const iso_bits falls = iso_is_negative(rate);
    const real newton = near - value / iso_select(falls, rate, R(1.0));
    const real place = iso_clamp(iso_select(falls, newton, near), R(0.0), R(1.0));
    return iso_select(crosses, place, iso_select(below & armed, R(0.0), R(2.0)));
}

/* step->k[n] is the derivative at x[n]: end[n] = the states at the end of the step, `length` later. */
ISO_INLINE void iso_event_rest(const iso_event_step *const step, const real length, const real *const x, real *const at,
                               real *const end)
{
    const iso_tableau *const table = step->events->rest;
    const size_t n = step->span.n;
    ISO_UNROLL
    for (uint8_t i = 1; i < table->stages; i++) {
        const real h_over = length / iso_whole(table->a_over[i]);
        ISO_UNROLL
        for (size_t s = 0; s < n; s++) {
            at[s] = x[s] + iso_combine(h_over, table->a[i], i, step->k + s, n);
        }
        step->f(step->k + i * n, at, step->u, step->held);
    }
    const real h_over = length / iso_whole(table->b_over);
    ISO_UNROLL
    for (size_t s = 0; s < n; s++) {
        end[s] = x[s] + iso_combine(h_over, table->b, table->stages, step->k + s, n);
    }
}

/* Sets in x[n] what the event `first` sets, where `fires` is all ones. */
ISO_INLINE void iso_event_set(const iso_event_step *const step, const iso_bits fires, const iso_bits first,
                              real *const x)
{
    const iso_events *const all = step->events;
    if (all->sets > 0) {
        all->values(step->set, x, step->u, step->p);
    }
    ISO_UNROLL
    for (size_t i = 0; i < all->sets; i++) {
        const iso_bits is_set = fires & iso_is_whole(first, all->owners[i]);
        x[all->states[i]] = iso_select(is_set, step->set[i], x[all->states[i]]);
    }
}

/* The functions at the time of an event, before its sets, at x[n], which changes at the rates dx[n]. */
ISO_INLINE void iso_event_before(const iso_event_step *const step, const iso_bits fires, const real *const x,
                                 const real *const dx)
{
    ISO_UNROLL
    for (size_t e = 0; e < step->events->count; e++) {
        real rate;
        const real value = iso_event_value(step, e, x, dx, &rate);
        step->known[e] = iso_select_bits(fires, iso_event_seen(step->known[e], value, rate), step->known[e]);
    }
}

/* And behind its sets, with the derivative step->k[n]: also what is subtracted from here on. */
ISO_INLINE void iso_event_behind(const iso_event_step *const step, const iso_bits fires, const iso_bits first,
                                 const real *const x)
{
    ISO_UNROLL
    for (size_t e = 0; e < step->events->count; e++) {
        real rate;
        const real value = iso_event_value(step, e, x, step->k, &rate);
        const iso_bits own = fires & iso_is_whole(first, e);
        iso_bits known = iso_event_seen(step->known[e] & ~own, value, rate);
        real kept = value;
        if (!step->events->moves[e]) {
            const iso_bits side = iso_select_bits(iso_is_negative(rate), iso_event_passed(), iso_mask_where(true));
            known = iso_select_bits(own, side, known);
            step->zero[e] += iso_select(own, value, R(0.0));
            kept = iso_select(own, R(0.0), value);
        }
        step->known[e] = iso_select_bits(fires, known, step->known[e]);
        step->value[e] = iso_select(fires, kept, step->value[e]);
        step->rate[e] = iso_select(fires, rate, step->rate[e]);
    }
}

/* --- holds --- */

/* The efforts at the end of the span, and where the first hold would break by them; and the efforts there, at `near`.
 */
ISO_INLINE real iso_event_near(const iso_event_step *const step)
{
    const iso_holds *const holds = step->events->holds;
    iso_hold_find(holds, step->span.to, step->u, step->p, &step->holds.to, step->holds.work);
    real first = R(2.0);
    ISO_UNROLL
    for (size_t i = 0; i < holds->count; i++) {
        first = iso_min(first, iso_hold_first_place(holds, &step->holds, step->span.from, i));
    }
    const real inside = iso_clamp(first, R(0.015625), R(0.984375));
    const real near = iso_select(iso_less(R(1.5), first), R(0.5), inside);
    iso_span_at(&step->span, near, step->x, step->dx);
    iso_hold_find(holds, step->x, step->u, step->p, &step->holds.at, step->holds.work);
    return near;
}

/* The place at which an event fires, or a hold sticks or breaks. */
ISO_INLINE real iso_event_any_place(const iso_event_step *const step, const size_t e, const real near)
{
    const iso_events *const all = step->events;
    const real place = iso_event_place(step, e);
    if (e < all->count) {
        return place;
    }
    const size_t i = e - all->count;
    const iso_bits slips = iso_is_nonzero(step->span.from[all->holds->modes[i]]);
    return iso_select(slips, place, iso_hold_place(all->holds, &step->holds, step->span.from, near, i));
}

/* All holds at the time of an event, whose sets are in x[n]. */
ISO_INLINE void iso_event_holds(const iso_event_step *const step, const iso_bits fires, const iso_bits first,
                                real *const x)
{
    const iso_events *const all = step->events;
    const iso_holds *const holds = all->holds;
    iso_bits strikes = ISO_NOTHING;
    ISO_UNROLL
    for (size_t e = 0; e < all->count; e++) {
        strikes |= all->strikes[e] ? fires & iso_is_whole(first, e) : ISO_NOTHING;
    }
    ISO_UNROLL
    for (size_t i = 0; i < holds->count; i++) {
        iso_hold_own(holds, &step->holds, fires & iso_is_whole(first, all->count + i), x, i);
    }
    iso_hold_change(holds, &step->holds, strikes, x, step->u, step->p);
}

/* Behind an event the span begins with what is known there. */
ISO_INLINE void iso_event_hold_from(const iso_event_step *const step, const iso_bits fires)
{
    const iso_events *const all = step->events;
    const size_t known = ISO_HOLD_NUMBERS(all->holds->count) + all->holds->count;
    real *const from = step->holds.from.numbers, *const at = step->holds.at.numbers; /* behind them the efforts */
    ISO_UNROLL
    for (size_t i = 0; i < known; i++) {
        from[i] = iso_select(fires, at[i], from[i]);
    }
    ISO_UNROLL
    for (size_t e = all->count; e < iso_event_count(all); e++) {
        step->value[e] = iso_event_slip(step, e - all->count, step->span.from, step->span.leaving, &step->rate[e]);
    }
}

/* The first event of the span, and the rest of the step behind it. Returns all ones where one fires. */
ISO_INLINE iso_bits iso_event_slot(iso_event_step *const step)
{
    iso_span *const span = &step->span;
    const size_t n = span->n;
    const iso_holds *const holds = step->events->holds;
    step->f(span->arriving, span->to, step->u, step->held);
    const real near = holds == NULL ? R(0.0) : iso_event_near(step);
    real place = R(2.0);
    iso_bits first = ISO_NOTHING;
    ISO_UNROLL
    for (size_t e = 0; e < iso_event_count(step->events); e++) {
        const real next = iso_event_any_place(step, e, near);
        const iso_bits earlier = iso_is_negative(next - place);
        place = iso_select(earlier, next, place);
        first = iso_select_bits(earlier, (iso_bits){0} + (iso_word)e, first);
    }
    const iso_bits fires = iso_is_negative(place - R(1.5));
    place = iso_select(fires, place, R(0.0));
    iso_span_at(span, place, step->x, step->dx);
    iso_event_before(step, fires, step->x, step->dx);
    iso_event_set(step, fires, first, step->x);
    if (holds != NULL) {
        iso_event_holds(step, fires, first, step->x);
    }
    step->f(step->k, step->x, step->u, step->held);
    iso_event_behind(step, fires, first, step->x);
    const real length = (R(1.0) - place) * span->length;
    real *const end = step->dx;
    iso_event_rest(step, length, step->x, end, end);
    ISO_UNROLL
    for (size_t s = 0; s < n; s++) {
        span->from[s] = iso_select(fires, step->x[s], span->from[s]);
        span->leaving[s] = iso_select(fires, step->k[s], span->leaving[s]);
        span->to[s] = iso_select(fires, end[s], span->to[s]);
    }
    span->length = iso_select(fires, length, span->length);
    if (holds != NULL) {
        iso_event_hold_from(step, fires);
    }
    return fires;
}

/* At a start, where the holds have settled: those events are armed whose function is not below zero there. */
ISO_INLINE void iso_events_begin(const iso_events *const events, const real *const x, const real *const u,
                                 const real *const p, iso_bits *const known)
{
    ISO_UNROLL
    for (size_t e = 0; e < events->count; e++) {
        real both[2];
        events->functions[e](both, x, x, u, p);
        known[e] = ~iso_is_negative(both[0]);
    }
}

/* The functions at the end of a step: what is left of events waits, and is counted as late. */
ISO_INLINE void iso_events_end(const iso_event_step *const step, iso_event_counts *const counts)
{
    ISO_UNROLL
    for (size_t e = 0; e < step->events->count; e++) {
        real rate;
        const real end = iso_event_value(step, e, step->span.to, step->span.arriving, &rate);
        const iso_bits armed = iso_event_is_armed(step->known[e]), waits = armed & iso_is_negative(end);
        counts->late += (iso_count)(waits | (armed & iso_is_negative(step->value[e]))) & 1;
        step->known[e] = waits | iso_event_seen(step->known[e] & ~armed, end + step->zero[e], rate);
    }
    ISO_UNROLL
    for (size_t e = step->events->count; e < iso_event_count(step->events); e++) {
        real rate;
        const real end = iso_event_value(step, e, step->span.to, step->span.arriving, &rate);
        counts->late += (iso_count)iso_is_negative(end) & 1;
    }
}

/* After iso_method_step: x[n] are the states that it made, from[n] those before, which are lost, and work[] its work
 * space, which begins with the derivative at `from`. u, held and p are those of the step: inputs and memories, what the
 * derivative reads for tunables, and the tunables. room[ISO_EVENT_WORK]; known[events]. */
ISO_INLINE void iso_events_step(const unsigned recipe, const size_t n, const iso_equations *const eq,
                                const iso_events *const events, const real h, real *const x, real *const from,
                                const real *const u, const real *const held, const real *const p, real *const work,
                                real *const room, iso_bits *const known, iso_event_counts *const counts)
{
    iso_event_step step = {.events = events, .f = eq->derivative, .u = u, .held = held, .p = p, .known = known};
    step.span = (iso_span){.n = n, .length = h, .from = from, .to = x};
    step.span.leaving = iso_method_room(recipe, eq, work);
    step.span.arriving = room;
    step.x = room + n;
    step.dx = step.x + n;
    step.k = step.dx + n;
    step.value = step.k + n * events->rest->stages;
    step.rate = step.value + iso_event_count(events);
    step.zero = step.rate + iso_event_count(events);
    step.set = step.zero + iso_event_count(events);
    if (events->holds != NULL) {
        step.holds = iso_hold_room_of(events->holds, step.set + events->sets);
        iso_hold_find(events->holds, from, u, p, &step.holds.from, step.holds.work);
    }
    ISO_UNROLL
    for (size_t e = 0; e < events->count; e++) {
        step.zero[e] = R(0.0);
        step.value[e] = iso_event_value(&step, e, from, step.span.leaving, &step.rate[e]);
        known[e] = iso_event_seen(known[e], step.value[e], step.rate[e]);
    }
    ISO_UNROLL
    for (size_t e = events->count; e < iso_event_count(events); e++) {
        step.value[e] = iso_event_value(&step, e, from, step.span.leaving, &step.rate[e]);
    }
    iso_bits any = ISO_NOTHING;
    ISO_UNROLL
    for (uint8_t i = 0; i < events->slots; i++) {
        const iso_bits fires = iso_event_slot(&step);
        counts->fired += (iso_count)fires & 1;
        any |= fires;
    }
    const iso_history history = iso_history_of(recipe, n, x);
    const size_t compensated = history.compensation == NULL ? 0 : n;
    ISO_UNROLL
    for (size_t s = 0; s < compensated; s++) {
        history.compensation[s] = iso_select(any, R(0.0), history.compensation[s]);
    }
    iso_events_end(&step, counts);
}

#endif
