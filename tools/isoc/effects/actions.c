/* The actions of an effect's lines on the mechanism. A dropped effect does nothing, and its states and memories stay as
 * they are. But its formulas are evaluated, so that the memories of these formulas have the same places as with the
 * effect. */
#include "tools/isoc/effects/effects.h"

#include <string.h>

/* The line of this kind that declares the subject of a rate or a next. */
static const effect_line *subject(effect_scope *w, const instance *in, const effect_line *line, effect_line_kind kind,
                                  const char *word)
{
    const effect_line *found = line->name.text == NULL ? NULL : line_called(in->kind, line->name.text, false);
    if (found == NULL || found->kind != kind) {
        source_problem(w->b->s, line->name.at, "this effect has no %s '%s'", word, line->name.text);
        return NULL;
    }
    if (found->is_mode) {
        source_problem(w->b->s, line->name.at, "'%s' is a mode, which has no rate: 'when' changes it", line->name.text);
        return NULL;
    }
    return found;
}

quantity_kind late_quantity(effect_scope *w, const node *roots, size_t count)
{
    quantity_kind found = QUANTITY_ROWS;
    for (reached r = reach(w->b->g, roots, count); reach_next(&r);) {
        const quantity_kind kind = r.n->op == OP_QUERY ? w->b->mechanism.queries.all[r.n->index / QUERY_PARTS].kind
                                   : r.n->op == OP_DERIVATIVE ? QUANTITY_ACCELERATION
                                                              : QUANTITY_ROWS;
        found = kind < QUANTITY_ROWS && is_known_late(kind) ? kind : found;
    }
    return found;
}

/* Notes an effort or a rate that needs a quantity which is known later. */
static bool refuse_late(effect_scope *w, const effect_line *line, const node *roots, size_t count)
{
    const quantity_kind late = line->kind == EFFECT_NEXT ? QUANTITY_ROWS : late_quantity(w, roots, count);
    if (late == QUANTITY_ROWS) {
        return false;
    }
    const char *word = quantity_rows[late].word;
    if (quantity_rows[late].known == KNOWN_AFTER_STEP) {
        source_problem(w->b->s, line->value->at,
                       "'%s' is known after the step: for outputs and the next of memories, not for '%s'", word,
                       line->name.text);
    } else {
        source_problem(w->b->s, line->value->at,
                       "an algebraic loop: '%s' needs the %s, which depends on it; a memory breaks it", line->name.text,
                       word);
    }
    return true;
}

/* A formula of so many numbers of this dimension; zeros after noting a problem. */
static value value_like(effect_scope *w, const instance *in, const effect_line *line, int parts, dimension expected,
                        const char *what)
{
    source *s = w->b->s;
    value found = evaluate(w, in, line->value, line->name.text);
    if (found.count > 0 && (found.count != parts || (!found.any && !dimension_equal_but_angle(found.dim, expected)))) {
        source_problem(s, line->value->at, "%s '%s' %s; this %s", what, line->name.text,
                       found.count < parts ? "is a vector" : dimension_phrase(s->memory, expected),
                       found.count > parts   ? "is a vector"
                       : found.count < parts ? "is one number"
                                             : dimension_phrase(s->memory, found.dim));
        found.count = 0;
    }
    const bool is_good = found.count == parts && !refuse_late(w, line, found.parts, (size_t)parts);
    for (int i = 0; i < parts && !is_good; i++) {
        found.parts[i] = constant(w->b->g, 0.0);
    }
    return found;
}

/* One number of this dimension. */
static node node_of(effect_scope *w, const instance *in, const effect_line *line, dimension expected, const char *what)
{
    return value_like(w, in, line, 1, expected, what).parts[0];
}

/* The index of the effect. */
static int number_of(const effect_scope *w, const instance *in)
{
    return (int)(in - w->all);
}

static void do_rate(effect_scope *w, const instance *in, const effect_line *line)
{
    const effect_line *e = subject(w, in, line, EFFECT_STATE, "state");
    if (e != NULL && line->value != NULL) {
        dimension rate = line_value(w, in, e).dim;
        dimension_times(&rate, second, -1);
        effect_quantity *result = &w->b->mechanism.effects.states[in->bound[e - in->kind->lines].index];
        const value found = value_like(w, in, line, e->parts, rate, "the rate of");
        for (int i = 0; i < e->parts; i++) {
            result[i].effect = number_of(w, in);
            result[i].next = in->use->dropped ? constant(w->b->g, 0.0)
                                              : graph_name(w->b->g, found.parts[i], "rate_%s", result[i].about.name);
        }
    }
}

static void do_next(effect_scope *w, const instance *in, const effect_line *line)
{
    const effect_line *e = subject(w, in, line, EFFECT_MEMORY, "memory");
    if (e != NULL && line->value != NULL) {
        const dimension same = line_value(w, in, e).dim;
        const value found = value_like(w, in, line, e->parts, same, "the next");
        for (int i = 0; i < e->parts; i++) {
            const int at = in->bound[e - in->kind->lines].index + i;
            w->b->mechanism.effects.memories[at].next =
                in->use->dropped ? leaf(w->b->g, OP_INPUT, w->b->mechanism.inputs.count + at) : found.parts[i];
        }
    }
}

static void do_effort(effect_scope *w, const instance *in, const effect_line *line)
{
    const effect_line *e = subject(w, in, line, EFFECT_JOINT, "joint");
    const int l = e == NULL ? -1 : in->bound[e - in->kind->lines].segment;
    if (l >= 0 && line->value != NULL) {
        graph *g = w->b->g;
        const dimension effort = quantity_dimension(QUANTITY_EFFORT, &w->b->mechanism.segments[l]);
        const node added = graph_name(g, node_of(w, in, line, effort, "the effort on"), "effort_%s", in->use->symbol);
        if (in->use->dropped) {
            return;
        }
        effect_set *all = &w->b->mechanism.effects;
        const int along = w->b->mechanism.segments[l].dof;
        const effect_effort own = {number_of(w, in), along, added};
        all->efforts[along] = add(g, all->efforts[along], added);
        ADD_TO(w->b->s->memory, all->pushes, all->push_count, w->b->push_room, own);
        const node speed = leaf(g, OP_STATE, w->b->mechanism.position_count + along);
        in->account->power = add(g, in->account->power, mul(g, added, speed));
    }
}

static void do_account(effect_scope *w, const instance *in, const effect_line *line)
{
    const bool is_stored = line->kind == EFFECT_ENERGY;
    effect_account *e = in->account;
    if (line->value != NULL) {
        node *sum = is_stored ? &e->stored : line->kind == EFFECT_LOSS ? &e->loss : &e->work;
        const node found = node_of(w, in, line, is_stored ? joule : watt, "the");
        if (!in->use->dropped) {
            *sum = add(w->b->g, *sum, found);
            e->is_told = e->is_told || !is_stored;
        }
    }
}

/* The body that a line names, and its point; -1 where there is none. */
static int body_of(effect_scope *w, name n, vector *point)
{
    int which;
    if (!find_point(w, n.text, &which, point)) {
        source_problem(w->b->s, n.at, "this effect has no body '%s'", n.text);
    }
    return which >= 0 && w->b->mechanism.bodies.frames[which].placed ? which : -1;
}

/* The body that a frame stands on, or the body itself. */
static int body_under(builder *b, int which)
{
    matrix turned;
    vector origin;
    const int frame = which - (int)b->written->bodies.count;
    return frame < 0 ? which : stand_on(b, &b->written->frames.all[frame].on, &turned, &origin);
}

/* Adds a force, or a moment, on a body that moves. */
static void push(effect_scope *w, const instance *in, int which, vector point, const effect_line *line,
                 const value *along, double sign)
{
    graph *g = w->b->g;
    mechanism *m = &w->b->mechanism;
    const body_frame *frame = &m->bodies.frames[which];
    if (frame->segment == GROUND) {
        return;
    }
    applied_force f = {.body = body_under(w->b, which),
                       .segment = frame->segment,
                       .drive = -1,
                       .effect = number_of(w, in),
                       .in_ground = !line->in_body};
    f.point = vector_add(g, matrix_apply(g, frame->turn, point), frame->offset);
    f.force = f.moment = vector_zero(g);
    vector *to = line->kind == EFFECT_FORCE ? &f.force : &f.moment;
    for (int i = 0; i < 3; i++) {
        to->at[i] = sign < 0.0 ? neg(g, along->parts[i]) : along->parts[i];
    }
    const quantity_kind moves = line->kind == EFFECT_FORCE ? QUANTITY_VELOCITY : QUANTITY_SPIN;
    const value rate = point_query_of(w, moves, which, point, line->in_body);
    const vector moved = {{rate.parts[0], rate.parts[1], rate.parts[2]}};
    in->account->power = add(g, in->account->power, vector_dot(g, *to, moved));
    if (!f.in_ground) {
        *to = matrix_apply(g, frame->turn, *to);
    }
    ADD_TO(w->b->s->memory, m->forces.applied, m->forces.applied_count, w->b->applied_room, f);
}

/* A force or a moment on a body, and the opposite one on another. */
static void do_push(effect_scope *w, const instance *in, const effect_line *line)
{
    source *s = w->b->s;
    const dimension expected = line->kind == EFFECT_FORCE ? newton : newton_metre;
    const char *what = line->kind == EFFECT_FORCE ? "force" : "moment";
    vector point = vector_zero(w->b->g), other_point = point;
    const int which = line->name.text == NULL ? -1 : body_of(w, line->name, &point);
    const int other = line->against.text == NULL ? -1 : body_of(w, line->against, &other_point);
    const value found = line->value == NULL ? nothing : evaluate(w, in, line->value, line->name.text);
    if (found.count == 0 || which < 0) {
        return;
    }
    if (line->in_body && other >= 0) {
        source_problem(s, line->at, "a %s against another body is in the axes of the ground: leave out 'in body'",
                       what);
    } else if (found.count != 3) {
        source_problem(s, line->value->at, "the %s on '%s' is a vector (x, y, z); this is one number", what,
                       line->name.text);
    } else if (!found.any && !dimension_equal_but_angle(found.dim, expected)) {
        source_problem(s, line->value->at, "the %s on '%s' %s; this %s", what, line->name.text,
                       dimension_phrase(s->memory, expected), dimension_phrase(s->memory, found.dim));
    } else if (!refuse_late(w, line, found.parts, 3) && !in->use->dropped) {
        push(w, in, which, point, line, &found, 1.0);
        if (other >= 0) {
            push(w, in, other, other_point, line, &found, -1.0);
        }
    }
}

/* Whether a formula reads a signal, by itself or through a let. */
static bool reads_signal(const instance *in, const formula *f)
{
    const effect_line *line = f->kind == FORMULA_NAME ? line_called(in->kind, f->name, false) : NULL;
    bool is = line != NULL && line->kind == EFFECT_SIGNAL;
    if (line != NULL && line->kind == EFFECT_LET && line->value != NULL) {
        is = reads_signal(in, line->value);
    }
    for (size_t i = 0; i < f->count && !is; i++) {
        is = reads_signal(in, f->parts[i]);
    }
    return is;
}

/* Checks a condition at the defaults of the tunables; one on a signal only where that is a constant. */
static void do_require(effect_scope *w, const instance *in, const effect_line *line)
{
    source *s = w->b->s;
    const value least = evaluate(w, in, line->value, "require"), most = evaluate(w, in, line->most, "require");
    if (least.count != 1 || most.count != 1) {
        if (least.count > 1 || most.count > 1) {
            source_problem(s, line->at, "only numbers can be required, and no vector");
        }
        return;
    }
    if (can_change(w->b->g, least.parts[0]) || can_change(w->b->g, most.parts[0])) {
        if (!reads_signal(in, line->value) && !reads_signal(in, line->most)) {
            source_problem(s, line->at, "only values and signals can be required, and no state or motion");
        }
    } else if (!least.any && !most.any && !dimension_equal_but_angle(least.dim, most.dim)) {
        source_problem(s, line->at, "%s and %s cannot be compared", dimension_text(s->memory, least.dim),
                       dimension_text(s->memory, most.dim));
    } else if (!in->use->is_trial &&
               !keeps(&w->b->values, (condition){least.parts[0], most.parts[0], line->is_strict})) {
        enter(w, NULL);
        source_problem(s, in->use->name.at, "'%s' breaks what its effect requires in %s: %s", in->use->name.text,
                       source_line(s, line->at), source_quote(s, line->at));
    }
}

void check_subjects(effect_scope *w, const instance *in)
{
    enter(w, in);
    FOR_ALL (const effect_line, line, in->kind->lines, in->kind->line_count) {
        const bool is_state = line->kind == EFFECT_STATE && !line->is_mode;
        const effect_line_kind wanted = is_state ? EFFECT_RATE : EFFECT_NEXT;
        int found = 0;
        FOR_ALL (const effect_line, other, in->kind->lines, in->kind->line_count) {
            found += other->kind == wanted && name_is(other->name, line->name.text);
        }
        if ((is_state || line->kind == EFFECT_MEMORY) && found != 1) {
            source_problem(w->b->s, line->name.at, "the %s '%s' needs one %s, and has %d: %s %s = ...",
                           is_state ? "state" : "memory", line->name.text, is_state ? "rate" : "next", found,
                           is_state ? "rate" : "next", line->name.text);
        }
    }
    enter(w, NULL);
}

void do_line(effect_scope *w, const instance *in, const effect_line *line)
{
    enter(w, in);
    const row_rate before = pace(w, rate_of_line(w, in, line));
    if (line->kind == EFFECT_RATE) {
        do_rate(w, in, line);
    } else if (line->kind == EFFECT_NEXT) {
        do_next(w, in, line);
    } else if (line->kind == EFFECT_EFFORT) {
        do_effort(w, in, line);
    } else if (line->kind == EFFECT_FORCE || line->kind == EFFECT_MOMENT) {
        do_push(w, in, line);
    } else if (line->kind >= EFFECT_ENERGY && line->kind <= EFFECT_WORK) {
        do_account(w, in, line);
    } else if (line->kind == EFFECT_REQUIRE) {
        do_require(w, in, line);
    } else if (line->kind == EFFECT_FUNCTION) {
        check_function(w, line);
    } else if (line->kind > EFFECT_BODY && line->kind < EFFECT_WHEN) {
        (void)line_value(w, in, line);
    }
    pace(w, before);
    enter(w, NULL);
}
