/* QUANTITY of NAME: a quantity of a joint, a body or an effect in a formula of an effect, a signal or an output; and
 * quantities of the whole mechanism, as energy. */
#include <string.h>

#include "tools/isoc/effects/effects.h"
#include "tools/isoc/scene/names.h"

/* A query of this kind, without an owner so far. */
static query query_of(effect_scope *w, quantity_kind kind)
{
    return (query){.kind = kind,
                   .segment = -1,
                   .body = -1,
                   .closure = -1,
                   .spring = -1,
                   .effect = -1,
                   .hold = -1,
                   .point = vector_zero(w->b->g)};
}

/* The numbers of a quantity, as leaves. */
static value leaves_of(effect_scope *w, query q)
{
    mechanism *m = &w->b->mechanism;
    value found = {.count = quantity_parts(&quantity_rows[q.kind]), .dim = dimension_of_unit(query_unit(m, &q))};
    for (int i = 0; i < found.count; i++) {
        found.parts[i] = leaf(w->b->g, OP_QUERY, QUERY_PARTS * m->queries.count + i);
    }
    LIST_ADD(w->b->s->memory, m->queries, q);
    return found;
}

value point_query_of(effect_scope *w, quantity_kind kind, int which, vector point, bool in_body)
{
    query q = query_of(w, kind);
    q.body = which;
    q.point = point;
    q.in_body = in_body;
    return leaves_of(w, q);
}

/* Whether the answer is in the axes of the body, which the formula may choose. */
static bool in_body_axes(effect_scope *w, const formula *f, bool by_default)
{
    const bool is_body = f->axes.text != NULL && strcmp(f->axes.text, "body") == 0;
    if (f->axes.text != NULL && !is_body && strcmp(f->axes.text, "ground") != 0) {
        source_problem(w->b->s, f->axes.at, "expected 'in body' or 'in ground', the axes that it is in");
    }
    return f->axes.text == NULL ? by_default : is_body;
}

/* A constant vector behind `at`; false after noting a problem. */
static bool find_beside(effect_scope *w, const formula *f, bool of_inertia, vector *beside)
{
    source *s = w->b->s;
    graph *g = w->b->g;
    const value found = value_any(&w->b->values, f);
    if (found.count == 0) {
        return false;
    }
    if (found.count != 3 || (!found.any && !dimension_equal_but_angle(found.dim, metre))) {
        return source_problem(s, f->at, "expected a vector (x, y, z) m, from the point of the body");
    }
    for (int i = 0; i < 3; i++) {
        beside->at[i] = found.parts[i];
        if (can_change(g, found.parts[i]) || uses_operation(g, &found.parts[i], 1, OP_INERTIA)) {
            return source_problem(s, f->at, "%s'at' is a constant or a tunable",
                                  of_inertia ? "the inertia is that at the start: " : "");
        }
    }
    return true;
}

/* inertia of BODY: the mass that a force along each axis alone accelerates at the start; three masses. */
static value inertia_of_point(effect_scope *w, const formula *f, int which, vector point)
{
    mechanism *m = &w->b->mechanism;
    inertia_query q = {which, point, vector_zero(w->b->g), in_body_axes(w, f, false)};
    if (which < 0 || !m->bodies.frames[which].placed ||
        (f->count > 1 && !find_beside(w, f->parts[1], true, &q.beside))) {
        return nothing;
    }
    if (m->bodies.frames[which].segment == GROUND) {
        return REFUSED(w->b->s, f->parts[0]->at, "'%s' is a part of the ground: no force moves it", f->parts[0]->name);
    }
    const int first = m->dof_count + 3 * (int)m->queries.inertias.count;
    LIST_ADD(w->b->s->memory, m->queries.inertias, q);
    value found = {.count = 3, .dim = kilogram};
    for (int i = 0; i < 3; i++) {
        found.parts[i] = leaf(w->b->g, OP_INERTIA, first + i);
    }
    return found;
}

/* --- the operand of a quantity: false after noting a problem --- */

/* `at`, `in` and `along`, where it has a point, axes or components. */
static bool check_parts(effect_scope *w, const formula *f, const quantity_row *row)
{
    source *s = w->b->s;
    const size_t before = s->problem_count;
    if (f->count > 1 && !quantity_has_point(row)) {
        source_problem(s, f->parts[1]->at, "'at' is only for the %s", quantity_list(s->memory, quantity_has_point));
    }
    if (f->axes.text != NULL && (row->asks & IN_AXES) == 0) {
        source_problem(s, f->axes.at, "only a velocity, a spin, a specific force and an inertia have axes to choose");
    }
    if (f->along.text != NULL && !quantity_has_parts(row)) {
        source_problem(s, f->along.at, "'along' is only for vectors: the %s",
                       quantity_list(s->memory, quantity_has_parts));
    }
    return s->problem_count == before;
}

/* position of BODY, and the like */
static bool find_of_point(effect_scope *w, const formula *f, query *q)
{
    q->kind = quantity_called(f->name, OF_BODY);
    if (q->kind == QUANTITY_ROWS) {
        return source_problem(w->b->s, f->at, "a body has no %s: its %s", f->name,
                              quantity_words(w->b->s->memory, OF_BODY, OF_BODY));
    }
    if (q->kind == QUANTITY_INERTIA_OF_POINT) {
        return true;
    }
    const asking asks = quantity_rows[q->kind].asks;
    vector beside = vector_zero(w->b->g);
    q->in_body = in_body_axes(w, f, (asks & OF_BODY_AXES) != 0);
    if (q->body < 0 || !w->b->mechanism.bodies.frames[q->body].placed ||
        (f->count > 1 && !find_beside(w, f->parts[1], false, &beside))) {
        return false;
    }
    q->point = vector_add(w->b->g, q->point, beside);
    return true;
}

/* The body that the joint of a segment carries: its own segments lead from that body's to the parent's. */
static int child_of(const mechanism *m, int at)
{
    int found = -1;
    for (int child = 0; child < m->bodies.count; child++) {
        const member *entry = &m->bodies.members[child];
        const int stop = entry->parent == GROUND ? GROUND : m->bodies.frames[entry->parent].segment;
        for (int i = m->bodies.frames[child].segment; m->bodies.frames[child].placed && i != stop;
             i = m->segments[i].parent) {
            found = i == at ? child : found;
        }
    }
    return found;
}

/* force of JOINT, moment of CLOSURE and the like: a fixed joint, which is no operand of an effect, is one of the scene.
 */
static bool find_reaction(effect_scope *w, const formula *f, query *q)
{
    builder *b = w->b;
    const name called = {f->parts[0]->name, f->parts[0]->at};
    if (w->within == NULL) {
        find_connection(b, called, &q->body, &q->closure);
    } else {
        const int l = segment_of(w, called);
        q->body = l < 0 ? -1 : child_of(&b->mechanism, l);
    }
    return q->closure >= 0 || (q->body >= 0 && b->mechanism.bodies.frames[q->body].placed);
}

/* The hold that is called so, of the effect or of the scene, and its mode among the states of effects. */
static const hold_statement *find_hold(const effect_scope *w, const char *called, int *mode)
{
    const event_statements *written = &w->b->written->events;
    if (w->within == NULL) {
        const int i = INDEX_OF(written->holds, called);
        *mode = i < 0 ? -1 : w->first_mode + INDEX_OF(written->modes, called);
        return i < 0 ? NULL : &written->holds.all[i];
    }
    const effect_kind *kind = w->within->kind;
    FOR_ALL (const effect_line, line, kind->lines, kind->line_count) {
        if (line->kind == EFFECT_HOLD && name_is(line->hold->name, called)) {
            const int index = w->within->bound[line_called(kind, called, false) - kind->lines].index;
            *mode = index < 0 ? w->b->mechanism.effects.state_count : index;
            return line->hold;
        }
    }
    return NULL;
}

/* effort of a gear, a motion or a spring, which are no operands of effects; or of a hold. */
static bool find_effort(effect_scope *w, const formula *f, query *q)
{
    const name called = {f->parts[0]->name, f->parts[0]->at};
    int mode;
    const hold_statement *held = find_hold(w, called.text, &mode);
    if (held != NULL) {
        q->hold = mode;
        q->segment = segment_of(w, held->on);
        return q->segment >= 0;
    }
    if (w->within != NULL) {
        return source_problem(w->b->s, f->at,
                              "a definition cannot read the effort of '%s': an operand of the kind signal can",
                              called.text);
    }
    return find_transmission(w->b, called, &q->closure, &q->spring);
}

/* position of JOINT, and the like */
static bool find_of_coordinate(effect_scope *w, const formula *f, query *q)
{
    q->kind = quantity_called(f->name, OF_COORDINATE);
    const name owner = {f->parts[0]->name, f->parts[0]->at};
    bool is_joint;
    if (w->within == NULL && segment_called(&w->b->mechanism, owner) < 0 &&
        find_joint_or_body(w->b->s, w->b->written, owner, &is_joint) < 0) {
        return false;
    }
    q->segment = segment_of(w, owner);
    if (q->segment >= 0 && q->kind == QUANTITY_ROWS) {
        source_problem(w->b->s, f->at, "a joint has no %s: its %s", f->name,
                       quantity_words(w->b->s->memory, OF_COORDINATE, OF_CONNECTION));
    }
    return q->segment >= 0 && q->kind < QUANTITY_ROWS && counts_turns(w->b, q, f->at);
}

static bool find_query(effect_scope *w, const formula *f, query *q)
{
    const quantity_kind of_connection = quantity_called(f->name, OF_CONNECTION);
    const quantity_kind of_transmission = quantity_called(f->name, OF_TRANSMISSION);
    *q = query_of(w, of_connection < QUANTITY_ROWS ? of_connection : of_transmission);
    const bool is = q->kind == of_connection && q->kind < QUANTITY_ROWS     ? find_reaction(w, f, q)
                    : q->kind < QUANTITY_ROWS                               ? find_effort(w, f, q)
                    : find_point(w, f->parts[0]->name, &q->body, &q->point) ? find_of_point(w, f, q)
                                                                            : find_of_coordinate(w, f, q);
    return is && check_parts(w, f, &quantity_rows[q->kind]);
}

/* --- and its value --- */

static value value_of_query(effect_scope *w, const formula *f, const query *q)
{
    graph *g = w->b->g;
    const mechanism *m = &w->b->mechanism;
    const segment *l = q->segment < 0 ? NULL : &m->segments[q->segment];
    const node is = q->kind == QUANTITY_POSITION       ? leaf(g, OP_STATE, l->position)
                    : q->kind == QUANTITY_SPEED        ? leaf(g, OP_STATE, m->position_count + l->dof)
                    : q->kind == QUANTITY_ACCELERATION ? leaf(g, OP_DERIVATIVE, m->position_count + l->dof)
                    : q->kind == QUANTITY_INERTIA      ? leaf(g, OP_INERTIA, l->dof)
                                                       : -1;
    return is >= 0 ? (value){.count = 1, .parts = {is}, .dim = dimension_of_unit(query_unit(m, q))}
           : q->kind == QUANTITY_INERTIA_OF_POINT ? inertia_of_point(w, f, q->body, q->point)
                                                  : leaves_of(w, *q);
}

/* power, energy, loss and work of EFFECT, in formulas of the scene: leaves until all its actions are known. */
static value account_value(effect_scope *w, const formula *f, quantity_kind kind)
{
    const char *called = f->parts[0]->name;
    const int i = INDEX_OF(w->b->written->effects, whole_name(w, called));
    if (w->within != NULL && i < 0) {
        return REFUSED(w->b->s, f->at,
                       "a definition can read the %s of its parts, not that of '%s': an operand of the kind signal can",
                       f->name, called);
    }
    if (!check_parts(w, f, &quantity_rows[kind])) {
        return nothing;
    }
    if (i < 0) {
        return REFUSED(w->b->s, f->at, "no effect is called '%s'%s", called,
                       suggest_effect(w->b->s, w->b->written, called));
    }
    const instance *in = &w->all[i];
    const node part = account_with_parts(w->b->g, &w->b->mechanism.effects, i, kind);
    query q = query_of(w, kind);
    q.effect = i;
    return in->kind == NULL ? nothing
           : w->is_done     ? (value){.count = 1, .parts = {part}, .dim = dimension_of_unit(quantity_rows[kind].unit)}
                            : leaves_of(w, q);
}

value quantity_value(void *context, const formula *f)
{
    effect_scope *w = context;
    const quantity_kind of_effect = quantity_called(f->name, OF_EFFECT);
    query q;
    const value whole = of_effect < QUANTITY_ROWS ? account_value(w, f, of_effect)
                        : find_query(w, f, &q)    ? value_of_query(w, f, &q)
                                                  : nothing;
    const bool is_part = f->along.text != NULL && whole.count >= 3;
    const int part = is_part ? f->along.text[0] == 'w' ? 0 : f->along.text[0] - 'x' + (whole.count == 4) : 0;
    return is_part ? (value){.count = 1, .parts = {whole.parts[part]}, .dim = whole.dim} : whole;
}

bool find_quantity(effect_scope *w, const formula *f, value *found)
{
    const quantity_kind kind = quantity_of_nothing(f->name); /* of the mechanism, its closures or the step */
    if (kind < QUANTITY_ROWS) {
        *found = is_of_plant(w->b, kind, f->at) ? leaves_of(w, query_of(w, kind)) : nothing;
    }
    return kind < QUANTITY_ROWS;
}

bool find_shown(builder *b, const formula *f, query *q)
{
    effect_scope *w = b->around->context;
    *q = query_of(w, f->kind == FORMULA_NAME ? quantity_of_nothing(f->name) : QUANTITY_ROWS);
    if (q->kind < QUANTITY_ROWS) {
        (void)is_of_plant(b, q->kind, f->at);
        return true;
    }
    if (f->kind != FORMULA_OF || quantity_called(f->name, OF_EFFECT) < QUANTITY_ROWS ||
        quantity_called(f->name, OF_BODY) == QUANTITY_INERTIA_OF_POINT) {
        return false;
    }
    b->values.around = b->around;
    if (!find_query(w, f, q)) {
        q->kind = QUANTITY_ROWS;
    }
    b->values.around = NULL;
    return true;
}
