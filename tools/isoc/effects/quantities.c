/* QUANTITY of NAME: what a formula of an effect, a signal or an output asks of a joint, a body or an effect. */
#include <string.h>

#include "tools/isoc/effects/effects.h"
#include "tools/isoc/graph/operations.h"
#include "tools/isoc/scene/names.h"

static const struct {
    const char *word;
    point_query_kind kind;
    dimension unit;
} of_bodies[] = {
    {"position", QUERY_POSITION, {0, 1, 0, 0, 0, 0, 0}},
    {"velocity", QUERY_VELOCITY, {0, 1, -1, 0, 0, 0, 0}},
    {"spin", QUERY_SPIN, {0, 0, -1, 1, 0, 0, 0}},
    {"x_axis", QUERY_X_AXIS, {0, 0, 0, 0, 0, 0, 0}},
    {"y_axis", QUERY_Y_AXIS, {0, 0, 0, 0, 0, 0, 0}},
    {"z_axis", QUERY_Z_AXIS, {0, 0, 0, 0, 0, 0, 0}},
    {"specific_force", QUERY_SPECIFIC_FORCE, {0, 1, -2, 0, 0, 0, 0}},
};

static vector leaves_of(effect_scope *w, point_query p)
{
    mechanism *m = &w->b->mechanism;
    vector leaves;
    m->queries.points = arena_grow(w->b->s->memory, m->queries.points, (size_t)m->queries.point_count,
                                   &m->queries.point_room, sizeof *m->queries.points);
    m->queries.points[m->queries.point_count] = p;
    for (int i = 0; i < 3; i++) {
        leaves.at[i] = leaf(w->b->g, OP_POINT_QUERY, 3 * m->queries.point_count + i);
    }
    m->queries.point_count++;
    return leaves;
}

vector point_query_of(effect_scope *w, point_query_kind kind, int which, vector point, bool in_body)
{
    return leaves_of(w, (point_query){kind, which, point, in_body, -1});
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

/* A constant vector from the point of a body; false after noting a problem. */
static bool find_beside(effect_scope *w, const formula *f, vector *beside)
{
    source *s = w->b->s;
    graph *g = w->b->g;
    const value found = value_any(&w->b->values, f);
    if (found.count == 0) {
        return false;
    }
    if (found.count != 3 || (!found.any && !dimension_equal_but_angle(found.of, metre))) {
        source_problem(s, f->at, "expected a vector (x, y, z) m, from the point of the body");
        return false;
    }
    for (int i = 0; i < 3; i++) {
        beside->at[i] = found.parts[i];
        if (can_change(g, found.parts[i]) || uses_operation(g, &found.parts[i], 1, OP_INERTIA)) {
            source_problem(s, f->at, "the inertia is that at the start: 'at' is a constant or a tunable");
            return false;
        }
    }
    return true;
}

/* inertia of BODY: what a force along each axis alone moves at the start, as three masses. */
static value inertia_of_point(effect_scope *w, const formula *f, int which, vector point)
{
    mechanism *m = &w->b->mechanism;
    inertia_query q = {which, point, vector_zero(w->b->g), in_body_axes(w, f, false)};
    if (which < 0 || !m->bodies.frames[which].placed || (f->count > 1 && !find_beside(w, f->parts[1], &q.beside))) {
        return nothing;
    }
    if (m->bodies.frames[which].segment == GROUND) {
        source_problem(w->b->s, f->parts[0]->at, "'%s' is a part of the ground: no force moves it", f->parts[0]->name);
        return nothing;
    }
    const int first = m->dof_count + 3 * m->queries.inertia_count;
    m->queries.inertias = arena_grow(w->b->s->memory, m->queries.inertias, (size_t)m->queries.inertia_count,
                                     &m->queries.inertia_room, sizeof *m->queries.inertias);
    m->queries.inertias[m->queries.inertia_count++] = q;
    value found = {.count = 3, .of = kilogram};
    for (int i = 0; i < 3; i++) {
        found.parts[i] = leaf(w->b->g, OP_INERTIA, first + i);
    }
    return found;
}

/* position of BODY, and the like */
static value point_value(effect_scope *w, const formula *f, int which, vector point)
{
    const mechanism *m = &w->b->mechanism;
    const size_t count = sizeof of_bodies / sizeof of_bodies[0];
    size_t row = 0;
    while (row < count && strcmp(f->name, of_bodies[row].word) != 0) {
        row++;
    }
    if (row == count) {
        source_problem(
            w->b->s, f->at,
            "a body has no %s: its position, velocity, spin, specific_force, inertia, x_axis, y_axis or z_axis",
            f->name);
    }
    const bool is_measured =
        row < count && (of_bodies[row].kind == QUERY_SPIN || of_bodies[row].kind == QUERY_SPECIFIC_FORCE);
    const bool in_body = in_body_axes(w, f, is_measured);
    if (row < count && f->axes.text != NULL && of_bodies[row].kind != QUERY_VELOCITY && !is_measured) {
        source_problem(w->b->s, f->axes.at, "only a velocity, a spin and a specific force have axes to choose");
    }
    if (row == count || which < 0 || !m->bodies.frames[which].placed) {
        return nothing;
    }
    const vector leaves = point_query_of(w, of_bodies[row].kind, which, point, in_body);
    value found = {.count = 3, .of = of_bodies[row].unit};
    memcpy(found.parts, leaves.at, sizeof leaves.at);
    return found;
}

/* power, energy, loss and work of EFFECT, in the scene alone: there all that it does is known. */
static bool find_account(effect_scope *w, const formula *f, value *found)
{
    enum { POWER, ENERGY, LOSS, WORK, WORDS };
    static const char *const words[WORDS] = {"power", "energy", "loss", "work"};
    const char *called = f->parts[0]->name;
    size_t word = POWER;
    while (word < WORDS && strcmp(f->name, words[word]) != 0) {
        word++;
    }
    *found = nothing;
    if (word < WORDS && !w->is_done) {
        source_problem(w->b->s, f->at, "the %s of '%s' is for outputs only", f->name, called);
        return true;
    }
    for (size_t i = 0; i < w->b->written->effects.count && word < WORDS; i++) {
        const instance *in = &w->all[i];
        if (in->use->name.text != NULL && strcmp(in->use->name.text, called) == 0) {
            const node all[WORDS] = {in->account->power, in->account->stored, in->account->loss, in->account->work};
            *found = (value){.count = in->kind != NULL, .parts = {all[word]}, .of = word == ENERGY ? joule : watt};
            return true;
        }
    }
    if (word < WORDS) {
        source_problem(w->b->s, f->at, "no effect is called '%s'%s", called,
                       suggest_effect(w->b->s, w->b->written, called));
    }
    return word < WORDS;
}

/* The body that the joint of a segment carries: its own segments lead from that body's to the parent's. */
static int child_of(const mechanism *m, int at)
{
    int found = -1;
    for (int child = 0; child < m->bodies.count; child++) {
        const member *of = &m->bodies.members[child];
        const int stop = of->parent == GROUND ? GROUND : m->bodies.frames[of->parent].segment;
        for (int i = m->bodies.frames[child].segment; m->bodies.frames[child].placed && i != stop;
             i = m->segments[i].parent) {
            found = i == at ? child : found;
        }
    }
    return found;
}

/* force of JOINT, moment of CLOSURE and the like: a fixed joint, which is no operand of an effect, is one of the scene. */
static value reaction_value(effect_scope *w, const formula *f)
{
    builder *b = w->b;
    const name called = {f->parts[0]->name, f->parts[0]->at};
    const bool is_force = strcmp(f->name, "force") == 0;
    int child = -1, loop = -1;
    if (w->within == NULL) {
        find_connection(b, called, &child, &loop);
    } else {
        const int l = segment_of(w, called);
        child = l < 0 ? -1 : child_of(&b->mechanism, l);
    }
    if (f->axes.text != NULL) {
        source_problem(b->s, f->axes.at, "a %s of a joint is in the axes of the ground", f->name);
    }
    if (loop < 0 && (child < 0 || !b->mechanism.bodies.frames[child].placed)) {
        return nothing;
    }
    const vector zero = vector_zero(b->g);
    const vector leaves = leaves_of(w, (point_query){is_force ? QUERY_FORCE : QUERY_MOMENT, child, zero, false, loop});
    value found = {.count = 3, .of = is_force ? newton : newton_metre};
    memcpy(found.parts, leaves.at, sizeof leaves.at);
    return found;
}

value quantity_value(void *context, const formula *f)
{
    effect_scope *w = context;
    if (strcmp(f->name, "force") == 0 || strcmp(f->name, "moment") == 0) {
        return reaction_value(w, f);
    }
    value account;
    if (find_account(w, f, &account)) {
        return account;
    }
    graph *g = w->b->g;
    const mechanism *m = &w->b->mechanism;
    int which;
    vector point;
    if (find_point(w, f->parts[0]->name, &which, &point)) {
        return strcmp(f->name, "inertia") == 0 ? inertia_of_point(w, f, which, point) : point_value(w, f, which, point);
    }
    if (f->count > 1) {
        source_problem(w->b->s, f->parts[1]->at, "'%s' is no body: only the inertia of a body is at a point",
                       f->parts[0]->name);
        return nothing;
    }
    const int i = segment_of(w, (name){f->parts[0]->name, f->parts[0]->at});
    if (i < 0) {
        return nothing;
    }
    const segment *l = &m->segments[i];
    if (strcmp(f->name, "inertia") == 0) {
        static const dimension turning = {1, 2, 0, 0, 0, 0, 0};
        return (value){
            .count = 1, .parts = {leaf(g, OP_INERTIA, l->dof)}, .of = l->kind == JOINT_REVOLUTE ? turning : kilogram};
    }
    if (strcmp(f->name, "acceleration") == 0) {
        value found = {.count = 1, .of = quantity_dimension("speed", l)};
        dimension_times(&found.of, second, -1);
        found.parts[0] = leaf(g, OP_DERIVATIVE, m->position_count + l->dof);
        return found;
    }
    if (strcmp(f->name, "position") != 0 && strcmp(f->name, "speed") != 0) {
        source_problem(w->b->s, f->at, "a joint has no %s: its position, speed, acceleration, inertia, force or moment",
                       f->name);
        return nothing;
    }
    const bool is_speed = strcmp(f->name, "speed") == 0;
    value found = {.count = 1, .of = quantity_dimension(f->name, l)};
    found.parts[0] = leaf(g, OP_STATE, is_speed ? m->position_count + l->dof : l->position);
    return found;
}
