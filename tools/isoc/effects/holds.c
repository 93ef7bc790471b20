/* Holds: hold NAME on JOINT up to LIMIT then SLIDING, of an effect and of the scene. */
#include <string.h>

#include "tools/isoc/effects/effects.h"
#include "tools/isoc/scene/names.h"

enum { MOST_HOLDS = 16 };

/* An effort that is not below zero; zero after noting a problem. */
static node effort_of(effect_scope *w, const instance *in, const hold_statement *h, const formula *f,
                      dimension of_effort)
{
    source *s = w->b->s;
    const value found = f == NULL ? nothing : evaluate(w, in, f, h->name.text);
    enter(w, in);
    const quantity_kind late = found.count == 0 ? QUANTITY_ROWS : late_quantity(w, found.parts, (size_t)found.count);
    if (late < QUANTITY_ROWS) {
        source_problem(s, f->at, "'%s' is known with all efforts, those of holds among them: a limit cannot need it",
                       quantity_rows[late].word);
    } else if (found.count > 1) {
        source_problem(s, f->at, "the limit of '%s' is one number; this is a vector", h->name.text);
    } else if (found.count == 1 && !found.any && !dimension_equal_but_angle(found.dim, of_effort)) {
        source_problem(s, f->at, "the limit of '%s' %s; this %s", h->name.text, dimension_phrase(s->memory, of_effort),
                       dimension_phrase(s->memory, found.dim));
    } else if (found.count == 1 && is_constant(w->b->g, found.parts[0]) &&
               !(constant_value(w->b->g, found.parts[0]) >= 0.0)) {
        source_problem(s, f->at, "the limit of '%s' is not below zero; this is %.6g", h->name.text,
                       constant_value(w->b->g, found.parts[0]));
    } else if (found.count == 1) {
        return larger(w->b->g, found.parts[0], constant(w->b->g, 0.0));
    }
    return constant(w->b->g, 0.0);
}

/* Notes a hold that an earlier one makes needless, and speeds that have no difference. */
static void check_speeds(effect_scope *w, const held_speed *h, const segment *on, const segment *against)
{
    source *s = w->b->s;
    FOR_ALL (const held_speed, other, w->b->mechanism.events.holds, w->b->mechanism.events.hold_count) {
        const bool is_same = (other->dof == h->dof && other->against == h->against) ||
                             (other->dof == h->against && other->against == h->dof);
        if (is_same) {
            source_problem(s, h->at, "'%s' in %s holds the same speed: write one hold up to the sum of both limits",
                           other->called, source_line(s, other->at));
        }
    }
    if (against == on) {
        source_problem(s, h->at, "a hold between a joint and itself holds nothing: take another joint");
    } else if (against != NULL && !dimension_equal(coordinate_dimension(on), coordinate_dimension(against))) {
        source_problem(s, h->at, "'%s' slides and '%s' turns, or the other way round: their speeds have no difference",
                       on->name, against->name);
    }
}

/* What it takes from the mechanism while it slips. */
static void add_power(effect_scope *w, const instance *in, const held_speed *h)
{
    graph *g = w->b->g;
    const mechanism *m = &w->b->mechanism;
    node speed = leaf(g, OP_STATE, m->position_count + h->dof);
    if (h->against >= 0) {
        speed = sub(g, speed, leaf(g, OP_STATE, m->position_count + h->against));
    }
    const node effort = mul(g, leaf(g, OP_STATE, h->state), h->sliding);
    in->account->power = sub(g, in->account->power, mul(g, effort, speed));
}

static void build_hold(effect_scope *w, const instance *in, const hold_statement *written, int number)
{
    builder *b = w->b;
    mechanism *m = &b->mechanism;
    event_list *all = &m->events;
    const instance *before = enter(w, in);
    const bool is_between = written->against.text != NULL;
    const int on = segment_of(w, written->on), against = is_between ? segment_of(w, written->against) : -1;
    if (on >= 0 && (against >= 0 || !is_between)) {
        const segment *l = &m->segments[on], *other = is_between ? &m->segments[against] : NULL;
        const dimension of_effort = quantity_dimension(QUANTITY_EFFORT, l);
        held_speed h = {.called = written->name.text,
                        .at = written->name.at,
                        .effect = in == NULL ? -1 : (int)(in - w->all),
                        .state = m->effects.first_state + number,
                        .dof = l->dof,
                        .against = is_between ? other->dof : -1};
        check_speeds(w, &h, l, other);
        h.limit = effort_of(w, in, written, written->limit, of_effort);
        h.sliding = written->sliding == NULL ? h.limit : effort_of(w, in, written, written->sliding, of_effort);
        if (in != NULL) {
            add_power(w, in, &h);
        }
        ADD_TO(b->s->memory, all->holds, all->hold_count, all->hold_room, h);
    }
    enter(w, before);
}

const held_speed *hold_of_state(const mechanism *m, int number)
{
    FOR_ALL (const held_speed, h, m->events.holds, m->events.hold_count) {
        if (h->state == number) {
            return h;
        }
    }
    return NULL;
}

void build_holds(effect_scope *w)
{
    const builder *b = w->b;
    FOR_ALL (const instance, in, w->all, b->written->effects.count) {
        for (size_t i = 0; in->kind != NULL && !in->use->left_out && i < in->kind->line_count; i++) {
            const effect_line *line = &in->kind->lines[i];
            if (line->kind == EFFECT_HOLD) {
                const effect_line *mode = line_called(in->kind, line->hold->name.text, false);
                build_hold(w, in, line->hold, in->bound[mode - in->kind->lines].index);
            }
        }
    }
    FOR_EACH (const hold_statement, written, b->written->events.holds) {
        build_hold(w, NULL, written, w->first_mode + INDEX_OF(b->written->events.modes, written->name.text));
    }
    if (b->mechanism.events.hold_count > MOST_HOLDS) {
        source_problem(b->s, b->mechanism.events.holds[MOST_HOLDS].at, "more than %d holds", MOST_HOLDS);
    }
    FOR_ALL (const held_speed, h, b->mechanism.events.holds, b->mechanism.events.hold_count) {
        if (h->against >= 0 && b->mechanism.closure_count > 0) {
            source_problem(b->s, h->at,
                           "with closures a hold is of one joint: leave them out, or hold each of the two by itself");
        }
    }
}
