/* Events: when CONDITION { set NAME = VALUE; ... }, of an effect and of the scene. A condition is a function that falls
 * below zero; what is set is a state, a mode, or the position or the speed of a joint. */
#include <string.h>

#include "tools/isoc/effects/effects.h"
#include "tools/isoc/formula/condition.h"
#include "tools/isoc/scene/names.h"

enum { MOST_EVENTS = 250, MOST_SLOTS = 16 };

/* Notes what is not known at the time of an event. */
static bool refuse_after_event(effect_scope *w, const formula *f, const value *found)
{
    const quantity_kind late = late_quantity(w, found->parts, (size_t)found->count);
    return late < QUANTITY_ROWS &&
           !source_problem(w->b->s, f->at,
                           "'%s' is known after the event: an event reads states, positions, speeds, inputs and modes",
                           quantity_rows[late].word);
}

/* The numbers that a set gives to something of this dimension; count 0 after noting a problem. */
static value value_for(effect_scope *w, const instance *in, const set_statement *set, int parts, dimension expected)
{
    source *s = w->b->s;
    const value found = set->value == NULL ? nothing : evaluate(w, in, set->value, set->what.text);
    enter(w, in);
    if (found.count == 0 || refuse_after_event(w, set->value, &found)) {
        return nothing;
    }
    if (found.count != parts) {
        return REFUSED(s, set->value->at, "'%s' is %s; this is %s", set->what.text,
                       parts == 1 ? "one number" : "a vector (x, y, z)", parts == 1 ? "a vector" : "one number");
    }
    if (!found.any && !dimension_equal_but_angle(found.dim, expected)) {
        return REFUSED(s, set->value->at, "'%s' %s; this %s", set->what.text, dimension_phrase(s->memory, expected),
                       dimension_phrase(s->memory, found.dim));
    }
    return found;
}

/* Adds what an event sets, once for each state. */
static void add_set(effect_scope *w, event *to, event_set set)
{
    FOR_ALL (const event_set, other, to->sets, to->set_count) {
        if (other->state == set.state && set.speed < 0) {
            source_problem(w->b->s, set.at, "this event sets it twice");
            return;
        }
    }
    ADD_TO(w->b->s->memory, to->sets, to->set_count, to->set_room, set);
}

/* set speed of JOINT, set position of JOINT */
static void set_coordinate(effect_scope *w, const instance *in, const set_statement *set, event *to)
{
    const mechanism *m = &w->b->mechanism;
    const int i = segment_of(w, set->what);
    if (i < 0) {
        return;
    }
    const segment *l = &m->segments[i];
    const bool is_speed = strcmp(set->which, "speed") == 0;
    const quantity_kind kind = quantity_called(set->which, OF_COORDINATE);
    if (!is_speed && m->closure_count > 0) {
        source_problem(w->b->s, set->what.at,
                       "closures hold the positions: an event sets a speed, a state or a mode of this scene");
        return;
    }
    const value found = value_for(w, in, set, 1, quantity_dimension(kind, l));
    if (found.count == 1) {
        add_set(w, to,
                (event_set){.state = is_speed ? m->position_count + l->dof : l->position,
                            .dof = is_speed ? l->dof : -1,
                            .speed = -1,
                            .to = found.parts[0],
                            .at = set->what.at});
    }
}

/* set velocity of BODY along VECTOR: of the point of the body. */
static void set_velocity(effect_scope *w, const instance *in, const set_statement *set, event *to)
{
    builder *b = w->b;
    int which;
    vector point;
    enter(w, in);
    if (!find_point(w, set->what.text, &which, &point)) {
        source_problem(b->s, set->what.at, "no body is called '%s': a velocity is of a body, a speed of a joint",
                       set->what.text);
        return;
    }
    const value along = set->along == NULL ? nothing : value_of(&b->values, set->along, no_unit, 3, "a direction");
    const value velocity = point_query_of(w, QUANTITY_VELOCITY, which, point, false);
    const value found = value_for(w, in, set, 1, velocity.dim);
    if (found.count == 1 && along.count == 3 && !refuse_after_event(w, set->along, &along)) {
        const vector v = {{velocity.parts[0], velocity.parts[1], velocity.parts[2]}};
        const node speed = vector_dot(b->g, v, (vector){{along.parts[0], along.parts[1], along.parts[2]}});
        add_set(w, to, (event_set){.state = -1, .dof = -1, .speed = speed, .to = found.parts[0], .at = set->what.at});
    }
}

/* Sets so many states from the first on. */
static void set_states(effect_scope *w, const instance *in, const set_statement *set, int first, int parts,
                       dimension expected, event *to)
{
    const mechanism *m = &w->b->mechanism;
    const value found = value_for(w, in, set, parts, expected);
    if (hold_of_state(m, m->effects.first_state + first) != NULL) {
        source_problem(w->b->s, set->what.at, "'%s' is a hold, which changes by itself: set what its limit reads",
                       set->what.text);
        return;
    }
    for (int i = 0; i < found.count; i++) {
        const bool is_mode = m->effects.states[first + i].is_mode;
        add_set(w, to,
                (event_set){.state = m->effects.first_state + first + i,
                            .dof = -1,
                            .speed = -1,
                            .to = is_mode ? whole_node(w, set->value->at, set->what.text, &found) : found.parts[i],
                            .at = set->what.at});
    }
}

/* set NAME: a state or a mode of the effect, or a mode of the scene. */
static void set_named(effect_scope *w, const instance *in, const set_statement *set, event *to)
{
    source *s = w->b->s;
    const effect_line *line = in == NULL ? NULL : line_called(in->kind, set->what.text, false);
    const int mode = in == NULL ? INDEX_OF(w->b->written->events.modes, set->what.text) : -1;
    if (mode >= 0) {
        set_states(w, in, set, w->first_mode + mode, 1, no_unit, to);
    } else if (line != NULL && line->kind == EFFECT_STATE) {
        const dimension is = line_value(w, in, line).dim;
        set_states(w, in, set, in->bound[line - in->kind->lines].index, line->parts, is, to);
    } else if (line != NULL && line->kind == EFFECT_MEMORY) {
        source_problem(s, set->what.at,
                       "'%s' is a memory, which its next sets once a row: an event sets a state or a "
                       "mode; rate %s = 0 makes a state that events alone change",
                       set->what.text, set->what.text);
    } else {
        source_problem(s, set->what.at,
                       in == NULL ? "the scene has no mode '%s': write 'mode %s = 0'"
                                  : "this effect has no state or mode '%s': write 'mode %s = 0' in it",
                       set->what.text, set->what.text);
    }
}

/* Warns of a condition on the time, or on another function of it in a formula: within a step it is constant. */
static void warn_of_time(effect_scope *w, const when_statement *when, const value *function_of_event)
{
    const builder *b = w->b;
    bool *is_read = arena_take(b->s->memory, (size_t)held_count(&b->mechanism) + 1, sizeof *is_read);
    bool any = false;
    mark_leaves(b->g, function_of_event->parts, 1, OP_INPUT, is_read);
    for (int i = (int)b->written->inputs.count; i < b->mechanism.inputs.count; i++) {
        any = any || is_read[i];
    }
    if (any) {
        source_warn(
            b->s, when->condition->at,
            "a function of time is that of the begin of a step, so that this event is up to a step late; the time "
            "within a step is a state: state now s = 0 s; rate now = 1");
    }
}

static void build_event(effect_scope *w, const instance *in, const when_statement *when)
{
    builder *b = w->b;
    event_list *all = &b->mechanism.events;
    event result = {.at = when->at, .function = constant(b->g, 0.0)};
    enter(w, in);
    const value is = when->condition == NULL ? nothing : condition_function(&b->values, when->condition);
    if (is.count == 1 && !refuse_after_event(w, when->condition, &is)) {
        result.function = is.parts[0];
        warn_of_time(w, when, &is);
    }
    FOR_EACH (const set_statement, set, when->sets) {
        if (set->along != NULL) {
            set_velocity(w, in, set, &result);
        } else if (set->which != NULL) {
            set_coordinate(w, in, set, &result);
        } else {
            set_named(w, in, set, &result);
        }
    }
    enter(w, NULL);
    if (all->count == MOST_EVENTS) {
        source_problem(b->s, when->at, "too many events: a plant has at most %d", MOST_EVENTS);
    }
    ADD_TO(b->s->memory, all->all, all->count, all->room, result);
}

/* --- what events do not go with --- */

/* Notes features of the scene that a step with events does not have. */
static void check_features(builder *b)
{
    source *s = b->s;
    const mechanism *m = &b->mechanism;
    const place at = place_of_events(m);
    const unsigned recipe = m->method.recipe;
    if (!ISO_IS_EXPLICIT(recipe) && !ISO_IS(recipe, ISO_SEMI_IMPLICIT)) {
        source_problem(s, at, "events are for semi_implicit and the methods %s; with %s leave them out",
                       explicit_methods(s->memory), method_names[ISO_METHOD_OF(recipe)]);
    }
    if (ISO_IS_CHECKED(recipe)) {
        source_problem(s, at, "the local error is that of steps without events: leave out the events, or the check");
    }
    if (m->drift.near_holds) {
        source_problem(s, at,
                       "'near hold' keeps the energy that events take: leave out the events, or take 'near count'");
    }
    if (m->policies.rung_count > 0) {
        source_problem(s, at, "a ladder of methods has no events: leave out the events, or 'overrun degrade'");
    }
    FOR_EACH (const quantity, q, b->written->inputs) {
        if (q->smooth) {
            source_problem(s, q->name.at,
                           "a smooth input is for steps without events: let it be held; a state x with rate x = 1, and "
                           "sin(w * x), is smooth too");
        }
    }
    FOR_EACH (const effect_use, use, b->written->effects) {
        if (use->substeps != NULL && !use->left_out) {
            source_problem(s, use->substeps->at,
                           "sub-steps of an effect are for steps without events: leave them out, or give the whole "
                           "scene 'substeps'");
        }
    }
}

/* events NUMBER rest METHOD */
static void build_options(builder *b)
{
    const event_statements *written = &b->written->events;
    event_list *to = &b->mechanism.events;
    to->slots = (int)whole_number(b, written->slots, "the number of events in a step", "", 1.0, 1.0, MOST_SLOTS);
    to->rest = written->rest.text == NULL ? ISO_HEUN : find_method(b, written->rest);
    if (!ISO_IS_EXPLICIT(to->rest)) {
        source_problem(b->s, written->rest.at, "the rest of a step is by %s", explicit_methods(b->s->memory));
    }
}

void build_events(builder *b)
{
    effect_scope *w = b->around->context;
    b->values.around = b->around;
    build_holds(w);
    FOR_ALL (const instance, in, w->all, b->written->effects.count) {
        if (in->kind != NULL && !in->use->left_out) {
            FOR_ALL (const effect_line, line, in->kind->lines, in->kind->line_count) {
                if (line->kind == EFFECT_WHEN) {
                    build_event(w, in, line->when);
                }
            }
        }
    }
    FOR_EACH (const when_statement, when, b->written->events.whens) {
        build_event(w, NULL, when);
    }
    b->values.around = NULL;
    build_loss(b);
    build_options(b);
    if (has_events(&b->mechanism)) {
        check_features(b);
    }
}
