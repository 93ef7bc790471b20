/* Modes: states that are whole numbers, with a rate of zero; events alone change them. */
#include <math.h>

#include "tools/isoc/effects/effects.h"

node whole_node(effect_scope *w, place at, const char *called, const value *found)
{
    graph *g = w->b->g;
    const double most = w->b->mechanism.is_double ? 9007199254740992.0 : 16777216.0;
    if (!is_constant(g, found->parts[0])) {
        return function(g, OP_ROUND, found->parts[0], found->parts[0]);
    }
    const double number = constant_value(g, found->parts[0]);
    if (number != floor(number) || !(fabs(number) <= most)) {
        source_problem(w->b->s, at,
                       "'%s' is a mode, a whole number; this is %.6g: a state without a rate of its own "
                       "(rate x = 0) can be any number",
                       called, number);
    }
    return found->parts[0];
}

void build_loss(builder *b)
{
    mechanism *m = &b->mechanism;
    const node zero = constant(b->g, 0.0);
    if (m->events.loss_state >= 0) {
        m->effects.states[m->events.loss_state - m->effects.first_state] = (effect_quantity){
            .about = unlimited("event_loss", "J", NULL), .effect = -1, .begin = zero, .next = zero, .is_mode = true};
    }
}

value mode_value(effect_scope *w, size_t i)
{
    builder *b = w->b;
    const quantity *q = &b->written->events.modes.all[i];
    const int at = w->first_mode + (int)i;
    effect_quantity *is = &b->mechanism.effects.states[at];
    const value found = {.count = 1, .parts = {leaf(b->g, OP_STATE, b->mechanism.effects.first_state + at)}};
    if (w->is_mode_known[i]) {
        return found;
    }
    w->is_mode_known[i] = true;
    const value start = q->value == NULL ? nothing : evaluate(w, NULL, q->value, q->name.text);
    const node zero = constant(b->g, 0.0);
    is->about = unlimited(q->name.text, "1", source_quote(b->s, q->name.at));
    *is = (effect_quantity){.about = is->about, .at = q->name.at, .effect = -1, .begin = zero, .next = zero};
    is->is_mode = true;
    if (start.count == 1 && (start.any || dimension_equal_but_angle(start.dim, no_unit))) {
        is->begin = whole_node(w, q->value->at, q->name.text, &start);
    } else if (start.count > 0) {
        source_problem(b->s, q->value->at, "'%s' is a mode, a whole number; this %s", q->name.text,
                       start.count > 1 ? "is a vector" : dimension_phrase(b->s->memory, start.dim));
    }
    return found;
}
